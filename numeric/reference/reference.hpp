// A reference value of one spherical harmonic, or its gradient, in decimal, with as many correct digits as asked for.
//
// Input: degree, order, a direction of any length as three decimals taken exactly, digits. Output: the value in
// scientific notation. Conventions: README.md.
#pragma once

#include <array>
#include <string>

namespace sh::numeric {

constexpr int kMaxReferenceDegree = 10000;

// Y_(degree, order) at direction / |direction|, rounded to `digits` significant decimals, such as "-3.14e-01"; "0"
// where it is exactly zero. How: correct_digits.hpp. A value is taken for zero when the polynomial vanishes modulo four
// primes near 2^31; were it not zero, the odds against that are above 10^20. A component is
// [+-]digits[.digits][e[+-]digits]. Throws std::invalid_argument, one line, for a malformed component, the zero vector,
// |order| > degree, and for a degree or digits out of range.
std::string reference_value(int degree, int order, const std::array<std::string, 3>& direction, int digits);

// d/dx, d/dy, d/dz of the homogeneous form r^l Y_lm(d / r) at direction / |direction|, each as reference_value.
std::array<std::string, 3> reference_gradient(int degree, int order, const std::array<std::string, 3>& direction,
                                              int digits);

}  // namespace sh::numeric
