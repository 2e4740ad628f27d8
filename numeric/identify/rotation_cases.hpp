// What `shcheck rotation-matrix` looks at: rotations and someone's matrices of spherical harmonics for them, checked.
//
// From a table r00,r01,...,r22 (3x3, row by row, s' = R s), then the matrix: (bands^2)^2 entries, row by row, or the
// band matrices of degree 0, 1, ..., L one after the other, row by row, 1 + 9 + 25 + ... entries. Complex entries are
// cells such as 0.5+0.25i.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/identify/table.hpp"

namespace sh::numeric::identify {

// How far R R^T may be from 1: six printed digits, or float.
inline constexpr double kRotationTolerance = 1e-5;

struct RotationCase {
  int line = 0;
  std::array<long double, 9> r{};                        // the rotation nearest to what the line says
  std::vector<std::vector<std::complex<double>>> bands;  // [l]: (2l+1, 2l+1), as on the line
  double between_bands = 0;                              // largest entry that joins two bands
};

struct RotationCases {
  std::string file;
  int degree = 0;
  bool complex = false;  // an entry is
  std::vector<RotationCase> cases;
};

// Throws std::invalid_argument, one line "FILE:LINE: ..." or "FILE: ...": a number of columns that fits no degree 1 to
// 20; a 3x3 matrix that is no rotation; no rotation that is general enough to decide anything (by 0.2 to 2.9 radians
// about an axis away from the planes x = 0, y = 0, z = 0).
RotationCases read_rotation_cases(const Table& table);

// Whether the case can decide (see above).
bool is_general(const RotationCase& rotation);

// Radians. How far the rotation is from identity and from a half turn, and how far it tilts the polar axis of a
// convention with these axes (0 to pi). Relative error of tiny ones: that of the matrix.
struct RotationAngles {
  double from_identity = 0;
  double from_half_turn = 0;
  double tilt = 0;
};
RotationAngles angles_of(const RotationCase& rotation, const Axes& axes);

}  // namespace sh::numeric::identify
