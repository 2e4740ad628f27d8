#include "codegen/recipes/signed_builder.hpp"

#include <algorithm>

namespace sh::codegen {
namespace {

bool is_unit(const ExactReal& factor) {
  const auto rational = as_rational(factor);
  return rational && cln::abs(*rational) == 1;
}

}  // namespace

std::vector<Value> SignedBuilder::inputs(int first, int count) {
  std::vector<Value> values;
  for (int i = first; i < first + count; ++i) values.push_back({input(i, {})});
  return values;
}

Value SignedBuilder::times(Value a, Value b) {
  if (a.is_zero() || b.is_zero()) return {};
  return {mul(a.node, b.node), a.negative != b.negative};
}

Value SignedBuilder::times(const ExactReal& factor, Value a) {
  if (a.is_zero() || codegen::is_zero(factor)) return {};
  const bool negative = a.negative != is_negative(factor);
  if (is_unit(factor)) return {a.node, negative};
  const Value k = fixed(factor);
  return {mul(k.node, a.node), negative};
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
  if (a.negative == b.negative) return {add(a.node, b.node), a.negative};
  return a.negative ? Value{sub(b.node, a.node)} : Value{sub(a.node, b.node)};
}

Value SignedBuilder::sum(const std::vector<Value>& terms, const std::string& name) {
  const auto first = std::find_if(terms.begin(), terms.end(), [](Value v) { return !v.is_zero() && !v.negative; });
  Value total = first == terms.end() ? Value{} : *first;
  for (auto term = terms.begin(); term != terms.end(); ++term) {
    if (term != first) total = plus(total, *term);
  }
  return name.empty() || terms.size() < 2 ? total : named(total, name);
}

Value SignedBuilder::balanced_sum(const std::vector<Value>& terms) {
  if (terms.size() <= 2) return sum(terms);
  const auto middle = terms.begin() + terms.size() / 2;
  const Value first = balanced_sum({terms.begin(), middle});
  const Value second = balanced_sum({middle, terms.end()});
  return plus(first, second);
}

Value SignedBuilder::fixed(const ExactReal& exact, const std::string& name) {
  const bool negative = is_negative(exact);
  return {constant(negative ? negate(exact) : exact, name), negative};
}

Value SignedBuilder::named(Value a, std::string name) {
  if (!a.is_zero()) this->name(a.node, std::move(name));
  return a;
}

NodeId SignedBuilder::node(Value a) {
  if (a.is_zero()) return constant(symbolic::Surd());
  return a.negative ? neg(a.node) : a.node;
}

}  // namespace sh::codegen
