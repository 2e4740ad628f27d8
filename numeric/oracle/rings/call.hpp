// The arguments of the inner loops in kernels.cpp, which are compiled once per instruction set.
//
// Rings come in pairs +z, -z, told apart only at the end: P_lm is even in z for even l - m, odd otherwise. Arrays of
// pairs are padded to a multiple of kPadding by copies of the last one. A value near a pole may lie far below the
// smallest double: every lane has a level, and its values stand for themselves times 2^(kLevel * level), level <= 0.
#pragma once

#include <cstddef>

namespace sh::numeric::rings {

inline constexpr std::size_t kPadding = 32;
inline constexpr int kLevel = 768;
// Blocks with a smaller sine, or a smaller |z|, run in the form anchored there; no block of kPadding holds both.
inline constexpr double kNearPole = 0.15;
inline constexpr double kNearEquator = 0.02;

// mantissa * 2^exponent, lane by lane; mantissas within 0.5 .. 1, or 0.
struct ScaledArray {
  const double* mantissa;
  const double* exponent;
};

// Pairs of rings, by rising sine.
struct Pairs {
  std::size_t first, count;  // those from first on may have values above 2^-1074 at this order; multiples of kPadding
  const double* z;           // (count), >= 0
  const double* sine;        // (count)
  ScaledArray low, high;     // (count): sine^order is the product of the two
};

// One step of the two-step recurrence (methods/legendre_rows.hpp): p' = (a z^2 + b) p - p_before.
// `even` and `odd`: the factors of p in a synthesis, the sums of p in an analysis.
struct Step {
  double a, b;
  double even[2], odd[2];
};

// The same step from the growth of p at an anchor, the pole or the equator, g = p' / p there:
//   d' = d / g_before - a q p,  p' = g p + d',  q = sine^2 at the pole, -z^2 at the equator.
// No rounding weighs like 1 / sine or 1 / z then: where q is small so is d.
struct Growth {
  double g, inverse_before;
};

// The recurrence at one order.
struct Column {
  int degree, order;
  std::size_t steps;      // (degree - order) / 2 + 1: step k holds degrees m + 2k and m + 2k + 1
  double start_mantissa;  // P_mm / sine^m
  double* eps;            // (2 steps + 8): eps_(m+n,m)
  double* alpha;          // (steps)
  Step* table;            // (steps)
  Growth* pole;           // (steps)
  Growth* equator;        // (steps)
};

// The inner loops of one instruction set.
struct Kernels {
  // Fills eps, alpha, pole, equator and a, b of the table.
  void (*prepare)(const Column& column);
  // table.even, table.odd from coefficients (degree - order + 1, 2).
  void (*spread)(const Column& column, const double* coefficients);
  // sums (4, pairs.count): the even functions' of both components, the odd ones'. Those before pairs.first are not set.
  void (*synthesis)(const Column& column, const Pairs& pairs, double* sums);
  // table.even, table.odd from values (4, pairs.count); work (steps + 1, 4, 8).
  void (*analysis)(const Column& column, const Pairs& pairs, const double* values, double* work);
  // coefficients (degree - order + 1, 2) from table.even, table.odd: the transpose of spread.
  void (*gather)(const Column& column, double* coefficients);
};

namespace baseline {
extern const Kernels kKernels;
}
namespace avx2 {
extern const Kernels kKernels;
}
namespace avx512 {
extern const Kernels kKernels;
}

}  // namespace sh::numeric::rings
