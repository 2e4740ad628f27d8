// Reference values of the entries of D_l(R), in decimal, with as many correct digits as asked for.
//
// Input: degree, a rotation, row and column, digits. Output: the value in scientific notation, "0" where it is exactly
// zero. Conventions: README.md: c' = D(R) c, rows and columns are orders -l .. l.
//
// Each entry comes by itself from Wigner's explicit sum over a unit quaternion, whose terms have whole coefficients
// [Wigner59]: no other entry or degree enters, nothing is shared with the methods that it is a reference for, and the
// cancellation of the sum (up to 0.6 l digits) is met with more digits. An entry of a rotation with a rational
// quaternion is "0" only if it is zero; of any other, if it vanishes to 100 digits more than asked for and 2 l more for
// each digit of the input; of either, if all of 100,000 digits cancel.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

/// A rotation as the user writes it, in decimals taken exactly: a unit quaternion (w, x, y, z) at any precision, and
/// the size of the smallest entry of D_l that is not zero. The functions below throw std::invalid_argument, one line
/// that begins with the option's name, for a malformed number and for input that is not a rotation.
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

constexpr int kMaxRotationReferenceDegree = 1000;

class WignerEntries;  // of one degree and precision

class RotationReference {
 public:
  /// Throws std::invalid_argument for a degree outside 0 .. kMaxRotationReferenceDegree.
  RotationReference(int degree, GivenRotation rotation);
  ~RotationReference();
  RotationReference(const RotationReference&) = delete;
  RotationReference& operator=(const RotationReference&) = delete;

  /// Throws std::invalid_argument for an |order| above the degree and for digits out of range.
  std::string entry(int row, int column, int digits);

  /// (2l+1, 2l+1), row-major; advance() is called once for every entry.
  std::vector<std::string> all(int digits, const std::function<void()>& advance);

 private:
  int degree_;
  GivenRotation rotation_;
  std::map<int, std::unique_ptr<WignerEntries>> by_decimals_;
};

}  // namespace sh::numeric
