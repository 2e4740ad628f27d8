// The inner loop of relighting: rows of transfer coefficients as they lie in memory, times a light, times a colour.
//
// Lanes are vertices: rows pass through registers and are transposed there. Every sum runs over the coefficients in
// their order, beginning with 0, one multiplication and one addition each, without contraction: the bits are those of
// the plain loop, on every instruction set, for any number of threads and wherever the rows are split.
// There is one copy for each instruction set (row_products.cpp), chosen when the program runs
// (row_products_choice.cpp).
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace sh::prt {

/// Rows, a light, and which of them meet: sum s of a vertex is
///   sum_i transfer[vertex stride + s transfer_step + i] light[s light_step + i], i = 0 .. coefficients - 1.
struct RowProducts {
  const float* transfer = nullptr;  // of the first vertex
  std::size_t stride = 0;           // values from one vertex to the next
  std::size_t transfer_step = 0;    // from one channel to the next; 0: one channel serves every sum
  const float* light = nullptr;
  std::size_t light_step = 0;    // the same for the light; 0: white light
  std::size_t coefficients = 0;  // terms of each sum
  std::size_t sums = 3;          // a vertex: 1 or 3; 3 where a step is not 0
};

/// `count` vertices with three values each, out[3v + c] = sum c (or the only one) times colour[3v + c]; without colour
/// (null) the sum itself. `out` overlaps nothing.
void colour_products(const RowProducts& rows, std::size_t count, const float* colour, float* out);

/// `count` vertices with one value each, their only sum.
void grey_products(const RowProducts& rows, std::size_t count, float* out);

/// The two on one instruction set, for comparisons; all that this machine has, the one in use last.
struct RowProductsOn {
  std::string_view instruction_set;
  void (*colour)(const RowProducts& rows, std::size_t count, const float* colour, float* out);
  void (*grey)(const RowProducts& rows, std::size_t count, float* out);
};
std::span<const RowProductsOn> row_products_here();

}  // namespace sh::prt
