// ZYZ Euler angles from a rotation matrix, R = Rz(alpha) Ry(beta) Rz(gamma), by a formula without a hole at beta = 0 or
// pi.
//
// Cosines and sines come straight from the entries; no angle is formed. With h = r02^2 + r12^2 = sin^2(beta),
//     (cos, sin) alpha = (r02, r12) / sqrt(h), or (1, 0) where h vanishes;   sin beta = sqrt(h), cos beta = r22;
//     cos gamma = r11 cos alpha - r01 sin alpha,   sin gamma = r10 cos alpha - r00 sin alpha.
// Only alpha is normalised. When h is tiny alpha carries the rounding error of r02, r12, but it is an exact point of
// the circle, and gamma, taken from the matrix and this very alpha, makes up for it: the product is R to rounding at
// every beta. Formulas that read gamma from r20, r21 as well [Green03] divide two small numbers and need the
// case beta = 0 by hand. cos beta as sqrt(1 - sin^2 beta) or sin beta as sqrt(1 - r22^2) would lose half the digits
// near the poles. symbolic/proofs/rotation_proofs.hpp proves the identity exactly for every rotation, with and without h = 0.
#pragma once

#include <cmath>
#include <limits>

#include "symbolic/number/matrix.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic {

template <class T>
struct ZyzAngles {
  CosSin<T> alpha;
  CosSin<T> beta;
  CosSin<T> gamma;
};

/// The formula for a given direction of alpha, over any ring: azimuth = (cos, sin) alpha times some factor f, and
/// sin_beta; then gamma carries the factor f too. f = 1 gives the angles, f = sqrt(h) keeps everything polynomial.
template <class T>
ZyzAngles<T> zyz_from_azimuth(const Matrix<T>& r, const CosSin<T>& azimuth, const T& sin_beta) {
  return {azimuth,
          {r(2, 2), sin_beta},
          {r(1, 1) * azimuth.cosine - r(0, 1) * azimuth.sine, r(1, 0) * azimuth.cosine - r(0, 0) * azimuth.sine}};
}

/// The angles of a floating-point rotation matrix (3, 3); T is float, double or long double. Where h underflows beta is
/// 0 or pi to the last digit, and alpha = 0.
template <class T>
ZyzAngles<T> zyz_angles(const Matrix<T>& r) {
  const T h = r(0, 2) * r(0, 2) + r(1, 2) * r(1, 2);
  // Where h is this small its square root still has all its digits only if h is a normal number.
  const bool at_pole = h < std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
  const T inverse = at_pole ? T(1) : T(1) / std::sqrt(h);
  const CosSin<T> alpha = at_pole ? CosSin<T>{T(1), T(0)} : CosSin<T>{r(0, 2) * inverse, r(1, 2) * inverse};
  return zyz_from_azimuth(r, alpha, h * inverse);
}

/// Rz(alpha) Ry(beta) Rz(gamma).
template <class T>
Matrix<T> matrix_from_zyz(const ZyzAngles<T>& angles, const T& one) {
  return matrix_from_euler<T>("zyz", EulerFrame::kIntrinsic, {angles.alpha, angles.beta, angles.gamma}, one);
}

}  // namespace sh::symbolic
