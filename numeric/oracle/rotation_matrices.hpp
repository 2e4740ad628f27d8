// Rotations of space as 3x3 matrices and quaternions in any Real: from a quaternion and back, from turns, repaired.
//
// Matrices are row by row, s' = R s; quaternions (w, x, y, z) of length 1 turn v into q v q^-1. Angles are in radians,
// right-handed. Nothing here takes the sine of an angle from its cosine, so turns of any size keep their digits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace sh::numeric {

/// r (3x3) = the matrix that turns v into q v q^-1, |q| = 1.
template <class Real>
void matrix_of_quaternion(const Real* q, Real* r) {
  const Real &w = q[0], &x = q[1], &y = q[2], &z = q[3];
  const std::array<Real, 9> all = {
      w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
      2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
      2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  std::copy(all.begin(), all.end(), r);
}

/// A multiple of a unit quaternion of the rotation r (3x3): 4 times its largest component, so that nothing cancels
/// (Shepperd, J. Guidance and Control 1, 1978, 223).
template <class Number>
std::array<Number, 4> quaternion_multiple(const Number* r) {
  const Number wx = r[7] - r[5], wy = r[2] - r[6], wz = r[3] - r[1];  // 4 times the products of components
  const Number xy = r[1] + r[3], xz = r[2] + r[6], yz = r[5] + r[7];
  const std::array<std::array<Number, 4>, 4> products = {{{1 + r[0] + r[4] + r[8], wx, wy, wz},
                                                          {wx, 1 + r[0] - r[4] - r[8], xy, xz},
                                                          {wy, xy, 1 - r[0] + r[4] - r[8], yz},
                                                          {wz, xz, yz, 1 - r[0] - r[4] + r[8]}}};
  int k = 0;
  for (int i = 1; i < 4; ++i) {
    if (products[i][i] > products[k][k]) k = i;
  }
  return products[k];
}

/// q (4) = a unit quaternion of the rotation r (3x3). Error: that of r. Its sign is that of the largest component.
template <class Real>
void quaternion_of_matrix(const Real* r, Real* q) {
  using std::sqrt;
  const auto multiple = quaternion_multiple(r);
  const Real length = 2 * sqrt(*std::max_element(multiple.begin(), multiple.end()));
  for (int i = 0; i < 4; ++i) q[i] = multiple[i] / length;
}

/// out (3x3) = the rotation nearest to `in`, by Newton's iteration for the orthogonal polar factor, X -> (X + X^-T) / 2
/// (Higham, SIAM J. Sci. Stat. Comput. 7, 1986, 1160). X^-T is the matrix of cofactors divided by the determinant. Each
/// step squares the error: four take one of 1e-7 below 1e-100.
template <class Real>
void nearest_rotation(const Real* in, Real* out, int steps = 4) {
  std::array<Real, 9> x;
  std::copy_n(in, 9, x.begin());
  for (int step = 0; step < steps; ++step) {
    std::array<Real, 9> cofactor;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        cofactor[3 * i + k] = x[3 * i1 + k1] * x[3 * i2 + k2] - x[3 * i1 + k2] * x[3 * i2 + k1];
      }
    }
    const Real determinant = x[0] * cofactor[0] + x[1] * cofactor[1] + x[2] * cofactor[2];
    for (int i = 0; i < 9; ++i) x[i] = (x[i] + cofactor[i] / determinant) / 2;
  }
  std::copy(x.begin(), x.end(), out);
}

/// The same for a matrix that was rounded to another type: the rotation in Wide nearest to the rounded entries.
template <class Wide, class Real>
std::array<Wide, 9> nearest_rotation(const Real* rounded) {
  std::array<Wide, 9> r;
  for (int i = 0; i < 9; ++i) r[i] = static_cast<Wide>(rounded[i]);
  nearest_rotation(r.data(), r.data());
  return r;
}

/// a b (3x3 each).
template <class Real>
std::array<Real, 9> matrix_product(const std::array<Real, 9>& a, const std::array<Real, 9>& b) {
  std::array<Real, 9> c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  }
  return c;
}

/// The turn by `angle` about (x, y, z), which has length 1.
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

/// The largest entry of |R R^T - 1|.
template <class Number>
Number orthogonality_defect(const std::array<Number, 9>& r) {
  Number largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      Number sum = i == k ? -1 : 0;
      for (int j = 0; j < 3; ++j) sum += r[3 * i + j] * r[3 * k + j];
      largest = std::max(largest, sum < 0 ? Number(-sum) : sum);
    }
  }
  return largest;
}

/// Rz(alpha) Ry(tilt) Rz(gamma) from the three cosines and sines.
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

/// Rz(alpha) Ry(tilt) Rz(gamma).
template <class Real>
std::array<Real, 9> tilted_turn(const Real& alpha, const Real& tilt, const Real& gamma) {
  using std::cos;
  using std::sin;
  return tilted_turn<Real>(cos(alpha), sin(alpha), cos(tilt), sin(tilt), cos(gamma), sin(gamma));
}

}  // namespace sh::numeric
