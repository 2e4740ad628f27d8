// The input of `shcheck identify`: directions and, for each, the values of someone's functions, checked.
//
// From a table x,y,z,v0,v1,...: (L+1)^2 values for degrees 0..L, or 2 (L+1)^2: an array [cosine, sine][l][|m|] with
// holes, or complex values as two columns each (real, imaginary).
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/table.hpp"

namespace sh::numeric::identify {

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
std::vector<Samples> read_samples(const Table& table, bool normalise);

/// `count` directions as CSV lines x,y,z with a header: first axes, diagonals and directions near the poles (at most a
/// quarter of them), then random ones.
std::string suggested_directions(int count);

}  // namespace sh::numeric::identify
