// The generated basis kernels behind a degree chosen at run time.
#pragma once
#include "generated/cpp/basis.hpp"
#include "prt/at_degree.hpp"

namespace sh::prt {

/// out (bands^2) = Y_lm(direction), l = 0..degree; |direction| = 1, 0 <= degree <= kMaxDegree.
template <class T>
void evaluate_basis(int degree, T x, T y, T z, T* out) {
  at_degree(degree, [&](auto known) { sh::basis<known()>(x, y, z, out); });
}

}  // namespace sh::prt
