// Rescales the inputs and outputs of a kernel by exact factors.
//
// The new kernel holds every value v as g v, with a factor g that is called the gauge of v. The caller gives the gauges
// of inputs and outputs. A product has the product of the gauges of its factors. Both terms of a sum need the same
// gauge. A multiplication by a constant may have any gauge, because the constant changes with it. One pass over the
// kernel finds all gauges. Where constants leave no freedom, it adds one multiplication (or a change of sign).
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "codegen/convention/in_convention.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

// A gauge that is not yet decided: a known factor times powers of unknown factors.
struct Gauge {
  Surd known = Surd(1);
  std::map<int, int> unknown;  // number of the unknown -> power, which is not zero
};

Gauge power_of(const Gauge& a, int n) {
  Gauge result;
  const Surd base = n < 0 ? a.known.inverse() : a.known;
  for (int i = 0; i < (n < 0 ? -n : n); ++i) result.known = result.known * base;
  for (const auto& [variable, power] : a.unknown) result.unknown[variable] = power * n;
  return result;
}

Gauge product(const Gauge& a, const Gauge& b) {
  Gauge result{a.known * b.known, a.unknown};
  for (const auto& [variable, power] : b.unknown) {
    if ((result.unknown[variable] += power) == 0) result.unknown.erase(variable);
  }
  return result;
}

// One multiplication by a constant. Its factor is a new unknown.
struct Rescaled {
  NodeId node = -1;      // in the new kernel
  NodeId argument = -1;  // the multiplied value, in the new kernel; -1: the constant itself is the value
  ExactReal constant;    // the constant of the old kernel
};

class GaugeSolver {
 public:
  GaugeSolver(const Kernel& kernel, const std::vector<Surd>& inputs, const std::vector<Surd>& outputs)
      : kernel_(kernel), result_(kernel), build_(result_) {
    result_.nodes.clear();
    for (NodeId id = 0; id < kernel.size(); ++id) position_.push_back(rebuilt(kernel.node(id), inputs));
    for (std::size_t i = 0; i < kernel.outputs.size(); ++i) {
      const NodeId value = value_of(kernel.outputs[i].node);
      result_.outputs[i].node = with_gauge(value, Gauge{outputs[kernel.element(i)], {}});
    }
  }

  Kernel solved() {
    for (const Rescaled& r : rescaled_) {
      const Surd after = value(gauge(r.node));
      const Surd before = r.argument < 0 ? Surd(1) : value(gauge(r.argument));
      const NodeId place = r.argument < 0 ? r.node : result_.node(r.node).args[0];
      result_.nodes[place].constant = multiply(r.constant, after / before);
    }
    return passes::prune(passes::fold(result_));
  }

 private:
  // Appends a gauge for every appended node.
  NodeId keep(NodeId id, Gauge gauge) {
    gauges_.resize(static_cast<std::size_t>(id) + 1);
    gauges_[id] = std::move(gauge);
    return id;
  }

  Gauge gauge(NodeId id) { return resolved(gauges_[id]); }

  Gauge fresh() { return {Surd(1), {{unknowns_++, 1}}}; }

  // The gauge after all decided unknowns are inserted.
  [[nodiscard]] Gauge resolved(const Gauge& g) const {
    Gauge result{g.known, {}};
    for (const auto& [variable, power] : g.unknown) {
      const auto found = solution_.find(variable);
      const Gauge one = found == solution_.end() ? Gauge{Surd(1), {{variable, 1}}} : resolved(found->second);
      result = product(result, power_of(one, power));
    }
    return result;
  }

  // Undecided unknowns are 1.
  static Surd value(const Gauge& g) { return g.known; }

  // A new value for the constant k, because every use has its own gauge.
  NodeId value_of(NodeId old) {
    const Node& node = kernel_.node(old);
    if (node.op != Op::kConstant) return position_[old];
    const NodeId id = build_.constant(node.constant, node.name);
    if (is_zero(node.constant)) return keep(id, Gauge{});
    rescaled_.push_back({id, -1, node.constant});
    return keep(id, fresh());
  }

  // k times a value of the new kernel. The name may be that of a node of this kernel, which moves as nodes are added.
  NodeId times_constant(const ExactReal& k, const std::string& k_name, NodeId argument, std::string name) {
    const NodeId constant = keep(build_.constant(k, k_name), Gauge{});
    const NodeId id = build_.mul(constant, argument, std::move(name));
    rescaled_.push_back({id, argument, k});
    return keep(id, fresh());
  }

  // Makes a gauge equal to another by deciding an unknown; false if no unknown is left.
  bool equate(const Gauge& a, const Gauge& b) {
    const Gauge ratio = resolved(product(a, power_of(b, -1)));
    // The latest unknown is the closest to the outputs.
    for (auto it = ratio.unknown.rbegin(); it != ratio.unknown.rend(); ++it) {
      if (it->second != 1 && it->second != -1) continue;
      Gauge rest = ratio;
      rest.unknown.erase(it->first);
      solution_[it->first] = power_of(rest, -it->second);
      return true;
    }
    return ratio.unknown.empty() && ratio.known == Surd(1);
  }

  // The value in the wanted gauge: the node itself, or one multiplication.
  NodeId with_gauge(NodeId id, const Gauge& wanted) {
    if (equate(gauge(id), wanted)) return id;
    const NodeId scaled = times_constant(Surd(1), "", id, result_.node(id).name);
    equate(gauge(scaled), wanted);
    return scaled;
  }

  NodeId rebuilt(const Node& node, const std::vector<Surd>& inputs) {
    const auto arg = [&](std::size_t i) { return value_of(node.args[i]); };
    switch (node.op) {
      case Op::kInput:
        return keep(build_.input(node.input, node.name, node.stride), {inputs[node.input], {}});
      case Op::kConstant:
        return keep(build_.constant(node.constant, node.name), Gauge{});  // every use appends its own constant
      case Op::kNeg: {
        const NodeId a = arg(0);
        return keep(build_.neg(a, node.name), gauge(a));
      }
      case Op::kAdd:
      case Op::kSub: {
        const NodeId a = arg(0);
        const NodeId b = with_gauge(arg(1), gauge(a));
        return keep(node.op == Op::kAdd ? build_.add(a, b, node.name) : build_.sub(a, b, node.name), gauge(a));
      }
      case Op::kMul:
        return rebuilt_product(node);
      case Op::kDiv: {
        const NodeId a = arg(0);
        const NodeId b = arg(1);
        return keep(build_.div(a, b, node.name), product(gauge(a), power_of(gauge(b), -1)));
      }
      case Op::kSqrt: {
        const NodeId a = with_gauge(arg(0), Gauge{});
        return keep(build_.sqrt(a, node.name), Gauge{});
      }
      case Op::kSelect: {
        const NodeId a = with_gauge(arg(0), Gauge{});
        const NodeId b = with_gauge(arg(1), Gauge{});
        const NodeId then = arg(2);
        const NodeId otherwise = with_gauge(arg(3), gauge(then));
        return keep(build_.select(a, b, then, otherwise, node.name), gauge(then));
      }
      case Op::kTable:
        return keep(build_.table(node.input), Gauge{});
      case Op::kRowSum: {
        const NodeId a = arg(0);
        return keep(build_.row_sum(a, node.name), gauge(a));
      }
      case Op::kFma:
        break;
    }
    throw std::invalid_argument(kernel_.name + ": " + op_name(node.op) + " cannot be rescaled");
  }

  NodeId rebuilt_product(const Node& node) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const Node& k = kernel_.node(node.args[i]);
      if (k.op == Op::kConstant) return times_constant(k.constant, k.name, value_of(node.args[1 - i]), node.name);
    }
    const NodeId a = value_of(node.args[0]);
    const NodeId b = value_of(node.args[1]);
    return keep(build_.mul(a, b, node.name), product(gauge(a), gauge(b)));
  }

  const Kernel& kernel_;
  Kernel result_;
  Builder build_;
  std::vector<NodeId> position_;  // old node -> node of the new kernel
  std::vector<Gauge> gauges_;     // gauges of the nodes of the new kernel
  std::vector<Rescaled> rescaled_;
  std::map<int, Gauge> solution_;
  int unknowns_ = 0;
};

}  // namespace

Kernel with_gauges(const Kernel& kernel, const std::vector<Surd>& inputs, const std::vector<Surd>& outputs) {
  return GaugeSolver(kernel, inputs, outputs).solved();
}

}  // namespace sh::codegen
