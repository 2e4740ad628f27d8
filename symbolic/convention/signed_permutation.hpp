// Axes: the 48 signed permutations of x, y, z, and the band matrices that they induce.
//
// A convention may name the axes in another way: y up instead of z, a left-handed frame. Its coordinates are s' = P s,
// each a coordinate of ours with a sign. On the functions this is Y_l(P s) = D_l(P) Y_l(s): a signed permutation in
// bands 0 and 1, but from band 2 on a full matrix with surds. Reflections count: D_l(-1) = (-1)^l.
#pragma once

#include <cln/rational.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

class SignedPermutation {
 public:
  /// The identity: x, y, z.
  SignedPermutation() = default;
  /// "x,z,-y" says x' = x, y' = z, z' = -y. Throws std::invalid_argument unless each axis occurs once.
  explicit SignedPermutation(std::string_view text);

  /// Coordinate `row` of s' is sign(row) * (coordinate axis(row) of s).
  [[nodiscard]] int axis(int row) const { return axes_[row]; }
  [[nodiscard]] int sign(int row) const { return signs_[row]; }
  /// +1 keeps the handedness, -1 changes it.
  [[nodiscard]] int determinant() const;
  [[nodiscard]] Matrix<cln::cl_RA> matrix() const;  // (3, 3)
  [[nodiscard]] SignedPermutation inverse() const;
  [[nodiscard]] std::string to_string() const;

  /// First b, then a.
  friend SignedPermutation operator*(const SignedPermutation& a, const SignedPermutation& b);
  friend bool operator==(const SignedPermutation&, const SignedPermutation&) = default;

 private:
  std::array<int, 3> axes_{0, 1, 2};
  std::array<int, 3> signs_{1, 1, 1};
};

/// All 48, in a fixed order, the identity first.
std::vector<SignedPermutation> all_signed_permutations();

/// The rational part T_l(P) of D_l(P), D_mn = (k_m/k_n) T_mn, by the recursion of symbolic/rotation/rotation_recursion.hpp; the
/// surd matrix is surd_entries(degree, ...). Throws std::invalid_argument beyond degree 20.
Matrix<cln::cl_RA> axes_band(const SignedPermutation& axes, int degree);

}  // namespace sh::symbolic
