// Rotations of space as 3x3 matrices and quaternions in any Real: from a quaternion and back, from turns, repaired.
//
// Matrices are row by row, s' = R s; quaternions (w, x, y, z) of length 1 turn v into q v q^-1. Angles are in radians,
// right-handed. Nothing here takes the sine of an angle from its cosine, so turns of any size keep their digits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sh::numeric {

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

// q (4) = a unit quaternion of the rotation r (3x3), from the largest of its four components, so that nothing cancels
// (Shepperd, J. Guidance and Control 1, 1978, 223). Error: that of r. Its sign is that of the largest component.
template <class Real>
void quaternion_of_matrix(const Real* r, Real* q) {
  using std::sqrt;
  const std::array<Real, 4> squares = {1 + r[0] + r[4] + r[8], 1 + r[0] - r[4] - r[8], 1 - r[0] + r[4] - r[8],
                                       1 - r[0] - r[4] + r[8]};  // 4 w^2, 4 x^2, 4 y^2, 4 z^2
  const auto k = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const Real wx = r[7] - r[5], wy = r[2] - r[6], wz = r[3] - r[1];  // 4 times the products of components
  const Real xy = r[1] + r[3], xz = r[2] + r[6], yz = r[5] + r[7];
  const std::array<std::array<Real, 4>, 4> products = {
      {{squares[0], wx, wy, wz}, {wx, squares[1], xy, xz}, {wy, xy, squares[2], yz}, {wz, xz, yz, squares[3]}}};
  const Real scale = 2 * sqrt(squares[k]);
  for (std::size_t i = 0; i < 4; ++i) q[i] = products[k][i] / scale;
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

// The same for a matrix that was rounded to another type: the rotation in Wide nearest to the rounded entries.
template <class Wide, class Real>
std::array<Wide, 9> nearest_rotation(const Real* rounded) {
  std::array<Wide, 9> r;
  for (std::size_t i = 0; i < 9; ++i) r[i] = static_cast<Wide>(rounded[i]);
  nearest_rotation(r.data(), r.data());
  return r;
}

// a b (3x3 each).
template <class Real>
std::array<Real, 9> matrix_product(const std::array<Real, 9>& a, const std::array<Real, 9>& b) {
  std::array<Real, 9> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return c;
}

// The turn by `angle` about (x, y, z), which has length 1.
template <class Real>
std::array<Real, 9> axis_turn(const Real& x, const Real& y, const Real& z, const Real& angle) {
  using std::cos;
  using std::sin;
  const Real half = sin(angle / 2);
  const std::array<Real, 4> q = {cos(angle / 2), half * x, half * y, half * z};
  std::array<Real, 9> r;
  matrix_of_quaternion(q.data(), r.data());
  return r;
}

template <class Number>
Number determinant(const std::array<Number, 9>& r) {
  return r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) + r[2] * (r[3] * r[7] - r[4] * r[6]);
}

// The largest entry of |R R^T - 1|.
template <class Number>
Number orthogonality_defect(const std::array<Number, 9>& r) {
  Number largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Number sum = i == k ? -1 : 0;
      for (std::size_t j = 0; j < 3; ++j) sum += r[3 * i + j] * r[3 * k + j];
      if (sum < 0) sum = -sum;
      largest = std::max(largest, sum);
    }
  }
  return largest;
}

// Rz(alpha) Ry(tilt) Rz(gamma) from the three cosines and sines.
template <class Real>
std::array<Real, 9> tilted_turn(const Real& ca, const Real& sa, const Real& cb, const Real& sb, const Real& cg,
                                const Real& sg) {
  return {ca * cb * cg - sa * sg,
          -ca * cb * sg - sa * cg,
          ca * sb,
          sa * cb * cg + ca * sg,
          -sa * cb * sg + ca * cg,
          sa * sb,
          -sb * cg,
          sb * sg,
          cb};
}

// Rz(alpha) Ry(tilt) Rz(gamma).
template <class Real>
std::array<Real, 9> tilted_turn(const Real& alpha, const Real& tilt, const Real& gamma) {
  using std::cos;
  using std::sin;
  return tilted_turn<Real>(cos(alpha), sin(alpha), cos(tilt), sin(tilt), cos(gamma), sin(gamma));
}

}  // namespace sh::numeric
