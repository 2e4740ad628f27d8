// Weighted sums of rows of floats, on the widest registers: the inner loop of shadows and of glossy bounces. Every sum runs
// over its rows in order, with one multiplication and one addition each, so that the bits do not depend on the registers.
#pragma once
#include <cstddef>
#include <cstdint>

namespace sh::prt {

/// Rows are padded to whole registers: the least multiple of 8 that holds `columns`.
constexpr std::size_t padded_row(std::size_t columns) { return (columns + 7) / 8 * 8; }

/// sum (row_length) = the sum of weights[j] values[j] over the first `count` indices j in `chosen`, where values[j] is a
/// row of row_length floats. Precondition: row_length is padded.
void sum_rows(const float* values, std::size_t row_length, const std::uint32_t* chosen, std::size_t count,
              const float* weights, float* sum);

}  // namespace sh::prt
