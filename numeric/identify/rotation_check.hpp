// Someone's rotation matrices against the oracle: which convention, how far from the truth, and where.
//
// Orthogonality proves little: a rotation whose angles lose digits is still some rotation. So two errors are kept for
// each band: the orthogonality defect, largest |D D* - 1|, and the true error, largest |D - exact|, both of matrices
// whose functions are scaled to orthonormal ones.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/rotation_readings.hpp"

namespace sh::numeric::identify {

struct BandErrors {
  int degree = 0;
  double defect = 0;
  double error = 0;
  double limit = 0;       // what the true error may be
  std::size_t worst = 0;  // case of the largest true error
};

// The first entry of a general rotation that no convention explains.
struct WrongEntry {
  int line = 0;
  int degree = 0, row = 0, column = 0;   // orders m of the reading
  std::complex<double> found, expected;  // of orthonormal functions
  std::string reason;                    // "" where nothing simple explains the band
};

// Largest true error of the rotations that tilt the polar axis by an angle in a decade, or come as near to turning it
// over.
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

// `tolerance`: what the true error may be; 0: 16 (l+1) epsilon (the recursion in float errs by 0.6 (l+1) to degree 20),
// epsilon that of float, or of double where half of the cases err by less than 1e-11.
RotationCheck check_rotations(const RotationCases& cases, double tolerance);

std::string format_text(const RotationCheck& result, bool all_readings);
std::string format_json(const RotationCheck& result);

}  // namespace sh::numeric::identify
