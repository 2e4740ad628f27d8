// The inner loops of legendre_rings.hpp on one instruction set, SH_RINGS_ISA; see call.hpp.
#include "numeric/oracle/rings/recurrence.hpp"

namespace sh::numeric::rings::SH_RINGS_ISA {
namespace {

// eps_(m+n,m) for n = 0 .. 2 steps + 7.
void fill_eps(const Column& c) {
  const Lanes m(static_cast<double>(c.order));
  for (std::size_t n = 0; n < 2 * c.steps + 8; n += kWidth) {
    alignas(64) double index[kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) index[i] = static_cast<double>(n + i);
    const Lanes gap = Lanes::load_aligned(index);
    const Lanes l = gap + m;
    const Lanes square = gap * (gap + (m + m)) / (Lanes(4.0) * l * l - Lanes(1.0));
    alignas(64) double eps[kWidth];
    xsimd::sqrt(square).store_aligned(eps);
    for (std::size_t i = 0; i < kWidth && n + i < 2 * c.steps + 8; ++i) c.eps[n + i] = eps[i];
  }
}

// p' / p at the pole and the equator, but for alpha / alpha', from P_lm / (z sin^m theta) there with l - m odd: at the
// pole it is a constant of the order times sqrt((2l+1) (l+m)! / (l-m)!), at the equator that changes from l to l + 2 by
// the factor -(l+m+2) / (l-m+1) before it is normalized.
void fill_growth(const Column& c) {
  const Lanes one(1.0);
  const Lanes two(2.0);
  const Lanes m(static_cast<double>(c.order));
  for (std::size_t k = 0; k < c.steps; k += kWidth) {
    alignas(64) double index[kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) index[i] = static_cast<double>(2 * (k + i) + 1);
    const Lanes gap = Lanes::load_aligned(index);
    const Lanes l = gap + m;
    const Lanes sum = l + m;
    const Lanes norm = (two * l + Lanes(5.0)) / (two * l + one);
    const Lanes first = (sum + one) / (gap + one);
    const Lanes second = (sum + two) / (gap + two);
    const Lanes third = (sum + two) * (gap + two) / ((sum + one) * (gap + one));
    alignas(64) double pole[kWidth];
    alignas(64) double equator[kWidth];
    xsimd::sqrt(norm * first * second).store_aligned(pole);
    xsimd::sqrt(norm * third).store_aligned(equator);
    for (std::size_t i = 0; i < kWidth && k + i < c.steps; ++i) {
      c.pole[k + i].g = pole[i];
      c.equator[k + i].g = -equator[i];
    }
  }
}

// Multiplies a growth by ratio, and sets the inverse of the one before.
void finish_growth(Growth* growth, std::size_t k, double ratio) {
  growth[k].g *= ratio;
  growth[k].inverse_before = k > 0 ? 1 / growth[k - 1].g : 0;
}

void prepare(const Column& c) {
  fill_eps(c);
  fill_growth(c);
  double here = 1;
  double before = 0;
  double product_before = 0;
  for (std::size_t k = 0; k < c.steps; ++k) {
    const double* eps = c.eps + 2 * k;
    const double product = eps[2] * eps[3];
    const double ahead = k == 0 ? 1 / product : before * (product_before / product);
    const double ratio = here / ahead;
    Step& s = c.table[k];
    s.a = ratio / product;
    s.b = -(eps[1] * eps[1] + eps[2] * eps[2]) * s.a;
    finish_growth(c.pole, k, ratio);
    finish_growth(c.equator, k, ratio);
    c.alpha[k] = here;
    before = here;
    here = ahead;
    product_before = product;
  }
}

// Degrees of the column.
std::size_t terms(const Column& c) { return static_cast<std::size_t>(c.degree - c.order) + 1; }

void spread(const Column& c, const double* coefficients) {
  const auto count = terms(c);
  for (std::size_t k = 0; k < c.steps; ++k) {
    const double* eps = c.eps + 2 * k;
    for (std::size_t i = 0; i < 2; ++i) {
      const double* a = coefficients + 4 * k + i;
      const double next = 2 * k + 2 < count ? eps[2] * a[4] : 0;
      c.table[k].even[i] = c.alpha[k] * (eps[1] * a[0] + next);
      c.table[k].odd[i] = 2 * k + 1 < count ? c.alpha[k] * a[2] : 0;
    }
  }
}

void gather(const Column& c, double* coefficients) {
  const auto count = terms(c);
  for (std::size_t k = 0; k < c.steps; ++k) {
    const double* eps = c.eps + 2 * k;
    for (std::size_t i = 0; i < 2; ++i) {
      double* a = coefficients + 4 * k + i;
      const double before = k > 0 ? eps[0] * c.alpha[k - 1] * c.table[k - 1].even[i] : 0;
      a[0] = eps[1] * c.alpha[k] * c.table[k].even[i] + before;
      if (2 * k + 1 < count) a[2] = c.alpha[k] * c.table[k].odd[i];
    }
  }
}

struct Synthesis {
  const Step* table;
  const Pairs& pairs;
  double* sums;
  Lanes sum[4][kSide];

  void begin(std::size_t /*at*/) {
    for (auto& row : sum) {
      for (Lanes& lanes : row) lanes = Lanes(0.0);
    }
  }
  void use(std::size_t k, const Lanes* values) {
    const Step& step = table[k];
    for (std::size_t v = 0; v < kSide; ++v) {
      sum[0][v] = xsimd::fma(Lanes(step.even[0]), values[v], sum[0][v]);
      sum[1][v] = xsimd::fma(Lanes(step.even[1]), values[v], sum[1][v]);
      sum[2][v] = xsimd::fma(Lanes(step.odd[0]), values[v], sum[2][v]);
      sum[3][v] = xsimd::fma(Lanes(step.odd[1]), values[v], sum[3][v]);
    }
  }
  void end(std::size_t at) {
    for (std::size_t v = 0; v < kSide; ++v) {
      const std::size_t p = at + v * kWidth;
      const Lanes z = Lanes::load_unaligned(pairs.z + p);
      for (std::size_t i = 0; i < 4; ++i) {
        const Lanes total = i < 2 ? sum[i][v] : z * sum[i][v];
        total.store_unaligned(sums + i * pairs.count + p);
      }
    }
  }
};

struct Analysis {
  const Pairs& pairs;
  const double* values;
  double* work;  // (steps, 4, kWidth)
  Lanes value[4][kSide];

  void begin(std::size_t at) {
    for (std::size_t v = 0; v < kSide; ++v) {
      const std::size_t p = at + v * kWidth;
      const Lanes z = Lanes::load_unaligned(pairs.z + p);
      for (std::size_t i = 0; i < 4; ++i) {
        value[i][v] = Lanes::load_unaligned(values + i * pairs.count + p);
        if (i >= 2) value[i][v] = value[i][v] * z;
      }
    }
  }
  void use(std::size_t k, const Lanes* p) {
    double* const sums = work + 4 * kWidth * k;
    for (std::size_t i = 0; i < 4; ++i) {
      Lanes sum = Lanes::load_unaligned(sums + i * kWidth);
      for (std::size_t v = 0; v < kSide; ++v) sum = xsimd::fma(value[i][v], p[v], sum);
      sum.store_unaligned(sums + i * kWidth);
    }
  }
  void end(std::size_t /*at*/) {}
};

void synthesis(const Column& column, const Pairs& pairs, double* sums) {
  run_blocks(column, pairs, Synthesis{column.table, pairs, sums, {}});
}

// totals[r] = the sum of the lanes of row r of work (rows, kWidth), in place; rows a multiple of kWidth.
void sum_lanes(double* work, std::size_t rows) {
  for (std::size_t r = 0; r < rows; r += kWidth) {
    Lanes row[kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) row[i] = Lanes::load_unaligned(work + (r + i) * kWidth);
    xsimd::haddp(row).store_unaligned(work + r);
  }
}

void analysis(const Column& column, const Pairs& pairs, const double* values, double* work) {
  const std::size_t rows = (4 * column.steps + kWidth - 1) / kWidth * kWidth;
  std::memset(work, 0, rows * kWidth * sizeof(double));
  run_blocks(column, pairs, Analysis{pairs, values, work, {}});
  sum_lanes(work, rows);
  for (std::size_t k = 0; k < column.steps; ++k) {
    Step& step = column.table[k];
    std::memcpy(step.even, work + 4 * k, sizeof step.even);
    std::memcpy(step.odd, work + 4 * k + 2, sizeof step.odd);
  }
}

}  // namespace

const Kernels kKernels{prepare, spread, synthesis, analysis, gather};

}  // namespace sh::numeric::rings::SH_RINGS_ISA
