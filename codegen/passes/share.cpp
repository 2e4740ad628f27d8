// Passes: `share` computes equal expressions once (value numbering; addition and multiplication commute); `fold` also
// simplifies.
#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {
namespace {

using Key = std::tuple<Op, std::array<NodeId, 4>, int, int, ExactReal>;

Key key_of(const Node& node) {
  std::array<NodeId, 4> args = node.args;
  const bool commutes = node.op == Op::kAdd || node.op == Op::kMul || node.op == Op::kFma;
  if (commutes && args[0] > args[1]) std::swap(args[0], args[1]);
  return {node.op, args, node.input, node.stride, node.constant};
}

// Appends every distinct node once.
class Sharer {
 public:
  explicit Sharer(Kernel& kernel) : kernel_(kernel) {}

  NodeId append(Node node) { return known(std::move(node)); }

  // Appends the node in its simplest form.
  NodeId append_folded(Node node) {
    switch (node.op) {
      case Op::kNeg:
        return negation(std::move(node));
      case Op::kAdd:
        return sum(std::move(node));
      case Op::kSub:
        return difference(std::move(node));
      case Op::kMul:
        return product(std::move(node));
      default:
        return known(std::move(node));
    }
  }

 private:
  NodeId known(Node node) {
    const auto [found, inserted] = known_.try_emplace(key_of(node), kernel_.size());
    if (inserted) {
      kernel_.nodes.push_back(std::move(node));
    } else if (Node& first = kernel_.nodes[found->second]; first.name.empty()) {
      first.name = node.name;
    }
    return found->second;
  }

  NodeId constant(const ExactReal& value, const std::string& name) {
    return known({Op::kConstant, {-1, -1, -1, -1}, -1, value, name});
  }

  [[nodiscard]] const ExactReal* constant_at(NodeId id) const {
    const Node& node = kernel_.node(id);
    return node.op == Op::kConstant ? &node.constant : nullptr;
  }

  [[nodiscard]] bool is_zero_at(NodeId id) const {
    const ExactReal* value = constant_at(id);
    return value != nullptr && is_zero(*value);
  }

  [[nodiscard]] bool is_rational_at(NodeId id, int value) const {
    const ExactReal* found = constant_at(id);
    return found != nullptr && as_rational(*found) == cln::cl_RA(value);
  }

  // The operand of a negation, or nothing.
  [[nodiscard]] std::optional<NodeId> negated(NodeId id) const {
    const Node& node = kernel_.node(id);
    return node.op == Op::kNeg ? std::optional(node.args[0]) : std::nullopt;
  }

  NodeId negation(Node node) {
    if (const auto inner = negated(node.args[0])) return *inner;
    if (const ExactReal* value = constant_at(node.args[0])) return constant(negate(*value), node.name);
    return known(std::move(node));
  }

  NodeId sum(Node node) {
    const auto [a, b] = std::pair(node.args[0], node.args[1]);
    if (is_zero_at(a)) return b;
    if (is_zero_at(b)) return a;
    if (const ExactReal* left = constant_at(a), *right = constant_at(b); left != nullptr && right != nullptr) {
      if (const auto value = add(*left, *right)) return constant(*value, node.name);
    }
    if (const auto inner = negated(b)) return difference({Op::kSub, {a, *inner, -1, -1}, -1, {}, node.name});
    if (const auto inner = negated(a)) return difference({Op::kSub, {b, *inner, -1, -1}, -1, {}, node.name});
    return known(std::move(node));
  }

  NodeId difference(Node node) {
    const auto [a, b] = std::pair(node.args[0], node.args[1]);
    if (is_zero_at(b)) return a;
    if (a == b) return constant(symbolic::Surd(), node.name);
    if (is_zero_at(a)) return negation({Op::kNeg, {b, -1, -1, -1}, -1, {}, node.name});
    if (const ExactReal* left = constant_at(a), *right = constant_at(b); left != nullptr && right != nullptr) {
      if (const auto value = add(*left, negate(*right))) return constant(*value, node.name);
    }
    if (const auto inner = negated(b)) return sum({Op::kAdd, {a, *inner, -1, -1}, -1, {}, node.name});
    return known(std::move(node));
  }

  NodeId product(Node node) {
    const auto [a, b] = std::pair(node.args[0], node.args[1]);
    for (const auto& [k, v] : {std::pair(a, b), std::pair(b, a)}) {
      if (is_zero_at(k)) return k;
      if (is_rational_at(k, 1)) return v;
      if (is_rational_at(k, -1)) return negation({Op::kNeg, {v, -1, -1, -1}, -1, {}, node.name});
    }
    if (const ExactReal* left = constant_at(a), *right = constant_at(b); left != nullptr && right != nullptr) {
      return constant(multiply(*left, *right), node.name);
    }
    return known(std::move(node));
  }

  Kernel& kernel_;
  std::map<Key, NodeId> known_;
};

template <class Append>
Kernel rebuilt(const Kernel& kernel, const Append& append) {
  Kernel result = kernel;
  result.nodes.clear();
  Sharer sharer(result);
  std::vector<NodeId> position;
  for (const Node& original : kernel.nodes) {
    position.push_back(append(sharer, moved(original, position)));
  }
  for (Output& output : result.outputs) output.node = position[output.node];
  return result;
}

}  // namespace

Kernel share(const Kernel& kernel) {
  return rebuilt(kernel, [](Sharer& sharer, Node node) { return sharer.append(std::move(node)); });
}

Kernel fold(const Kernel& kernel) {
  return rebuilt(kernel, [](Sharer& sharer, Node node) { return sharer.append_folded(std::move(node)); });
}

}  // namespace sh::codegen::passes
