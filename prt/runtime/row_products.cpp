// The products of rows and a light on one instruction set: SH_RELIGHT_ISA is baseline, avx2 or avx512.
#include "prt/runtime/row_products.hpp"

#include <cstring>
#include <utility>

namespace sh::prt::SH_RELIGHT_ISA {

extern const RowProductsOn kRowProducts;

namespace {

#if defined(__AVX512F__)
constexpr std::size_t kLanes = 16;
#else
constexpr std::size_t kLanes = 8;  // two registers without AVX
#endif
constexpr std::size_t kFour = 4;
using Four [[gnu::vector_size(16)]] = float;
using Lanes [[gnu::vector_size(kLanes * 4)]] = float;

[[gnu::always_inline]] inline void load(const float* from, Four& to) { std::memcpy(&to, from, sizeof to); }
[[gnu::always_inline]] inline void store(const Four& from, float* to) { std::memcpy(to, &from, sizeof from); }

/// Loads four values from each of kLanes / 4 rows, which are 4 rows apart, side by side.
[[gnu::always_inline]] inline void load_fours(const float* const* row, std::size_t at, Lanes& out) {
  Four four[kLanes / kFour];
  for (std::size_t q = 0; q < kLanes / kFour; ++q) load(row[q] + at, four[q]);
#if defined(__AVX512F__)
  const auto low = __builtin_shufflevector(four[0], four[1], 0, 1, 2, 3, 4, 5, 6, 7);
  const auto high = __builtin_shufflevector(four[2], four[3], 0, 1, 2, 3, 4, 5, 6, 7);
  out = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#else
  out = __builtin_shufflevector(four[0], four[1], 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/// The element of two vectors side by side that lane `lane` takes. Each four takes the elements `picked` from its own
/// four of the first vector (0 .. 3) and of the second (4 .. 7).
constexpr std::size_t source(std::size_t picked, std::size_t lane) {
  return lane / kFour * kFour + picked % kFour + (picked < kFour ? 0 : kLanes);
}

template <std::size_t A, std::size_t B, std::size_t C, std::size_t D, std::size_t... Four>
[[gnu::always_inline]] inline void pick(const Lanes& a, const Lanes& b, Lanes& out,
                                        std::index_sequence<Four...> /*lanes*/) {
  constexpr std::size_t kPicked[kFour] = {A, B, C, D};
  out = __builtin_shufflevector(a, b, source(kPicked[Four % kFour], Four)...);
}

template <std::size_t A, std::size_t B, std::size_t C, std::size_t D>
[[gnu::always_inline]] inline void pick(const Lanes& a, const Lanes& b, Lanes& out) {
  pick<A, B, C, D>(a, b, out, std::make_index_sequence<kLanes>());
}

/// Four consecutive values of kLanes rows -> four vectors, lanes are rows.
[[gnu::always_inline]] inline void transpose(const float* row, std::size_t stride, Lanes* column) {
  Lanes rows[kFour];
  Lanes low[2];
  Lanes high[2];
  const float* base[kLanes / kFour];
  for (std::size_t q = 0; q < kLanes / kFour; ++q) base[q] = row + kFour * q * stride;
  for (std::size_t k = 0; k < kFour; ++k) load_fours(base, k * stride, rows[k]);
  for (std::size_t k = 0; k < 2; ++k) {
    pick<0, 4, 1, 5>(rows[2 * k], rows[2 * k + 1], low[k]);
    pick<2, 6, 3, 7>(rows[2 * k], rows[2 * k + 1], high[k]);
  }
  pick<0, 1, 4, 5>(low[0], low[1], column[0]);
  pick<2, 3, 6, 7>(low[0], low[1], column[1]);
  pick<0, 1, 4, 5>(high[0], high[1], column[2]);
  pick<2, 3, 6, 7>(high[0], high[1], column[3]);
}

/// The hardware prefetcher misses rows that are read side by side; the loop prefetches them this far ahead.
constexpr std::size_t kBytesAhead = 8192;
constexpr std::size_t kFloatsALine = 16;

/// The sums of kLanes vertices. Transfers and Lights: 1, or Sums.
template <std::size_t Sums, std::size_t Transfers, std::size_t Lights>
struct Summer {
  const RowProducts& rows;
  const float* row;    // of the first vertex
  const float* ahead;  // of a later one
  bool is_whole;       // every value of a row is used
  Lanes sum[Sums] = {};

  /// The terms i + skipped .. i + 3.
  [[gnu::always_inline]] void add(std::size_t i, std::size_t skipped) {
    Lanes column[Transfers][kFour];
    for (std::size_t t = 0; t < Transfers; ++t) transpose(row + t * rows.transfer_step + i, rows.stride, column[t]);
    for (std::size_t k = 0; k < kFour; ++k) {
      if (k < skipped) continue;
      for (std::size_t s = 0; s < Sums; ++s) {
        sum[s] += column[s % Transfers][k] * rows.light[s % Lights * rows.light_step + i + k];
      }
    }
  }

  /// Prefetches every cache line of the rows from `ahead` on.
  [[gnu::always_inline]] void fetch() {
    const std::size_t length = is_whole ? kLanes * rows.stride : rows.coefficients;
    for (std::size_t k = 0; k < (is_whole ? 1 : kLanes); ++k) {
      for (std::size_t t = 0; t < (is_whole ? 1 : Transfers); ++t) {
        const float* from = ahead + k * rows.stride + t * rows.transfer_step;
        for (std::size_t i = 0; i < length; i += kFloatsALine) __builtin_prefetch(from + i);
      }
    }
  }

  [[gnu::always_inline]] void run() {
    fetch();
    std::size_t i = 0;
    for (; i + kFour <= rows.coefficients; i += kFour) add(i, 0);
    if (i < rows.coefficients) add(rows.coefficients - kFour, kFour - (rows.coefficients - i));
  }
};

/// One sum of one vertex.
float sum_one(const RowProducts& rows, std::size_t vertex, std::size_t s) {
  const float* transfer = rows.transfer + vertex * rows.stride + s * rows.transfer_step;
  const float* light = rows.light + s * rows.light_step;
  float sum = 0.0F;
  for (std::size_t i = 0; i < rows.coefficients; ++i) sum += transfer[i] * light[i];
  return sum;
}

/// Calls lanes(vertex, sums) for kLanes vertices at a time and one(vertex) for the remaining vertices.
template <std::size_t Sums, std::size_t Transfers, std::size_t Lights, class DoLanes, class DoOne>
[[gnu::always_inline]] inline void for_every_vertex(const RowProducts& rows, std::size_t count, const DoLanes& lanes,
                                                    const DoOne& one) {
  const std::size_t far = kBytesAhead / (sizeof(float) * rows.stride);
  const bool is_whole = Transfers * rows.coefficients == rows.stride;
  std::size_t v = 0;
  for (; rows.coefficients >= kFour && v + kLanes <= count; v += kLanes) {
    const std::size_t later = v + far + kLanes <= count ? v + far : v;
    Summer<Sums, Transfers, Lights> summer{rows, rows.transfer + v * rows.stride, rows.transfer + later * rows.stride,
                                           is_whole};
    summer.run();
    lanes(v, summer.sum);
  }
  for (; v < count; ++v) one(v);
}

/// Calls use(k, values k .. k+3) for the 3 kLanes values of three channels in memory's order.
template <class Use, std::size_t... Q>
[[gnu::always_inline]] inline void interleave(const Lanes& r, const Lanes& g, const Lanes& b, const Use& use,
                                              std::index_sequence<Q...> /*fours*/) {
  Lanes rg;
  Lanes gb;
  Lanes br;
  Lanes part[3];
  pick<0, 4, 1, 5>(r, g, rg);         // r0 g0 r1 g1
  pick<0, 5, 0, 5>(b, r, br);         // b0 r1
  pick<0, 1, 4, 5>(rg, br, part[0]);  // r0 g0 b0 r1
  pick<1, 5, 1, 5>(g, b, gb);         // g1 b1
  pick<2, 6, 2, 6>(r, g, rg);         // r2 g2
  pick<0, 1, 4, 5>(gb, rg, part[1]);  // g1 b1 r2 g2
  pick<2, 7, 2, 7>(b, r, br);         // b2 r3
  pick<3, 7, 3, 7>(g, b, gb);         // g3 b3
  pick<0, 1, 4, 5>(br, gb, part[2]);  // b2 r3 g3 b3
  for (std::size_t k = 0; k < 3; ++k) {
    (use((3 * Q + k) * kFour,
         __builtin_shufflevector(part[k], part[k], kFour * Q, kFour * Q + 1, kFour * Q + 2, kFour * Q + 3)),
     ...);
  }
}

template <std::size_t Sums, std::size_t Transfers, std::size_t Lights, bool Colored>
void color_rows(const RowProducts& rows, std::size_t count, const float* color, float* out) {
  const auto lanes = [&](std::size_t v, const Lanes* sum) __attribute__((always_inline)) {
    const auto use = [&](std::size_t k, Four value) __attribute__((always_inline)) {
      if constexpr (Colored) {
        Four factor;
        load(color + 3 * v + k, factor);
        value *= factor;
      }
      store(value, out + 3 * v + k);
    };
    interleave(sum[0], sum[1 % Sums], sum[2 % Sums], use, std::make_index_sequence<kLanes / kFour>());
  };
  const auto one = [&](std::size_t v) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float sum = sum_one(rows, v, c % Sums);
      out[3 * v + c] = Colored ? sum * color[3 * v + c] : sum;
    }
  };
  for_every_vertex<Sums, Transfers, Lights>(rows, count, lanes, one);
}

template <bool Colored>
void color_any(const RowProducts& rows, std::size_t count, const float* color, float* out) {
  if (rows.sums == 1) return color_rows<1, 1, 1, Colored>(rows, count, color, out);
  if (rows.transfer_step == 0) return color_rows<3, 1, 3, Colored>(rows, count, color, out);
  if (rows.light_step == 0) return color_rows<3, 3, 1, Colored>(rows, count, color, out);
  color_rows<3, 3, 3, Colored>(rows, count, color, out);
}

void color_products(const RowProducts& rows, std::size_t count, const float* color, float* out) {
  color != nullptr ? color_any<true>(rows, count, color, out) : color_any<false>(rows, count, color, out);
}

void gray_products(const RowProducts& rows, std::size_t count, float* out) {
  const auto lanes = [&](std::size_t v, const Lanes* sum) __attribute__((always_inline)) {
    std::memcpy(out + v, sum, sizeof *sum);
  };
  for_every_vertex<1, 1, 1>(rows, count, lanes, [&](std::size_t v) { out[v] = sum_one(rows, v, 0); });
}

}  // namespace

#define SH_TEXT_OF(name) #name
#define SH_TEXT(name) SH_TEXT_OF(name)
constinit const RowProductsOn kRowProducts = {SH_TEXT(SH_RELIGHT_ISA), color_products, gray_products};

}  // namespace sh::prt::SH_RELIGHT_ISA
