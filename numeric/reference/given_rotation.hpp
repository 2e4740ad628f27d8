// A rotation as the user writes it, in decimals taken exactly: a matrix, a quaternion, Euler angles, an axis and an
// angle.
//
// Out: a unit quaternion (w, x, y, z) at any precision, and how small an entry of D_l can be without being zero.
// Conventions: README.md; s' = R s. All throw std::invalid_argument, one line, for a malformed number and for input
// that is not a rotation; a refusal begins with the option's name.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

struct GivenRotation {
  /// Unit, at the present precision.
  std::function<std::array<MpfrAny, 4>()> quaternion;
  /// Decimals of the integers that the quaternion is a ratio of, squared and added up; of other rotations, of the
  /// input.
  double height = 0;
  /// The quaternion is a rational one over its length. Then an entry of D_l that is not zero is above
  /// 10^-(l (height + 0.31) + 1), since it is an integer over the length^(2l) times the root of a ratio of binomials.
  bool rational = false;
  /// Of a matrix: the root of the sum of the squares of its differences from the rotation that is taken.
  double distance = 0;
};

/// r (3x3, row-major), |R R^T - 1| <= 2e-3 in each entry, det > 0. The nearest rotation is taken, in the sense of
/// `distance`; a matrix that is exactly a rotation is itself. By Newton's iteration for the polar factor (Higham 1986).
GivenRotation rotation_from_matrix(const std::string& option, const std::array<std::string, 9>& r);

/// w, x, y, z: of any length but zero.
GivenRotation rotation_from_quaternion(const std::string& option, const std::array<std::string, 4>& q);

/// R = Rz(a) Ry(b) Rz(c), radians.
GivenRotation rotation_from_euler(const std::string& option, const std::array<std::string, 3>& angles);

/// By `angle` radians about the axis, of any length but zero, anticlockwise seen from its tip.
GivenRotation rotation_from_axis(const std::string& option, const std::array<std::string, 3>& axis,
                                 const std::string& angle_option, const std::string& angle);

}  // namespace sh::numeric
