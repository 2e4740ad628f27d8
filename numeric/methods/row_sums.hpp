// The inner loop of zxz_rows.hpp: rows of a quarter turn made, used and forgotten, a block of them at a time.
//
// kappa_(a-1) = slope_a b kappa_a + kappa_(a+1) gives the row of order a - 1 from the two above it, column by column
// (b); weight_a kappa_a is added to `even` for every second row, to `odd` for the others. Eight rows pass through
// registers for each column, so memory is touched once in eight steps and columns fill SIMD lanes.
// For double there is one copy of the loop for each instruction set (row_sums.cpp), chosen when the program runs, all
// without contraction: every machine gives the same bits.
#pragma once

namespace sh::numeric::methods {

constexpr int kRowsAtOnce = 8;

template <class Real>
struct RowSums {
  int columns;
  int rows;            // a multiple of kRowsAtOnce
  const Real* order;   // (columns) b
  const Real* slope;   // (rows)
  const Real* weight;  // (rows)
  Real *row, *above;   // (columns) the first row and the row above it; overwritten
  Real *even, *odd;    // (columns) added to
};

/// One block. Inlined everywhere, or one instruction set's copy might stand in for another's.
template <class Real>
[[gnu::always_inline]] inline void add_block(int columns, const Real* slope, const Real* weight,
                                             const Real* __restrict order, Real* __restrict row, Real* __restrict above,
                                             Real* __restrict even, Real* __restrict odd) {
  for (int i = 0; i < columns; ++i) {
    Real x = above[i], y = row[i], to_even = even[i], to_odd = odd[i];
    for (int k = 0; k < kRowsAtOnce; k += 2) {
      to_even += weight[k] * y;
      x += slope[k] * order[i] * y;
      to_odd += weight[k + 1] * x;
      y += slope[k + 1] * order[i] * x;
    }
    above[i] = x;
    row[i] = y;
    even[i] = to_even;
    odd[i] = to_odd;
  }
}

/// All blocks.
template <class Real>
[[gnu::always_inline]] inline void add_all_blocks(const RowSums<Real>& sums) {
  for (int k = 0; k < sums.rows; k += kRowsAtOnce) {
    add_block(sums.columns, sums.slope + k, sums.weight + k, sums.order, sums.row, sums.above, sums.even, sums.odd);
  }
}

template <class Real>
void add_rows(const RowSums<Real>& sums) {
  add_all_blocks(sums);
}
template <>
void add_rows(const RowSums<double>& sums);

/// The copy for any machine, to compare others with.
namespace baseline {
void add_rows(const RowSums<double>& sums);
}

}  // namespace sh::numeric::methods
