// Solid angles of rectangles on a cube face, exact.
//
// The face is z = 1, the rectangle x0 <= x <= x1, y0 <= y <= y1. Its solid angle is the integral of the area element
// (1+x^2+y^2)^(-3/2), that is A(x1,y1) - A(x0,y1) - A(x1,y0) + A(x0,y0) with A(a,b) = atan(ab / sqrt(1+a^2+b^2)). Sums
// of A are kept as such; A is odd in both arguments and symmetric.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic::errata::texel {

class CornerSum {
 public:
  CornerSum() = default;
  /// A(a, b)
  static CornerSum corner(const cln::cl_RA& a, const cln::cl_RA& b);
  /// The value rounded to at least `digits` decimal digits.
  [[nodiscard]] cln::cl_F evaluate(int digits) const;

  friend CornerSum operator+(const CornerSum& a, const CornerSum& b) { return a.plus(b, 1); }
  friend CornerSum operator-(const CornerSum& a, const CornerSum& b) { return a.plus(b, -1); }
  friend CornerSum operator*(const cln::cl_RA& factor, const CornerSum& a) { return CornerSum().plus(a, factor); }
  friend bool operator==(const CornerSum& a, const CornerSum& b) { return (a - b).terms_.empty(); }

 private:
  [[nodiscard]] CornerSum plus(const CornerSum& other, const cln::cl_RA& factor) const;
  std::map<std::pair<cln::cl_RA, cln::cl_RA>, cln::cl_RA> terms_;  // (a <= b, both positive) -> coefficient
};

/// d^2 A / da db = (1+a^2+b^2)^(-3/2), as an identity of rational functions in a, b and their root.
bool corner_integrates_area_element();
/// A(1,1) = pi/6, so that the six faces have 4 pi: (sqrt 3 + i)^6 is negative.
bool corner_of_face_is_sixth_of_pi();

/// Centres of `count` texels in a row on [-1, 1].
std::vector<cln::cl_RA> texel_centres(int count);
/// Unit directions to all 6 N^2 texel centres of a cube map.
std::vector<std::array<RadicalSum, 3>> cube_directions(int size);

}  // namespace sh::symbolic::errata::texel
