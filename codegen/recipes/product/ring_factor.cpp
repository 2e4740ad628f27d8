#include "codegen/recipes/product/ring_factor.hpp"

#include <algorithm>

namespace sh::codegen::recipes {

Factor times(Factor factor, const ExactReal& scale) {
  for (ExactReal& element : factor) element = multiply(element, scale);
  return factor;
}

Factor times(Factor factor, const Factor& other) {
  for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = multiply(factor[i], other[i]);
  return factor;
}

Factor quotient(Factor factor, const Factor& divisor) {
  for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = multiply(factor[i], reciprocal(divisor[i]));
  return factor;
}

double smallest_size(const Factor& factor) {
  double smallest = approximate(factor.front());
  for (const ExactReal& element : factor) smallest = std::min(smallest, approximate(element));
  return smallest;
}

template <class Of>
Factor RingFactors::of_rings(int ring, const Of& of) const {
  const bool all = looped_ && ring < quadrature_.rings().pairs;
  Factor factor;
  for (int r = ring; r < (all ? quadrature_.rings().pairs : ring + 1); ++r) factor.push_back(of(r));
  return factor;
}

Factor RingFactors::one(int ring) const {
  return of_rings(ring, [](int /*ring*/) { return ExactReal(symbolic::Surd(1)); });
}

Factor RingFactors::theta(int l, int m, int ring) const {
  return of_rings(ring, [&](int r) { return quadrature_.theta(l, m, r); });
}

Factor RingFactors::weight(int ring) const {
  return of_rings(ring, [&](int r) { return quadrature_.weight(r); });
}

Value RingFactors::scaled(SignedBuilder& build, const Factor& factor, Value value) {
  if (value.is_zero() || factor.size() == 1) return build.times(factor[0], value);
  std::string key;
  for (const ExactReal& element : factor) key += to_string(element) + ";";
  const auto [column, added] = columns_.try_emplace(key, static_cast<int>(columns_.size()));
  kernel_.table.resize(factor.size());
  for (std::size_t row = 0; added && row < factor.size(); ++row) kernel_.table[row].push_back(factor[row]);
  return build.times(Value{build.table(column->second)}, value);
}

}  // namespace sh::codegen::recipes
