// SIMD lanes across pairs of rings, and the recurrence that runs in them; included by kernels.cpp only, which is
// compiled once per instruction set. References: numeric/methods/legendre_rows.hpp.
#pragma once

#include <cstdint>
#include <cstring>
#include <xsimd/xsimd.hpp>

#include "numeric/oracle/rings/call.hpp"

namespace sh::numeric::rings::SH_RINGS_ISA {

using Lanes = xsimd::batch<double>;
inline constexpr std::size_t kWidth = Lanes::size;
// Registers of pairs that run side by side, to hide the latency of the recurrence; their number is bounded by that of registers.
inline constexpr std::size_t kSide = kWidth == 8 ? 4 : 2;
inline constexpr std::size_t kBlock = kSide * kWidth;
static_assert(kPadding % kBlock == 0);
// Steps between looks at the size of the values, which grow by less than 4 m + 8 a step.
inline constexpr std::size_t kStride = 8;

// 2^e, -1022 <= e <= 1023.
inline double power_of_two(int e) {
  const std::uint64_t bits = static_cast<std::uint64_t>(1023 + e) << 52;
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// A block of pairs: p_k, the second value that the recurrence keeps, the square that it runs in, the level.
struct State {
  Lanes current[kSide], kept[kSide], square[kSide], level[kSide];
};

// p' = (a z^2 + b) p - p_before; keeps p_before.
struct Plain {
  const Column& column;

  void advance(std::size_t k, State& s, std::size_t v) const {
    const Step& step = column.table[k];
    const Lanes t = xsimd::fma(Lanes(step.a), s.square[v], Lanes(step.b));
    const Lanes next = xsimd::fms(t, s.current[v], s.kept[v]);
    s.kept[v] = s.current[v];
    s.current[v] = next;
  }
};

// d' = d / g_before - a q p, p' = g p + d'; keeps d.
struct Anchored {
  const Column& column;
  const Growth* growth;

  void advance(std::size_t k, State& s, std::size_t v) const {
    const Lanes t = Lanes(column.table[k].a) * s.square[v];
    s.kept[v] = xsimd::fnma(t, s.current[v], Lanes(growth[k].inverse_before) * s.kept[v]);
    s.current[v] = xsimd::fma(Lanes(growth[k].g), s.current[v], s.kept[v]);
  }
};

// p_0; the square of z or sine, whichever `root` is, times `sign`.
inline State start(const Column& column, const Pairs& pairs, std::size_t at, const double* root, double sign) {
  alignas(64) double values[kBlock];
  alignas(64) double levels[kBlock];
  const double first = column.start_mantissa / column.eps[1];
  for (std::size_t i = 0; i < kBlock; ++i) {
    const std::size_t p = at + i;
    const auto exponent = static_cast<int>(pairs.low.exponent[p] + pairs.high.exponent[p]);
    const int level = exponent >= -kLevel / 2 ? 0 : -((kLevel / 2 - exponent) / kLevel);
    values[i] = first * (pairs.low.mantissa[p] * pairs.high.mantissa[p]) * power_of_two(exponent - kLevel * level);
    levels[i] = level;
  }
  State s;
  for (std::size_t v = 0; v < kSide; ++v) {
    const Lanes r = Lanes::load_unaligned(root + at + v * kWidth);
    s.square[v] = Lanes(sign) * (r * r);
    s.current[v] = Lanes::load_aligned(values + v * kWidth);
    s.kept[v] = Lanes(0.0);
    s.level[v] = Lanes::load_aligned(levels + v * kWidth);
  }
  return s;
}

// Lifts lanes that have grown beyond 2^(kLevel / 2) by a level.
inline void lift(State& s) {
  const Lanes high(power_of_two(kLevel / 2));
  const Lanes down(power_of_two(-kLevel));
  for (std::size_t v = 0; v < kSide; ++v) {
    const auto grown = (xsimd::abs(s.current[v]) > high) && (s.level[v] < Lanes(0.0));
    s.current[v] = xsimd::select(grown, s.current[v] * down, s.current[v]);
    s.kept[v] = xsimd::select(grown, s.kept[v] * down, s.kept[v]);
    s.level[v] = xsimd::select(grown, s.level[v] + Lanes(1.0), s.level[v]);
  }
}

inline bool all_below(const State& s, double level) {
  bool all = true;
  for (const Lanes& lanes : s.level) all = all && xsimd::all(lanes < Lanes(level));
  return all;
}

inline bool all_plain(const State& s) {
  bool all = true;
  for (const Lanes& lanes : s.level) all = all && xsimd::all(lanes == Lanes(0.0));
  return all;
}

// The factor of the values of each lane: 1, 2^-kLevel, or 0 from level -2 on, where they are below 2^-1152.
inline void factors(const State& s, Lanes* factor) {
  const Lanes down(power_of_two(-kLevel));
  for (std::size_t v = 0; v < kSide; ++v) {
    const Lanes low = xsimd::select(s.level[v] == Lanes(-1.0), down, Lanes(0.0));
    factor[v] = xsimd::select(s.level[v] == Lanes(0.0), Lanes(1.0), low);
  }
}

// Runs the recurrence to its end (inlined, so that a block stays in registers): use(k, values of the block) for every
// step but the first ones, whose values are all below the smallest double.
template <class Recurrence, class Use>
[[gnu::always_inline]] inline void run(const Recurrence& recurrence, const State& begin, const Use& use) {
  State s = begin;  // in registers
  const std::size_t steps = recurrence.column.steps;
  const auto stop = [steps](std::size_t k) { return k + kStride < steps ? k + kStride : steps; };
  const auto advance = [&](std::size_t k) {
    for (std::size_t v = 0; v < kSide; ++v) recurrence.advance(k, s, v);
  };
  std::size_t k = 0;
  for (; k < steps && all_below(s, -1); lift(s)) {
    for (const std::size_t end = stop(k); k < end; ++k) advance(k);
  }
  for (; k < steps && !all_plain(s); lift(s)) {
    Lanes factor[kSide];
    factors(s, factor);
    for (const std::size_t end = stop(k); k < end; ++k) {
      Lanes values[kSide];
      for (std::size_t v = 0; v < kSide; ++v) values[v] = s.current[v] * factor[v];
      use(k, values);
      advance(k);
    }
  }
  for (; k < steps; ++k) {
    use(k, s.current);
    advance(k);
  }
}

// The same for every block of pairs, each by the recurrence that suits it: begin(at), use(at, k, values), end(at).
template <class Block>
[[gnu::always_inline]] inline void run_blocks(const Column& column, const Pairs& pairs, Block block) {
  for (std::size_t at = pairs.first; at < pairs.count; at += kBlock) {
    const auto use = [&](std::size_t k, const Lanes* values) { block.use(k, values); };
    block.begin(at);
    if (pairs.z[at + kBlock - 1] < kNearEquator) {
      run(Anchored{column, column.equator}, start(column, pairs, at, pairs.z, -1), use);
    } else if (pairs.sine[at] < kNearPole) {
      run(Anchored{column, column.pole}, start(column, pairs, at, pairs.sine, 1), use);
    } else {
      run(Plain{column}, start(column, pairs, at, pairs.z, 1), use);
    }
    block.end(at);
  }
}

}  // namespace sh::numeric::rings::SH_RINGS_ISA
