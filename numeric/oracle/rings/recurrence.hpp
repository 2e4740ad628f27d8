// SIMD lanes across pairs of rings, and the recurrence that runs in them; included by kernels.cpp only, which is
// compiled once per instruction set. References: numeric/methods/legendre_rows.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "numeric/oracle/rings/call.hpp"

namespace sh::numeric::rings::SH_RINGS_ISA {

using Lanes = xsimd::batch<double>;
inline constexpr std::size_t kWidth = Lanes::size;
static_assert(kPadding % kWidth == 0);
// Steps between looks at the size of the values, which grow by less than 4 m + 8 a step.
inline constexpr std::size_t kStride = 8;
static_assert(kPadding % kStride == 0);

// Calls f(std::integral_constant<std::size_t, i>) for i = 0 .. N-1, unrolled.
template <std::size_t N, class F>
[[gnu::always_inline]] inline void repeat(const F& f) {
  [&]<std::size_t... kI>(std::index_sequence<kI...>) { (f(std::integral_constant<std::size_t, kI>{}), ...); }
  (std::make_index_sequence<N>{});
}

// 2^e, lane by lane; e integers within -1022 .. 1023.
inline Lanes power_of_two(const Lanes& e) {
  constexpr double kIntegers = 0x1p52;  // the last bits of its neighbors count
  const auto bits = xsimd::bitwise_cast<xsimd::batch<std::uint64_t>>(e + Lanes(kIntegers + 1023));
  return xsimd::bitwise_cast<Lanes>(bits << 52);
}

inline constexpr double kHigh = 0x1p384;
inline constexpr double kDown = 0x1p-768;
static_assert(kLevel == 768);

// A register of pairs: p_k, the second value that the recurrence keeps, the square that it runs in, the level.
struct Register {
  Lanes current, kept, square, level;

  // Lifts lanes that have grown beyond kHigh by a level.
  void lift() {
    const auto grown = (xsimd::abs(current) > Lanes(kHigh)) && (level < Lanes(0.0));
    current = xsimd::select(grown, current * Lanes(kDown), current);
    kept = xsimd::select(grown, kept * Lanes(kDown), kept);
    level = xsimd::select(grown, level + Lanes(1.0), level);
  }
  // Whether all values are too small to count.
  [[nodiscard]] bool is_below(const Tail& tail) const { return xsimd::all(level < Lanes(tail.lowest)); }
  // Whether all values stand for themselves.
  [[nodiscard]] bool is_plain() const { return xsimd::all(level == Lanes(0.0)); }
  // What turns values into what they stand for, or into 0 where that is too small.
  [[nodiscard]] Lanes factor(const Tail& tail) const {
    return xsimd::select(level == Lanes(0.0), Lanes(1.0),
                         xsimd::select(level == Lanes(-1.0), Lanes(tail.down), Lanes(0.0)));
  }
};

// p' = (a z^2 + b) p - p_before; keeps p_before.
struct Plain {
  explicit Plain(const Tables& tables) : a(tables.a), b(tables.b) {}
  const double* a;
  const double* b;

  static constexpr bool kSwaps = true;  // next: p' takes the place of p_before
  static constexpr double kSign = 1;
  static const double* root(const Pairs& pairs) { return pairs.z; }

  [[gnu::always_inline]] void next(std::size_t k, const Lanes& square, const Lanes& current, Lanes& kept) const {
    const Lanes t = xsimd::fma(Lanes(a[k]), square, Lanes(b[k]));
    kept = xsimd::fms(t, current, kept);
  }
  [[gnu::always_inline]] void advance(std::size_t k, Register& r) const {
    next(k, r.square, r.current, r.kept);
    std::swap(r.current, r.kept);
  }
};

// d' = d / g_before - a q p, p' = g p + d'; keeps d.
template <Growth Tables::*Anchor>
struct Anchored {
  explicit Anchored(const Tables& tables) : a(tables.a), growth(tables.*Anchor) {}
  const double* a;
  Growth growth;

  static constexpr bool kSwaps = false;
  static constexpr bool kAtPole = Anchor == &Tables::pole;
  static constexpr double kSign = kAtPole ? 1 : -1;
  static const double* root(const Pairs& pairs) { return kAtPole ? pairs.sine : pairs.z; }

  [[gnu::always_inline]] void next(std::size_t k, const Lanes& square, Lanes& current, Lanes& kept) const {
    const Lanes t = Lanes(a[k]) * square;
    kept = xsimd::fnma(t, current, Lanes(growth.inverse_before[k]) * kept);
    current = xsimd::fma(Lanes(growth.g[k]), current, kept);
  }
  [[gnu::always_inline]] void advance(std::size_t k, Register& r) const { next(k, r.square, r.current, r.kept); }
};

// p_0 of the pairs from `at` on.
template <class Recurrence>
Register start(const Column& column, const Pairs& pairs, std::size_t at) {
  const auto load = [at](const double* from) { return Lanes::load_unaligned(from + at); };
  const Lanes exponent = load(pairs.low.exponent) + load(pairs.high.exponent);
  Register r;
  r.level = -xsimd::floor((Lanes(0.5 * kLevel) - exponent) * Lanes(1.0 / kLevel));
  const double first = column.start_mantissa / column.tables.odd[0];
  r.current = Lanes(first) * (load(pairs.low.mantissa) * load(pairs.high.mantissa)) *
              power_of_two(exponent - Lanes(kLevel) * r.level);
  r.kept = Lanes(0.0);
  const Lanes root = load(Recurrence::root(pairs));
  r.square = Lanes(Recurrence::kSign) * (root * root);
  return r;
}

// f(recurrence, begin, end) for the pairs of every recurrence, from pairs.first to pairs.count.
template <class F>
[[gnu::always_inline]] inline void for_recurrences(const Column& column, const Pairs& pairs, const F& f) {
  const std::size_t plain = std::clamp(pairs.plain, pairs.first, pairs.count);
  const std::size_t equator = std::clamp(pairs.equator, pairs.first, pairs.count);
  f(Anchored<&Tables::pole>(column.tables), pairs.first, plain);
  f(Plain(column.tables), plain, equator);
  f(Anchored<&Tables::equator>(column.tables), equator, pairs.count);
}

}  // namespace sh::numeric::rings::SH_RINGS_ISA
