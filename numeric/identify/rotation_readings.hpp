// The conventions of rotation matrices, and which of them someone's matrices follow.
//
// A convention's matrix for R is D' = C D(axes R axes^-1) C^-1 with D the oracle's (numeric/oracle/rotation.hpp) and
// c' = C c its coefficients: from Y' = A Y follows C = A^-T. Factors that depend on l alone cancel, so orthonormal,
// 4-pi, Schmidt and SN3D functions have the same matrices, and a reflection of all axes changes nothing: 24 axes
// remain. Code may also hold the matrix of the inverse rotation (or take R the other way round), or its rows as
// columns; where functions are real and normalised these two are the same.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/rotation_cases.hpp"

namespace sh::numeric::identify {

struct RotationReading {
  Convention convention;    // kOrthonormal stands for all four normalisations; nothing folded
  bool inverse = false;     // of R^-1
  bool transposed = false;  // rows and columns exchanged

  [[nodiscard]] std::string describe() const;
  [[nodiscard]] std::vector<std::string> presets() const;        // in their own coordinates
  [[nodiscard]] std::vector<std::string> world_presets() const;  // R given in our world
};

using Band = std::vector<std::complex<long double>>;  // (2l+1, 2l+1), rows and columns -l .. l

// What the reading expects for the case: unitary matrices of degree 0 .. max_degree.
std::vector<Band> expected_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree);
// The case's own matrices in the same terms: order -l .. l, not transposed, sizes and signs of the functions taken out.
std::vector<Band> own_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree);

struct RotationCandidate {
  RotationReading reading;
  int wrong = 0;  // entries of the general cases that are off by more than kFar, degree 3 at most
  int rank = 0;   // as in candidates.hpp; matrices of R itself before others
};
inline constexpr long double kFar = 1e-2L;

// All, the best first.
std::vector<RotationCandidate> ranked_rotation_readings(const RotationCases& cases);

}  // namespace sh::numeric::identify
