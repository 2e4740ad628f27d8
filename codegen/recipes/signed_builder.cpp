#include "codegen/recipes/signed_builder.hpp"

#include <algorithm>

namespace sh::codegen {

std::vector<Value> SignedBuilder::inputs(int first, int count) {
  std::vector<Value> values;
  for (int i = first; i < first + count; ++i) values.push_back(input(i));
  return values;
}

Value SignedBuilder::times(Value a, Value b) {
  if (a.is_zero() || b.is_zero()) return {};
  return {build_.mul(a.node, b.node), a.negative != b.negative};
}

Value SignedBuilder::times(const ExactReal& factor, Value a) {
  if (a.is_zero() || codegen::is_zero(factor)) return {};
  const bool negative = is_negative(factor);
  const ExactReal size = negative ? negate(factor) : factor;
  const bool flipped = a.negative != negative;
  if (as_rational(size) == cln::cl_RA(1)) return {a.node, flipped};
  const NodeId k = build_.constant(size);
  return {build_.mul(k, a.node), flipped};
}

Value SignedBuilder::times_once(const ExactReal& factor, Value a) {
  if (a.is_zero()) return {};
  const Node node = kernel_.node(a.node);
  if (node.op != Op::kMul || kernel_.node(node.args[0]).op != Op::kConstant) return times(factor, a);
  return times(multiply(factor, kernel_.node(node.args[0]).constant), {node.args[1], a.negative});
}

Value SignedBuilder::plus(Value a, Value b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.negative == b.negative) return {build_.add(a.node, b.node), a.negative};
  return a.negative ? Value{build_.sub(b.node, a.node)} : Value{build_.sub(a.node, b.node)};
}

Value SignedBuilder::sum(const std::vector<Value>& terms) {
  const auto first = std::find_if(terms.begin(), terms.end(), [](Value v) { return !v.is_zero() && !v.negative; });
  Value total = first == terms.end() ? Value{} : *first;
  for (auto term = terms.begin(); term != terms.end(); ++term) {
    if (term != first) total = plus(total, *term);
  }
  return total;
}

Value SignedBuilder::balanced_sum(const std::vector<Value>& terms) {
  if (terms.size() <= 2) return sum(terms);
  const auto middle = terms.begin() + static_cast<std::ptrdiff_t>(terms.size() / 2);
  const Value first = balanced_sum({terms.begin(), middle});
  const Value second = balanced_sum({middle, terms.end()});
  return plus(first, second);
}

Value SignedBuilder::named(Value a, std::string name) {
  if (!a.is_zero()) build_.name(a.node, std::move(name));
  return a;
}

NodeId SignedBuilder::node(Value a) {
  if (a.is_zero()) return build_.constant(symbolic::Surd());
  return a.negative ? build_.neg(a.node) : a.node;
}

}  // namespace sh::codegen
