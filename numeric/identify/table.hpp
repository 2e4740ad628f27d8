// A table of numbers from a CSV file, with the line that each row stands on.
//
// Input: numbers separated by commas, one row a line. A first line without any number is a header. Blank lines and
// everything after a # are left out. A cell is real (0.5, -1e-3) or complex (0.5+0.25i, (1e-3-2j), 2i). Packaged
// readers of C++ fix the number of columns when they compile or do not report the line of an error, hence this one on
// std::from_chars.
#pragma once

#include <complex>
#include <string>
#include <string_view>
#include <vector>

namespace sh::numeric::identify {

struct Row {
  int line = 0;  // from 1
  std::vector<std::complex<double>> cells;
};

struct Table {
  std::string file;
  std::vector<Row> rows;  // at least one, all of the same number of cells
};

/// The table of a text; `file` names it in errors. Throws std::invalid_argument, one line.
Table parse_table(const std::string& file, std::string_view text);
/// Reads the file and parses it; std::runtime_error where it cannot be read (output/read_file.hpp).
Table read_table(const std::string& file);

/// Throws std::invalid_argument "FILE:LINE: message", or "FILE: message" for line 0.
[[noreturn]] void refuse(const std::string& file, int line, const std::string& message);

}  // namespace sh::numeric::identify
