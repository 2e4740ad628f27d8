// Someone's rotation matrices against the oracle: which convention, how far from the truth, and where.
//
// Input: a table r00,r01,...,r22 (3x3, row by row, s' = R s), then the matrix: (bands^2)^2 entries, row by row, or the
// band matrices of degree 0, 1, ..., L one after the other, row by row, 1 + 9 + 25 + ... entries.
//
// A convention's matrix for R is D' = C D(axes R axes^-1) C^-1 with D the oracle's (numeric/oracle/rotation.hpp) and
// c' = C c its coefficients: from Y' = A Y follows C = A^-T. Factors that depend on l alone cancel, so orthonormal,
// 4-pi, Schmidt and SN3D functions have the same matrices, and a reflection of all axes changes nothing: 24 axes
// remain. Code may also hold the matrix of the inverse rotation (or take R the other way round), or its rows as
// columns; where functions are real and normalized these two are the same.
//
// Orthogonality proves little: a rotation whose angles lose digits is still some rotation. So two errors are kept for
// each band: the orthogonality defect, largest |D D* - 1|, and the true error, largest |D - exact|, both of matrices
// whose functions are scaled to orthonormal ones.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/identify/table.hpp"

namespace sh::numeric::identify {

struct RotationCase {
  int line = 0;
  std::array<long double, 9> r{};                        // the rotation nearest to the line's
  std::vector<std::vector<std::complex<double>>> bands;  // [l]: (2l+1, 2l+1), as on the line
  double between_bands = 0;                              // largest entry that joins two bands
};

struct RotationCases {
  std::string file;
  int degree = 0;
  bool complex = false;  // an entry is
  std::vector<RotationCase> cases;
};

/// Throws std::invalid_argument, one line "FILE:LINE: ..." or "FILE: ...": a number of columns that fits no degree 1 to
/// 20; a 3x3 matrix that is no rotation; no general rotation.
RotationCases read_rotation_cases(const Table& table);

/// Whether the case can decide between conventions: a turn by 0.2 to 2.9 radians about an axis away from the planes
/// x = 0, y = 0, z = 0.
bool is_general(const RotationCase& rotation);

/// In radians: how far the rotation is from identity and from a half turn, and how far it tilts the polar axis of a
/// convention with these axes (0 to pi). Relative error of tiny ones: that of the matrix.
struct RotationAngles {
  double from_identity = 0;
  double from_half_turn = 0;
  double tilt = 0;
};
RotationAngles angles_of(const RotationCase& rotation, const Axes& axes);

/// A convention of matrices.
struct RotationReading {
  Convention convention;    // kOrthonormal stands for all four normalizations; nothing folded
  bool inverse = false;     // of R^-1
  bool transposed = false;  // rows and columns exchanged
  PresetNames presets = {};

  [[nodiscard]] std::string describe() const;
};

using Band = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, Eigen::Dynamic>;  // rows, columns -l .. l

/// The unitary matrix of degree l that the reading expects for each degree 0 .. max_degree.
std::vector<Band> expected_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree);
/// The case's own matrix in the same terms: order -l .. l, not transposed, sizes and signs of the functions taken out.
Band own_band(const RotationReading& reading, const RotationCase& rotation, int l);

/// The readings with the fewest entries that are off by more than kFar in general cases, degree 3 at most; presets
/// first, matrices of R itself before others.
std::vector<RotationReading> best_rotation_readings(const RotationCases& cases);
inline constexpr long double kFar = 1e-2L;

struct BandErrors {
  int degree = 0;
  double defect = 0;
  double error = 0;
  double limit = 0;       // of the true error
  std::size_t worst = 0;  // case of the largest true error
};

/// The first entry of a general rotation that no convention explains.
struct WrongEntry {
  int line = 0;
  int degree = 0, row = 0, column = 0;   // orders m of the reading
  std::complex<double> found, expected;  // of orthonormal functions
  std::string reason;                    // "" where nothing simple explains the band
};

/// The largest true error of the rotations that tilt the polar axis by an angle in a decade, or come as near to turning
/// it over.
struct TiltErrors {
  double from = 0, to = 0;  // radians
  int cases = 0;
  double error = 0;
};

struct RotationCheck {
  RotationCases cases;
  std::vector<RotationReading> readings;  // the best, equal on these data
  bool fits = false;                      // general rotations agree with them to kFar
  std::vector<WrongEntry> wrong;          // at most one, where they do not
  std::vector<BandErrors> bands;
  double between_bands = 0;          // largest entry of a full matrix that should be zero
  double epsilon = 0;                // of the type that the matrices seem to be computed in
  std::vector<TiltErrors> tilts;     // large ones first
  std::vector<std::size_t> failing;  // cases beyond a limit
  std::string diagnosis;             // of these

  [[nodiscard]] bool passes() const { return fits && failing.empty(); }
};

/// `tolerance`: the limit of the true error; 0: 16 (l+1) epsilon (the recursion in float errs by 0.6 (l+1) to degree
/// 20), epsilon that of float, or of double where half of the cases err by less than 1e-11.
RotationCheck check_rotations(const RotationCases& cases, double tolerance);

std::string format_text(const RotationCheck& result, bool all_readings);
std::string format_json(const RotationCheck& result);

}  // namespace sh::numeric::identify
