// Tiles of a few values of a few records: from rows to columns, and back.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <cstring>
#include <utility>

#include "call.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace sh::batch::SH_BATCH_ISA {

using Four = float __attribute__((vector_size(16)));
using Two = double __attribute__((vector_size(16)));

inline Four load(const float* from) {
  Four v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline void store(float* to, const Four& v) { std::memcpy(to, &v, sizeof v); }

// Vectors that hold columns of four records each. Eight lanes serve AVX-512, too: wider shuffles take more time there.
#if defined(__AVX2__)
constexpr std::size_t kWide = 8;
using Wide = float __attribute__((vector_size(32)));
inline Wide load_wide(const float* from) { return _mm256_loadu_ps(from); }
inline void store(float* to, const Wide& v) { _mm256_storeu_ps(to, v); }
#else
constexpr std::size_t kWide = 4;
using Wide = Four;
inline Wide load_wide(const float* from) { return load(from); }
#endif

// The column, or the row of a block, of value k of a record.
struct InOrder {
  constexpr std::size_t operator()(std::size_t k) const { return k; }
};
// The same of interleaved records: value k is coefficient k / 3 of channel k % 3, which has so many values.
struct ByChannel {
  std::size_t values;
  constexpr std::size_t operator()(std::size_t k) const { return k % 3 * values + k / 3; }
};
template <std::size_t Values>
struct ByChannelOf {
  constexpr std::size_t operator()(std::size_t k) const { return ByChannel{Values}(k); }
};

// Record i of `count`; the first one stands for those that are missing.
template <class T>
[[gnu::always_inline]] inline const T* record_of(const T* records, std::size_t size, std::size_t count, std::size_t i) {
  return records + (i < count ? i * size : 0);
}

// Four values of each of kWide / 4 rows side by side; second: of the row 4 rows on.
inline Wide load_rows(const float* first, const float* second) {
#if defined(__AVX2__)
  return _mm256_insertf128_ps(_mm256_castps128_ps256(load(first)), load(second), 1);
#else
  static_cast<void>(second);
  return load(first);
#endif
}

// In each four lanes of the result the elements A, B, C, D of the four lanes of a (0 to 3) and of b (4 to 7).
template <std::size_t A, std::size_t B, std::size_t C, std::size_t D, std::size_t... Lane>
inline Wide pick(const Wide& a, const Wide& b, std::index_sequence<Lane...> /*lanes*/) {
  constexpr std::size_t kPicked[4] = {A, B, C, D};
  return __builtin_shufflevector(a, b, (kPicked[Lane % 4] % 4 + Lane / 4 * 4 + (kPicked[Lane % 4] < 4 ? 0 : kWide))...);
}
template <std::size_t A, std::size_t B, std::size_t C, std::size_t D>
inline Wide pick(const Wide& a, const Wide& b) {
  return pick<A, B, C, D>(a, b, std::make_index_sequence<kWide>());
}

// Records that go through tiles of kSide values at a time: kWide x 4 of float; of double 4 x 4, or 2 x 2.
#if defined(__AVX2__)
template <class T>
constexpr std::size_t kSide = 4;
template <class T>
constexpr std::size_t kTaken = sizeof(T) == sizeof(float) ? kWide : 4;
#else
template <class T>
constexpr std::size_t kSide = 16 / sizeof(T);
template <class T>
constexpr std::size_t kTaken = kSide<T>;
#endif

// Four vectors whose 4x4 tiles are transposed: in each four lanes, four rows become columns.
struct Tiles {
  Wide v[4];
};
[[gnu::always_inline]] inline Tiles transposed(const Wide& r0, const Wide& r1, const Wide& r2, const Wide& r3) {
  const Wide a = pick<0, 4, 1, 5>(r0, r1);
  const Wide b = pick<2, 6, 3, 7>(r0, r1);
  const Wide c = pick<0, 4, 1, 5>(r2, r3);
  const Wide d = pick<2, 6, 3, 7>(r2, r3);
  return {{pick<0, 1, 4, 5>(a, c), pick<2, 3, 6, 7>(a, c), pick<0, 1, 4, 5>(b, d), pick<2, 3, 6, 7>(b, d)}};
}

// Four values of kWide records, `size` values apart -> four columns. count: the records that are there.
[[gnu::always_inline]] inline Tiles load_columns(const float* records, std::size_t size, std::size_t count = kWide) {
  const auto rows = [=](std::size_t i) __attribute__((always_inline)) {
    return load_rows(record_of(records, size, count, i), record_of(records, size, count, i + 4));
  };
  return transposed(rows(0), rows(1), rows(2), rows(3));
}

// The same back, from four columns, to the first `count` records.
[[gnu::always_inline]] inline void join_columns(const Wide& c0, const Wide& c1, const Wide& c2, const Wide& c3,
                                                float* records, std::size_t size, std::size_t count = kWide) {
  const Tiles rows = transposed(c0, c1, c2, c3);  // record i, and record 4 + i beside it
#pragma GCC unroll 4
  for (std::size_t i = 0; i < 4; ++i) {
    if (i < count) store(records + i * size, __builtin_shufflevector(rows.v[i], rows.v[i], 0, 1, 2, 3));
  }
#if defined(__AVX2__)
#pragma GCC unroll 4
  for (std::size_t i = 0; i < 4; ++i) {
    if (4 + i < count) store(records + (4 + i) * size, __builtin_shufflevector(rows.v[i], rows.v[i], 4, 5, 6, 7));
  }
#endif
}
// Values of a record that a store takes.
template <class T>
constexpr std::size_t kRow = sizeof(T) == sizeof(float) ? kWide : kSide<T>;

// Tiles of kRow columns in a slab: as many as stay in the registers.
#if defined(__AVX512VL__)
template <class T>
constexpr std::size_t kTilesOfSlab = sizeof(T) == sizeof(float) ? 3 : 6;
#else
template <class T>
constexpr std::size_t kTilesOfSlab = sizeof(T) == sizeof(float) ? 2 : 3;
#endif

// Keeps stores in their order: those that continue each other are faster.
[[gnu::always_inline]] inline void keep_order() { asm volatile("" ::: "memory"); }

// So many tiles of kTaken lanes -> records of `size` values, record by record. columns(k): column k, a Wide. alone: the
// column before, which no tile holds, as an array; null: none. count: of the records that are there.
template <std::size_t Count, class Columns>
[[gnu::always_inline]] inline void join_slab(const Columns& columns, const float* alone, float* records,
                                             std::size_t size, std::size_t count = kTaken<float>) {
  Tiles left[Count];
  const auto tile = [&](std::size_t k) __attribute__((always_inline)) {
    return transposed(columns(k), columns(k + 1), columns(k + 2), columns(k + 3));
  };
#if defined(__AVX2__)
  Tiles right[Count];
#pragma GCC unroll 8
  for (std::size_t t = 0; t < Count; ++t) {
    left[t] = tile(8 * t);
    right[t] = tile(8 * t + 4);
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < 4; ++i) {
    if (alone != nullptr) records[-1] = alone[i];
#pragma GCC unroll 8
    for (std::size_t t = 0; t < Count; ++t) {
      store(records + 8 * t, Wide(__builtin_shufflevector(left[t].v[i], right[t].v[i], 0, 1, 2, 3, 8, 9, 10, 11)));
    }
    keep_order();
    if (i + 1 == count) return;
    records += size;
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < 4; ++i) {
    if (alone != nullptr) records[-1] = alone[4 + i];
#pragma GCC unroll 8
    for (std::size_t t = 0; t < Count; ++t) {
      store(records + 8 * t, Wide(__builtin_shufflevector(left[t].v[i], right[t].v[i], 4, 5, 6, 7, 12, 13, 14, 15)));
    }
    keep_order();
    if (5 + i == count) return;
    records += size;
  }
#else
#pragma GCC unroll 8
  for (std::size_t t = 0; t < Count; ++t) left[t] = tile(4 * t);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < 4; ++i) {
    if (alone != nullptr) records[-1] = alone[i];
#pragma GCC unroll 8
    for (std::size_t t = 0; t < Count; ++t) store(records + 4 * t, left[t].v[i]);
    keep_order();
    if (i + 1 == count) return;
    records += size;
  }
#endif
}

// A tile of double: kSide rows, `step` values apart, as columns.
#if defined(__AVX2__)
using Doubles = double __attribute__((vector_size(32)));
struct DoubleTile {
  Doubles v[4];
};
[[gnu::always_inline]] inline DoubleTile transposed(const Doubles& r0, const Doubles& r1, const Doubles& r2,
                                                    const Doubles& r3) {
  const Doubles a = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
  const Doubles b = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Doubles c = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
  const Doubles d = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  return {{__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(b, d, 0, 1, 4, 5),
           __builtin_shufflevector(a, c, 2, 3, 6, 7), __builtin_shufflevector(b, d, 2, 3, 6, 7)}};
}
inline Doubles load_doubles(const double* from) { return _mm256_loadu_pd(from); }
[[gnu::always_inline]] inline DoubleTile load_columns(const double* records, std::size_t size, std::size_t count = 4) {
  const auto row = [=](std::size_t i) __attribute__((always_inline)) {
    return load_doubles(record_of(records, size, count, i));
  };
  return transposed(row(0), row(1), row(2), row(3));
}
inline void store(double* to, const Doubles& v) { _mm256_storeu_pd(to, v); }
#else
using Doubles = Two;
struct DoubleTile {
  Two v[2];
};
[[gnu::always_inline]] inline DoubleTile transposed(const Two& r0, const Two& r1) {
  return {{__builtin_shufflevector(r0, r1, 0, 2), __builtin_shufflevector(r0, r1, 1, 3)}};
}
inline Two load_doubles(const double* from) {
  Two v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
[[gnu::always_inline]] inline DoubleTile load_columns(const double* records, std::size_t size) {
  return transposed(load_doubles(records), load_doubles(records + size));
}
inline void store(double* to, const Two& v) { std::memcpy(to, &v, sizeof v); }
#endif

template <std::size_t Count, class Columns>
[[gnu::always_inline]] inline void join_slab(const Columns& columns, const double* alone, double* records,
                                             std::size_t size, std::size_t count = kTaken<double>) {
  constexpr std::size_t kTile = kSide<double>;
  DoubleTile tiles[Count];
#pragma GCC unroll 8
  for (std::size_t t = 0; t < Count; ++t) {
    const std::size_t k = kTile * t;
#if defined(__AVX2__)
    tiles[t] = transposed(columns(k), columns(k + 1), columns(k + 2), columns(k + 3));
#else
    tiles[t] = transposed(columns(k), columns(k + 1));
#endif
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kTile; ++i) {
    if (alone != nullptr) records[-1] = alone[i];
#pragma GCC unroll 8
    for (std::size_t t = 0; t < Count; ++t) store(records + kTile * t, tiles[t].v[i]);
    keep_order();
    if (i + 1 == count) return;
    records += size;
  }
}

// A tile of columns -> kSide values of kTaken records.
template <class Columns>
[[gnu::always_inline]] inline void join_tile(const Columns& columns, float* records, std::size_t size) {
  join_columns(columns(0), columns(1), columns(2), columns(3), records, size);
}
template <class Columns>
[[gnu::always_inline]] inline void join_tile(const Columns& columns, double* records, std::size_t size) {
  join_slab<1>(columns, nullptr, records, size);
}

#if defined(__AVX2__)
// Ones in the first `count` lanes; count may be negative, or more than there are.
[[gnu::always_inline]] inline __m256i first_lanes(int count) {
  return _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}
inline void store_first(float* to, const Wide& v, int count) { _mm256_maskstore_ps(to, first_lanes(count), v); }
[[gnu::always_inline]] inline __m256i first_pairs(int count) {  // of lanes of 64 bits
  return _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), _mm256_setr_epi64x(0, 1, 2, 3));
}
inline void store_first(double* to, const Doubles& v, int count) { _mm256_maskstore_pd(to, first_pairs(count), v); }
#endif

inline Wide load_column(const float* from) { return load_wide(from); }
inline Doubles load_column(const double* from) { return load_doubles(from); }
// As many values as a column has; zeros for those that are missing.
template <class T, class Count>
[[gnu::always_inline]] inline auto load_column(const T* from, Count count) {
  decltype(load_column(from)) column{};
  std::memcpy(&column, from, count * sizeof(T));
  return column;
}
#if defined(__AVX2__)
inline Wide load_column(const float* from, std::size_t count) {
  return _mm256_maskload_ps(from, first_lanes(int(count)));
}
inline Doubles load_column(const double* from, std::size_t count) {
  return _mm256_maskload_pd(from, first_pairs(int(count)));
}
#endif

// Whether load_triples takes records of three values, kTaken of them; elsewhere rows of a transpose serve.
struct Triple {
  Wide x, y, z;
};
#if defined(__AVX2__)
template <class T>
constexpr bool kHasTriples = true;

[[gnu::always_inline]] inline Triple triples(const Wide& r0, const Wide& r1, const Wide& r2) {
  const Wide x = _mm256_blend_ps(_mm256_blend_ps(r0, r1, 0x92), r2, 0x24);  // 0 9 18 3 12 21 6 15
  const Wide y = _mm256_blend_ps(_mm256_blend_ps(r0, r1, 0x24), r2, 0x49);  // 16 1 10 19 4 13 22 7
  const Wide z = _mm256_blend_ps(_mm256_blend_ps(r0, r1, 0x49), r2, 0x92);  // 8 17 2 11 20 5 14 23
  return {__builtin_shufflevector(x, x, 0, 3, 6, 1, 4, 7, 2, 5), __builtin_shufflevector(y, y, 1, 4, 7, 2, 5, 0, 3, 6),
          __builtin_shufflevector(z, z, 2, 5, 0, 3, 6, 1, 4, 7)};
}
inline Triple load_triples(const float* records) {
  return triples(load_wide(records), load_wide(records + 8), load_wide(records + 16));
}
// Those of `count` records; zeros for those that are missing.
inline Triple load_triples(const float* records, std::size_t count) {
  const auto load = [=](int at) __attribute__((always_inline)) {
    return _mm256_maskload_ps(records + at, first_lanes(3 * int(count) - at));
  };
  return triples(load(0), load(8), load(16));
}
struct DoubleTriple {
  Doubles x, y, z;
};
[[gnu::always_inline]] inline DoubleTriple triples(const Doubles& r0, const Doubles& r1, const Doubles& r2) {
  const __m256d first = _mm256_permute2f128_pd(r0, r1, 0x30);   // 0 1 6 7
  const __m256d second = _mm256_permute2f128_pd(r0, r2, 0x21);  // 2 3 8 9
  const __m256d third = _mm256_permute2f128_pd(r1, r2, 0x30);   // 4 5 10 11
  return {_mm256_shuffle_pd(first, second, 0xa),                // 0 3 6 9
          _mm256_shuffle_pd(first, third, 0x5),                 // 1 4 7 10
          _mm256_shuffle_pd(second, third, 0xa)};               // 2 5 8 11
}
inline DoubleTriple load_triples(const double* records) {
  return triples(load_doubles(records), load_doubles(records + 4), load_doubles(records + 8));
}
inline DoubleTriple load_triples(const double* records, std::size_t count) {
  const auto load = [=](int at) __attribute__((always_inline)) {
    return _mm256_maskload_pd(records + at, first_pairs(3 * int(count) - at));
  };
  return triples(load(0), load(4), load(8));
}
#else
template <class T>
constexpr bool kHasTriples = sizeof(T) == sizeof(float);

inline Triple load_triples(const float* records) {
  const Four r0 = load(records);
  const Four r1 = load(records + 4);
  const Four r2 = load(records + 8);
  const Four a = __builtin_shufflevector(r0, r1, 0, 3, 6, 6);
  const Four b = __builtin_shufflevector(r0, r1, 1, 4, 7, 7);
  const Four c = __builtin_shufflevector(r0, r1, 2, 5, 5, 5);
  return {__builtin_shufflevector(a, r2, 0, 1, 2, 5), __builtin_shufflevector(b, r2, 0, 1, 2, 6),
          __builtin_shufflevector(c, r2, 0, 1, 4, 7)};
}
#endif

// kTaken records of three values -> a part of a block.
template <class T>
inline void spread_triples(const T* records, T* block) {
  const auto columns = load_triples(records);
  store(block, columns.x);
  store(block + kBlock<T>, columns.y);
  store(block + 2 * kBlock<T>, columns.z);
}

// Three values of kWide records -> rows of the records.
[[gnu::always_inline]] inline Triple rows_of_triples(const Wide& a, const Wide& b, const Wide& c) {
  const Wide a0b0a1b1 = pick<0, 4, 1, 5>(a, b);
  const Wide a2b2a3b3 = pick<2, 6, 3, 7>(a, b);
  const Wide c0a1c2a3 = pick<0, 5, 2, 7>(c, a);
  const Wide b1c1b3c3 = pick<1, 5, 3, 7>(b, c);
  const Wide first = pick<0, 1, 4, 5>(a0b0a1b1, c0a1c2a3);
  const Wide second = pick<0, 1, 4, 5>(b1c1b3c3, a2b2a3b3);
  const Wide third = pick<2, 3, 6, 7>(c0a1c2a3, b1c1b3c3);
#if defined(__AVX2__)
  return {__builtin_shufflevector(first, second, 0, 1, 2, 3, 8, 9, 10, 11),
          __builtin_shufflevector(third, first, 0, 1, 2, 3, 12, 13, 14, 15),
          __builtin_shufflevector(second, third, 4, 5, 6, 7, 12, 13, 14, 15)};
#else
  return {first, second, third};
#endif
}
[[gnu::always_inline]] inline void store_triples(const Wide& a, const Wide& b, const Wide& c, float* records) {
  const Triple rows = rows_of_triples(a, b, c);
  store(records, rows.x);
  store(records + kWide, rows.y);
  store(records + 2 * kWide, rows.z);
}
#if defined(__AVX2__)
// The first `count` of them.
[[gnu::always_inline]] inline void store_triples(const Wide& a, const Wide& b, const Wide& c, float* records,
                                                 std::size_t count) {
  const Triple rows = rows_of_triples(a, b, c);
  store_first(records, rows.x, 3 * int(count));
  store_first(records + kWide, rows.y, 3 * int(count) - 8);
  store_first(records + 2 * kWide, rows.z, 3 * int(count) - 16);
}
#endif

// Three values of a block of kWide lanes -> the records.
inline void join_triples(const float* block, float* records) {
  store_triples(load_wide(block), load_wide(block + kBlock<float>), load_wide(block + 2 * kBlock<float>), records);
}
inline void join_triples(const double* /*block*/, double* /*records*/) {}  // tiles serve there

}  // namespace sh::batch::SH_BATCH_ISA
