// Which convention do someone's functions follow? And if none, which coefficient is wrong, and how?
//
// Every convention (48 axes x phase x normalisation x index order x real or complex x folded factors) says what each
// column should be: a size times one function. Each column is fitted to that function, v = scale * g + rest, and a
// coefficient fits where scale = size to within kRounded, rest included. The reading with the most fitting coefficients
// is the answer; several share it where they are equal on the data (at degree 0 and 1 many are, and a Condon-Shortley
// phase of real functions is the axes -x,-y,z at every degree).
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/identify/samples.hpp"

namespace sh::numeric::identify {

// Deviations, all relative to the function's largest value: |size| sqrt((2l+1) / 4 pi), or the half under the root for
// complex functions. Beyond kRounded (constants of three digits) a coefficient is wrong. So is one beyond kOutlier that
// stands out among the others a hundredfold, unless its constant is the right one, rounded.
inline constexpr double kRounded = 5e-3;
inline constexpr double kOutlier = 1e-5;

// A convention that says the same on the data as the others of its list, with the presets that it is.
struct Reading {
  Convention convention;
  std::vector<std::string> presets;        // in the source's own coordinates: axes x,y,z
  std::vector<std::string> world_presets;  // directions were given in our world: axes are the preset's
};

// One coefficient against the first reading.
struct Coefficient {
  int index = 0;
  Function function;                     // a hole should hold zero
  std::complex<double> ratio;            // fitted scale / size; 0 where the size is 0
  double deviation = 0;                  // largest |value - expected|, as above
  double shape = 0;                      // the same of value - ratio * expected: what no constant explains
  std::size_t worst_row = 0;             // where `deviation` is
  std::complex<double> found, expected;  // there
  bool wrong = false;
  std::string reason;  // of a wrong one: "sign flipped"; of a rounded constant: "constant rounded to 3 digits"
};

// A preset that fits all but one coefficient, or all but two that are swapped.
struct Doubt {
  Reading reading;
  std::vector<Coefficient> wrong;
};

struct Identification {
  Samples samples;
  std::vector<Reading> readings;  // the best; presets first, then those with the simplest axes
  std::vector<Coefficient> coefficients;
  // At degree 0 and 1 a wrong coefficient may look like other axes: presets that come near, where no reading is one.
  std::vector<Doubt> doubts;

  [[nodiscard]] bool fits() const;  // no coefficient is wrong
  [[nodiscard]] bool recognised() const { return fits() && doubts.empty(); }
  [[nodiscard]] const Coefficient* first_wrong() const;  // of the first doubt where there is one; nullptr: none
  [[nodiscard]] double digits() const;                   // to which the worst fitting coefficient agrees, at most 17
};

// The best answer among the ways to read a table (at least one).
Identification identify(const std::vector<Samples>& ways);

// For people, and for programs.
std::string format_text(const Identification& result, bool all_readings);
std::string format_json(const Identification& result);

}  // namespace sh::numeric::identify
