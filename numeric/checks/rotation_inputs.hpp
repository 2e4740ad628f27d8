// Rotations to try kernels at, by name, and the rotation nearest to a rounded one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "numeric/checks/family_check.hpp"

namespace sh::numeric {

// Unit quaternions (w, x, y, z): identity; quarter, third and half turns; half turns about horizontal and other axes;
// turns by 1e-300 to 0.1; tilts of z by 1e-300 to pi - 1e-300 between random turns about z; random ones.
std::vector<NamedInput> quaternion_inputs();

// The same as matrices (3x3, row by row).
std::vector<NamedInput> matrix_inputs();

// cos, sin of angles: multiples of 15 degrees, tiny ones, random ones.
std::vector<NamedInput> turn_inputs();

// r (3x3) = the matrix that turns v into q v q^-1, |q| = 1.
template <class Real>
void matrix_of_quaternion(const Real* q, Real* r) {
  const Real &w = q[0], &x = q[1], &y = q[2], &z = q[3];
  const std::array<Real, 9> all = {
      w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
      2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
      2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  std::copy(all.begin(), all.end(), r);
}

// out (n) = in (n) / |in|.
template <class Real>
void scale_to_unit(std::size_t n, const Real* in, Real* out) {
  using std::sqrt;
  Real sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += in[i] * in[i];
  const Real norm = sqrt(sum);
  for (std::size_t i = 0; i < n; ++i) out[i] = in[i] / norm;
}

// out (3x3) = the rotation nearest to `in`, which is one up to rounding. Newton's iteration for the orthogonal polar
// factor, X -> (X + X^-T) / 2 (Higham, SIAM J. Sci. Stat. Comput. 7, 1986, 1160): four steps take an error of 1e-7
// below 1e-100. For a rotation X^-T is nearly the matrix of cofactors divided by the determinant.
template <class Real>
void nearest_rotation(const Real* in, Real* out) {
  std::array<Real, 9> x;
  std::copy_n(in, 9, x.begin());
  constexpr int kSteps = 4;
  for (int step = 0; step < kSteps; ++step) {
    std::array<Real, 9> cofactor;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        cofactor[3 * i + k] = x[3 * i1 + k1] * x[3 * i2 + k2] - x[3 * i1 + k2] * x[3 * i2 + k1];
      }
    }
    const Real determinant = x[0] * cofactor[0] + x[1] * cofactor[1] + x[2] * cofactor[2];
    for (std::size_t i = 0; i < 9; ++i) x[i] = (x[i] + cofactor[i] / determinant) / 2;
  }
  std::copy(x.begin(), x.end(), out);
}

}  // namespace sh::numeric
