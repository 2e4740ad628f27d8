#include "codegen/recipes/signed_sum.hpp"

#include <algorithm>

namespace sh::codegen::recipes {

using symbolic::Surd;

Signed scaled(Builder& build, const Surd& factor, Signed value, const std::string& name) {
  const bool negative = factor.is_negative();
  const Surd size = negative ? -factor : factor;
  if (negative) value = -value;
  if (size == Surd(1)) return value;
  const NodeId constant = build.constant(size);
  return {build.mul(constant, value.node, name), value.negative};
}

Signed product(Builder& build, Signed a, Signed b) { return {build.mul(a.node, b.node), a.negative != b.negative}; }

Signed sum(Builder& build, const std::vector<Signed>& values, const std::string& name) {
  const bool negative = std::all_of(values.begin(), values.end(), [](const Signed& v) { return v.negative; });
  const auto subtracted = [negative](const Signed& v) { return v.negative != negative; };
  const auto head = std::find_if_not(values.begin(), values.end(), subtracted);
  NodeId total = head->node;
  for (auto v = values.begin(); v != values.end(); ++v) {
    if (v == head) continue;
    total = subtracted(*v) ? build.sub(total, v->node) : build.add(total, v->node);
  }
  if (values.size() > 1) build.name(total, name);
  return {total, negative};
}

Signed weighted_sum(Builder& build, const std::vector<Surd>& factors, const std::vector<Signed>& values,
                    const std::string& name) {
  std::vector<Signed> terms;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (!factors[i].is_zero()) terms.push_back(scaled(build, factors[i], values[i]));
  }
  return sum(build, terms, name);
}

NodeId settled(Builder& build, Signed value) { return value.negative ? build.neg(value.node) : value.node; }

}  // namespace sh::codegen::recipes
