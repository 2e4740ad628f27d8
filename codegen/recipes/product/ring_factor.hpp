// Exact constants of the rings of a quadrature, and their arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::recipes {

/// One element for a single ring; one element for each pair of rings if a loop runs over the pairs.
using Factor = std::vector<ExactReal>;

/// Arithmetic element by element.
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

/// The approximate absolute value.
inline double approximate(const ExactReal& value) { return std::abs(cln::double_approx(evaluate(value, 20))); }

/// The approximate absolute value of the smallest element.
inline double approximate(const Factor& factor) {
  double smallest = approximate(factor.front());
  for (const ExactReal& element : factor) smallest = std::min(smallest, approximate(element));
  return smallest;
}

}  // namespace sh::codegen::recipes
