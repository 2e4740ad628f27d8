// The inner loop of relighting: rows of transfer coefficients, in their order in memory, times a light, times a color.
//
// Lanes are vertices: rows pass through registers and are transposed there. Every sum starts with 0 and runs over the
// coefficients in their order, with one multiplication and one addition each and without contraction. The bits are
// those of the plain loop on every instruction set, for any number of threads and any split of the rows.
// Each instruction set has its own copy (row_products.cpp); relight.cpp chooses one at run time.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace sh::prt {

/// The rows, the light and the steps between their channels. Sum s of a vertex is
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

/// The products on one instruction set.
struct RowProductsOn {
  std::string_view instruction_set;
  /// Writes three values for each of `count` vertices: out[3v + c] = sum c (or the only sum) times color[3v + c]. If
  /// `colour` is null, the value is the sum itself. `out` overlaps nothing.
  void (*color)(const RowProducts& rows, std::size_t count, const float* color, float* out);
  /// Writes one value for each of `count` vertices: its only sum.
  void (*gray)(const RowProducts& rows, std::size_t count, float* out);
};

/// All instruction sets of this machine, for comparisons; the last one is in use.
std::span<const RowProductsOn> row_products_here();

}  // namespace sh::prt
