// Ways to give a rotation (quaternion, axis and angle, Euler angles in any order) -> 3x3 matrix or quaternion.
//
// Everything is a polynomial in cosines and sines, so the functions work over any ring T: exact rationals (rational
// points of the unit circle), polynomials in symbols, or floating point. Conventions: column vectors, counter-clockwise
// about the axis seen from its tip, quaternions (w, x, y, z), q v q^-1. Angles are (cosine, sine) pairs; quaternions
// take the pairs of the half angles. Intrinsic orders turn about the axes of the turned body: "zyx" applies first z,
// then the new y, then the new x, R = Rz Ry Rx. Extrinsic orders turn about fixed axes: the same word is R = Rx Ry Rz
// [Diebel06]. [Green03] uses XYZ, ZYX and ZYZ.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "symbolic/number/matrix.hpp"

namespace sh::symbolic {

template <class T>
using Quaternion = std::array<T, 4>;  // w, x, y, z

template <class T>
struct CosSin {
  T cosine;
  T sine;
};

/// The twelve orders in which three axes make every rotation: six with three axes, six that return to the first.
inline constexpr std::array<std::string_view, 12> kEulerOrders{"xyz", "xzy", "yxz", "yzx", "zxy", "zyx",
                                                               "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};

enum class EulerFrame { kIntrinsic, kExtrinsic };

/// Axis number 0, 1, 2 of each letter; throws std::invalid_argument for a word that is none of kEulerOrders.
inline std::array<int, 3> euler_axes(std::string_view order) {
  std::string known;
  for (const std::string_view word : kEulerOrders) {
    if (word == order) return {order[0] - 'x', order[1] - 'x', order[2] - 'x'};
    known += " " + std::string(word);
  }
  throw std::invalid_argument("unknown Euler order '" + std::string(order) + "': expected one of:" + known);
}

/// |q|^2 R(q); the rotation itself if |q| = 1.
template <class T>
Matrix<T> matrix_from_quaternion(const Quaternion<T>& q) {
  const auto& [w, x, y, z] = q;
  const T wx = w * x + w * x;
  const T wy = w * y + w * y;
  const T wz = w * z + w * z;
  const T xy = x * y + x * y;
  const T xz = x * z + x * z;
  const T yz = y * z + y * z;
  return Matrix<T>(3, 3,
                   {w * w + x * x - y * y - z * z, xy - wz, xz + wy,  //
                    xy + wz, w * w - x * x + y * y - z * z, yz - wx,  //
                    xz - wy, yz + wx, w * w - x * x - y * y + z * z});
}

/// The product ab (first b, then a), so that R(ab) = R(a) R(b).
template <class T>
Quaternion<T> quaternion_product(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// Rotation about coordinate axis 0, 1, 2. `one` is the one of the ring.
template <class T>
Matrix<T> matrix_about_axis(int axis, const CosSin<T>& angle, const T& one) {
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Matrix<T> result(3, 3);
  result(axis, axis) = one;
  result(next, next) = angle.cosine;
  result(last, last) = angle.cosine;
  result(last, next) = angle.sine;
  result(next, last) = T() - angle.sine;
  return result;
}

/// Rodrigues' formula. axis: a unit vector, which is not checked.
template <class T>
Matrix<T> matrix_from_axis_angle(const std::array<T, 3>& axis, const CosSin<T>& angle, const T& one) {
  const T versine = one - angle.cosine;
  Matrix<T> result(3, 3);
  const auto at = [&axis](int k) { return axis[k % 3]; };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = versine * at(i) * at(j);
    result(i, i) = result(i, i) + angle.cosine;
  }
  for (int i = 0; i < 3; ++i) {  // sine times the cross product with the axis
    const int next = (i + 1) % 3;
    result(next, i) = result(next, i) + angle.sine * at(i + 2);
    result(i, next) = result(i, next) - angle.sine * at(i + 2);
  }
  return result;
}

/// (cos, sin axis) of the half angle; axis: unit vector.
template <class T>
Quaternion<T> quaternion_from_axis_angle(const std::array<T, 3>& axis, const CosSin<T>& half_angle) {
  return {half_angle.cosine, half_angle.sine * axis[0], half_angle.sine * axis[1], half_angle.sine * axis[2]};
}

/// half_angles: in the order of the letters.
template <class T>
Quaternion<T> quaternion_from_euler(std::string_view order, EulerFrame frame,
                                    const std::array<CosSin<T>, 3>& half_angles) {
  const std::array<int, 3> axes = euler_axes(order);
  std::array<Quaternion<T>, 3> factors{};
  for (int i = 0; i < 3; ++i) {
    factors[i][0] = half_angles[i].cosine;
    factors[i][axes[i] + 1] = half_angles[i].sine;
  }
  if (frame == EulerFrame::kExtrinsic) std::swap(factors[0], factors[2]);
  return quaternion_product(quaternion_product(factors[0], factors[1]), factors[2]);
}

// ZYZ Euler angles of a rotation matrix, R = Rz(alpha) Ry(beta) Rz(gamma), at every beta.
//
// Cosines and sines come straight from the entries. With h = r02^2 + r12^2 = sin^2(beta),
//     (cos, sin) alpha = (r02, r12) / sqrt(h), or (1, 0) where h vanishes;   sin beta = sqrt(h), cos beta = r22;
//     cos gamma = r11 cos alpha - r01 sin alpha,   sin gamma = r10 cos alpha - r00 sin alpha.
// A tiny h gives alpha the rounding error of r02 and r12. But alpha remains an exact point of the circle, and gamma,
// which follows from the matrix and this alpha, makes up for the error: the product is R to rounding at every beta.
// Formulas that read gamma from r20 and r21 as well [Green03] divide two small numbers and need the case beta = 0 by
// hand. cos beta as sqrt(1 - sin^2 beta) or sin beta as sqrt(1 - r22^2) would lose half the digits near the poles.
// The proof zyz-angles shows the identity exactly for every rotation, with and without h = 0.

template <class T>
struct ZyzAngles {
  CosSin<T> alpha;
  CosSin<T> beta;
  CosSin<T> gamma;
};

/// The formula for a given direction of alpha, over any ring. azimuth: (cos, sin) alpha times some factor f; gamma then
/// carries the factor f too. f = 1 gives the angles, f = sqrt(h) keeps everything polynomial.
template <class T>
ZyzAngles<T> zyz_from_azimuth(const Matrix<T>& r, const CosSin<T>& azimuth, const T& sin_beta) {
  return {azimuth,
          {r(2, 2), sin_beta},
          {r(1, 1) * azimuth.cosine - r(0, 1) * azimuth.sine, r(1, 0) * azimuth.cosine - r(0, 0) * azimuth.sine}};
}

}  // namespace sh::symbolic
