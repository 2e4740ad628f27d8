// Constants of the rings of a quadrature: exact numbers, one or one for each pair of rings, with their arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::recipes {

// A constant of a ring; one for each pair of rings where a loop runs over the pairs.
using Factor = std::vector<ExactReal>;

inline Factor times(Factor factor, const ExactReal& scale) {
  for (ExactReal& element : factor) element = multiply(element, scale);
  return factor;
}

inline Factor times(Factor factor, const Factor& other) {
  for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = multiply(factor[i], other[i]);
  return factor;
}

inline Factor quotient(Factor factor, const Factor& divisor) {
  for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = multiply(factor[i], reciprocal(divisor[i]));
  return factor;
}

inline double approximate(const ExactReal& value) { return std::abs(cln::double_approx(evaluate(value, 20))); }

// The size of the smallest element.
inline double approximate(const Factor& factor) {
  double smallest = approximate(factor.front());
  for (const ExactReal& element : factor) smallest = std::min(smallest, approximate(element));
  return smallest;
}

}  // namespace sh::codegen::recipes
