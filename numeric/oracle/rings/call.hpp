// The arguments of the inner loops in kernels.cpp, which are compiled once per instruction set.
//
// Rings come in pairs +z, -z, told apart only at the end: P_lm is even in z for even l - m, odd otherwise. Pairs stand in
// groups of kPadding, each filled up by copies of its last one. A value near a pole may lie far below the smallest double:
// every lane has a level, and its values stand for themselves times 2^(kLevel * level), level <= 0.
#pragma once

#include <cstddef>

namespace sh::numeric::rings {

inline constexpr std::size_t kPadding = 8;  // the lanes of the widest register
inline constexpr int kLevel = 768;
// Groups with a smaller sine, or a smaller |z|, run in the form anchored there; no group holds both.
inline constexpr double kNearPole = 0.15;
inline constexpr double kNearEquator = 0.02;

// What counts: levels from `lowest` on, 0 or -1, and the factor of level -1, 2^-kLevel if it counts.
struct Tail {
  double lowest, down;
};

// mantissa * 2^exponent, lane by lane; mantissas within 0.5 .. 1, or 0.
struct ScaledArray {
  const double* mantissa;
  const double* exponent;
};

// Pairs of rings, by rising sine; all numbers are multiples of kPadding. Those before `first` have no value that
// counts at this order, those before `plain` run anchored at the pole, those from `equator` on at the equator.
struct Pairs {
  std::size_t first, plain, equator, count;
  const double* z;        // (count), >= 0
  const double* sine;     // (count)
  ScaledArray low, high;  // (count): sine^order is the product of the two
};

// The two-step recurrence (methods/legendre_rows.hpp) at one order: p' = (a z^2 + b) p - p_before. Each array has an entry
// a step; none depends on the degree at which a transform ends.
//
// The same step from the growth of p at an anchor, the pole or the equator, g = p' / p there:
//   d' = d / g_before - a q p,  p' = g p + d',  q = sine^2 at the pole, -z^2 at the equator.
// No rounding weighs like 1 / sine or 1 / z then: where q is small so is d.
struct Growth {
  double* g;
  double* inverse_before;
};
struct Tables {
  std::size_t size;  // of each array: size_of_tables(steps)
  double* even;      // eps_(m+2k,m)
  double* odd;       // eps_(m+2k+1,m)
  double* alpha;
  double* a;
  double* b;
  Growth pole, equator;
};
inline constexpr std::size_t kArrays = 9;

// Arrays for that many steps, the last with what the recurrence needs ahead.
inline constexpr std::size_t size_of_tables(std::size_t steps) { return (steps / kPadding + 2) * kPadding; }
inline Tables tables_in(double* memory, std::size_t steps) {
  const std::size_t size = size_of_tables(steps);
  const auto next = [&memory, size] {
    double* const array = memory;
    memory += size;
    return array;
  };
  Tables tables{};
  tables.size = size;
  for (double** array : {&tables.even, &tables.odd, &tables.alpha, &tables.a, &tables.b, &tables.pole.g,
                         &tables.pole.inverse_before, &tables.equator.g, &tables.equator.inverse_before}) {
    *array = next();
  }
  return tables;
}

// What belongs to the values of one step: step k holds degrees m + 2k and m + 2k + 1. The factors of p in a synthesis,
// the sums of p in an analysis.
struct Terms {
  double even[2], odd[2];
  [[nodiscard]] double of(std::size_t i) const { return i < 2 ? even[i] : odd[i - 2]; }
};

// A transform at one order.
struct Column {
  int degree, order;
  std::size_t steps;      // (degree - order) / 2 + 1
  double start_mantissa;  // P_mm / sine^m
  Tail tail;
  Tables tables;
  Terms* terms;  // (tables.size)
};

// The inner loops of one instruction set.
struct Kernels {
  // Fills the tables of an order; those of an anchor only if asked to.
  void (*prepare)(int order, const Tables& tables, bool pole, bool equator);
  // terms from coefficients (degree - order + 1, 2).
  void (*spread)(const Column& column, const double* coefficients);
  // values (pairs.count, 4): of both components at z, then at -z. Those before pairs.first are not set.
  void (*synthesis)(const Column& column, const Pairs& pairs, double* values);
  // terms from such values.
  void (*analysis)(const Column& column, const Pairs& pairs, const double* values);
  // coefficients (degree - order + 1, 2) from terms: the transpose of spread.
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
