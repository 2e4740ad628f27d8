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

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "numeric/reference/given_rotation.hpp"

namespace sh::numeric {

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
