// The generated basis kernels behind a degree chosen at run time, and loops over bands.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "generated/cpp/basis.hpp"
#include "prt/at_degree.hpp"

namespace sh::prt {

/// An array that is large enough for the basis of any degree.
using BasisValues = std::array<double, std::size_t{kMaxDegree + 1} * (kMaxDegree + 1)>;

/// The index of c_lm among the coefficients.
constexpr std::size_t coefficient_index(int l, int m) {
  const int i = l * l + l + m;
  return static_cast<std::size_t>(i);
}

/// out (bands^2) = Y_lm(direction), l = 0..degree; |direction| = 1, 0 <= degree <= kMaxDegree.
template <class T>
void evaluate_basis(int degree, T x, T y, T z, T* out) {
  at_degree(degree, [&](auto known) { sh::basis<known()>(x, y, z, out); });
}

/// c_lm *= factors_l for as many bands as there are factors.
inline void scale_bands(const std::vector<double>& factors, double* c) {
  for (std::size_t l = 0, i = 0; l < factors.size(); ++l) {
    for (; i < (l + 1) * (l + 1); ++i) c[i] *= factors[l];
  }
}

}  // namespace sh::prt
