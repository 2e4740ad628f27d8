// A table of numbers, one row a vertex: the columns of a linear system that are solved side by side.
#pragma once
#include <cstddef>
#include <vector>

namespace sh::prt {

/// (rows, columns) doubles, row-major; the columns are whole SIMD registers (a multiple of kUnit).
struct Panel {
  static constexpr std::size_t kUnit = 8;

  Panel(std::size_t row_count, std::size_t least_columns)
      : rows(row_count), columns((least_columns + kUnit - 1) / kUnit * kUnit), values(rows * columns, 0.0) {}
  double* row(std::size_t r) { return values.data() + r * columns; }
  [[nodiscard]] const double* row(std::size_t r) const { return values.data() + r * columns; }

  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;
};

}  // namespace sh::prt
