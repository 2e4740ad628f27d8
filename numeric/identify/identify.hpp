// The convention that someone's functions follow, or the coefficients that are wrong, with the reason.
//
// Every convention (48 axes x phase x normalization x index order x real or complex x folded factors) expects a size
// times one function in each column. Each column is fitted to that function, v = scale * g + rest; a coefficient fits
// where scale = size to within kRounded, rest included. The answer is the reading with the most fitting coefficients.
// Several readings share it where they are equal on the data: many at degree 0 and 1, and at every degree a
// Condon-Shortley phase of real functions is the axes -x,-y,z.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/identify/table.hpp"

namespace sh::numeric::identify {

/// Directions and, for each, the values of someone's functions, checked. From a table x,y,z,v0,v1,...: (L+1)^2 values
/// for degrees 0..L, or 2 (L+1)^2: an array [cosine, sine][l][|m|] with holes, or complex values as two columns each
/// (real, imaginary).
struct Samples {
  int degree = 0;
  bool is_array = false;  // 2 (L+1)^2 columns with holes
  std::string file;
  std::vector<int> lines;
  std::vector<std::array<double, 3>> directions;           // of length 1
  std::vector<std::vector<std::complex<double>>> columns;  // [function][row]
};

/// The ways to read the table, at least one. With `normalise`, directions of any length but zero are scaled to 1.
/// Throws std::invalid_argument, one line "FILE:LINE: ..." or "FILE: ...": a number of columns that fits no degree up
/// to 20, a direction that is not real or not of length 1 to 1e-5, fewer directions than decide between all functions
/// of the degree (at least (L+1)^2, in general position: their values have to be linearly independent).
std::vector<Samples> read_samples(const Table& table, bool normalize);

/// `count` directions as CSV lines x,y,z with a header: first axes, diagonals and directions near the poles (at most a
/// quarter of them), then random ones.
std::string suggested_directions(int count);

/// Deviations are relative to the function's largest value: |size| sqrt((2l+1) / 4 pi), or the half under the root for
/// complex functions. A coefficient beyond kRounded (constants of three digits) is wrong. So is one beyond kOutlier
/// that stands out among the others a hundredfold, unless its constant is the right one, rounded.
inline constexpr double kRounded = 5e-3;
inline constexpr double kOutlier = 1e-5;
/// Noise of the values may add so many standard deviations.
inline constexpr double kNoiseAllowance = 5;

/// A convention that fits the data, and the presets that it is.
struct Reading {
  Convention convention;
  PresetNames presets;
};

/// One coefficient against the first reading.
struct Coefficient {
  int index = 0;
  Function function;                     // a hole should hold zero
  std::complex<double> ratio;            // fitted scale / size; 0 where the size is 0
  double deviation = 0;                  // largest |value - expected|, as above
  double shape = 0;                      // the same of value - ratio * expected: no constant explains this part
  std::size_t worst_row = 0;             // where `deviation` is
  std::complex<double> found, expected;  // there
  bool wrong = false;
  std::string reason;  // of a wrong one: "sign flipped"; of a rounded constant: "constant rounded to 3 digits"
};

/// A preset that fits all but one coefficient, or all but two that are swapped.
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
  std::string mistake = {};         // undone in `samples`: "theta and phi exchanged"; empty: none
  std::vector<int> bad_lines = {};  // of the file, left out of `samples`: they contradict all others
  double noise = 0;                 // standard deviation of the values around sums of functions

  [[nodiscard]] bool fits() const;  // no coefficient is wrong
  [[nodiscard]] bool recognized() const { return fits() && doubts.empty() && mistake.empty() && bad_lines.empty(); }
  [[nodiscard]] const Coefficient* first_wrong() const;  // of the first doubt where there is one; nullptr: none
  [[nodiscard]] double digits() const;                   // to which the worst fitting coefficient agrees, at most 17
};

/// The best answer among the ways to read a table (at least one).
Identification identify(const std::vector<Samples>& ways);

/// The answer for people, and for programs.
std::string format_text(const Identification& result, bool all_readings);
std::string format_json(const Identification& result);

/// A convention as an answer.
struct Candidate {
  Reading reading;
  int wrong = 0;       // columns that deviate by more than kRounded, holes that are not zero
  double penalty = 0;  // how far their sizes are off: 0 where only signs are wrong
  int rank = 0;        // 0: a preset, 1: a preset's world, 2: axes x,y,z, 3: right-handed, 4: mirrored
};

/// All conventions, the best first: fewest wrong, then smallest penalty, then rank, then the order of the enumerations.
/// noise: the standard deviation of the values; a coefficient may deviate by kNoiseAllowance of it.
std::vector<Candidate> ranked_candidates(const Samples& samples, double noise = 0);

/// The index orders that the columns may have.
std::vector<IndexOrder> orders_of(const Samples& samples);

/// How the lines agree with each other, in any convention: every column is a sum of the functions of its degree.
struct Consistency {
  double noise = 0;                        // standard deviation of the values; 0 where the table says nothing
  std::vector<std::size_t> bad_rows = {};  // rows that contradict all others, at most a quarter
};
Consistency consistency_of(const Samples& samples);
Samples without_rows(const Samples& samples, std::vector<std::size_t> rows);

/// The table without a mistake that concerns all of it.
struct Undone {
  std::string mistake;
  Samples samples;
};
/// Theta and phi exchanged, sine and cosine exchanged, values conjugated: the table with each of them undone.
std::vector<Undone> undone_mistakes(const Samples& samples);

/// [function][row]: the values that the convention expects in place of those of `samples`.
using Columns = std::vector<std::vector<std::complex<double>>>;
Columns expected_columns(const Samples& samples, const Convention& convention);

/// Why a coefficient of known ratio and shape is wrong: its sign, another coefficient's function, the conjugate, a
/// factor (2, sqrt 2, ...; a rounded or mistyped constant), single lines, or else the functions that it is a sum of.
std::string reason_of(const Samples& samples, const Convention& convention, const Columns& expected,
                      const Coefficient& coefficient, double noise);

/// "constant 0.282 for 0.2820948, rounded to 3 digits" where the constant in front of the polynomial of lowest integers
/// (1.092548 in 1.092548 xy) is the right one to 2 .. 8 digits, rounded or cut off; else "".
std::string rounding_of(const Convention& convention, const Coefficient& coefficient);

}  // namespace sh::numeric::identify
