// Moves records between layouts: plain to blocked and back by 4x4 transposes, and past the cache.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "call.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace sh::batch::SH_BATCH_ISA {

using Four = float __attribute__((vector_size(16)));
using Two = double __attribute__((vector_size(16)));
using Words = std::int32_t __attribute__((vector_size(16)));

inline Four load(const float* from) {
  Four v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline Two load(const double* from) {
  Two v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

// Rows of `from` (4x4, rows `from_step` values apart) become columns of `to`.
inline void transpose(const float* from, std::size_t from_step, float* to, std::size_t to_step) {
  const Four r0 = load(from);
  const Four r1 = load(from + from_step);
  const Four r2 = load(from + 2 * from_step);
  const Four r3 = load(from + 3 * from_step);
  const Four a = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
  const Four b = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
  const Four c = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
  const Four d = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
  const Four columns[4] = {__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(a, c, 2, 3, 6, 7),
                           __builtin_shufflevector(b, d, 0, 1, 4, 5), __builtin_shufflevector(b, d, 2, 3, 6, 7)};
  for (std::size_t i = 0; i < 4; ++i) std::memcpy(to + i * to_step, &columns[i], sizeof columns[i]);
}
inline void transpose(const double* from, std::size_t from_step, double* to, std::size_t to_step) {
  const Two r0 = load(from);
  const Two r1 = load(from + from_step);
  const Two columns[2] = {__builtin_shufflevector(r0, r1, 0, 2), __builtin_shufflevector(r0, r1, 1, 3)};
  for (std::size_t i = 0; i < 2; ++i) std::memcpy(to + i * to_step, &columns[i], sizeof columns[i]);
}

// Vectors that hold columns of four records each. Eight lanes serve AVX-512, too: wider shuffles take more time there.
#if defined(__AVX2__)
constexpr std::size_t kWide = 8;
#else
constexpr std::size_t kWide = 4;
#endif
using Wide = float __attribute__((vector_size(4 * kWide)));

// Four values of each of kWide / 4 rows, which are 4 rows apart, side by side.
inline Wide load_rows(const float* from, std::size_t step) {
#if defined(__AVX2__)
  return _mm256_insertf128_ps(_mm256_castps128_ps256(load(from)), load(from + 4 * step), 1);
#else
  static_cast<void>(step);
  return load(from);
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

// Records that to_block takes at a time, and their values: kWide x 4 of float, 2 x 2 of double.
template <class T>
constexpr std::size_t kSide = 16 / sizeof(T);
template <class T>
constexpr std::size_t kTaken = sizeof(T) == sizeof(float) ? kWide : 2;

// Four values of kWide records, `size` values apart -> four columns.
inline void load_columns(const float* records, std::size_t size, Wide* columns) {
  const Wide r0 = load_rows(records, size);
  const Wide r1 = load_rows(records + size, size);
  const Wide r2 = load_rows(records + 2 * size, size);
  const Wide r3 = load_rows(records + 3 * size, size);
  const Wide a = pick<0, 4, 1, 5>(r0, r1);
  const Wide b = pick<2, 6, 3, 7>(r0, r1);
  const Wide c = pick<0, 4, 1, 5>(r2, r3);
  const Wide d = pick<2, 6, 3, 7>(r2, r3);
  columns[0] = pick<0, 1, 4, 5>(a, c);
  columns[1] = pick<2, 3, 6, 7>(a, c);
  columns[2] = pick<0, 1, 4, 5>(b, d);
  columns[3] = pick<2, 3, 6, 7>(b, d);
}

// kTaken records of kSide values, `size` values apart -> a part of a block.
inline void spread_records(const float* records, std::size_t size, float* block) {
  Wide columns[4];
  load_columns(records, size, columns);
  for (std::size_t k = 0; k < 4; ++k) std::memcpy(block + k * kBlock<float>, &columns[k], sizeof columns[k]);
}
inline void spread_records(const double* records, std::size_t size, double* block) {
  transpose(records, size, block, kBlock<double>);
}

// Four records of three values -> four lanes of three values of a block.
inline void spread_triples(const float* records, float* block) {
  const Four v0 = load(records);
  const Four v1 = load(records + 4);
  const Four v2 = load(records + 8);
  const Four a = __builtin_shufflevector(v0, v1, 0, 3, 6, 6);
  const Four b = __builtin_shufflevector(v0, v1, 1, 4, 7, 7);
  const Four c = __builtin_shufflevector(v0, v1, 2, 5, 5, 5);
  const Four values[3] = {__builtin_shufflevector(a, v2, 0, 1, 2, 5), __builtin_shufflevector(b, v2, 0, 1, 2, 6),
                          __builtin_shufflevector(c, v2, 0, 1, 4, 7)};
  for (std::size_t k = 0; k < 3; ++k) std::memcpy(block + k * kBlock<float>, &values[k], sizeof values[k]);
}
inline void spread_triples(const double* /*records*/, double* /*block*/) {}  // two rows of a transpose serve there

// Three values of kWide records -> the records.
inline void store_triples(const Wide& a, const Wide& b, const Wide& c, float* records) {
  const Wide a0b0a1b1 = pick<0, 4, 1, 5>(a, b);
  const Wide a2b2a3b3 = pick<2, 6, 3, 7>(a, b);
  const Wide c0a1c2a3 = pick<0, 5, 2, 7>(c, a);
  const Wide b1c1b3c3 = pick<1, 5, 3, 7>(b, c);
  const Wide values[3] = {pick<0, 1, 4, 5>(a0b0a1b1, c0a1c2a3), pick<0, 1, 4, 5>(b1c1b3c3, a2b2a3b3),
                          pick<2, 3, 6, 7>(c0a1c2a3, b1c1b3c3)};
  for (std::size_t k = 0; k < 3; ++k) {
    const Four low = __builtin_shufflevector(values[k], values[k], 0, 1, 2, 3);
    std::memcpy(records + 4 * k, &low, sizeof low);
#if defined(__AVX2__)
    const Four high = __builtin_shufflevector(values[k], values[k], 4, 5, 6, 7);
    std::memcpy(records + 12 + 4 * k, &high, sizeof high);
#endif
  }
}

// kWide lanes of three values of a block -> kWide records of three values.
inline void join_triples(const float* block, float* records) {
  Wide values[3];
  for (std::size_t k = 0; k < 3; ++k) std::memcpy(&values[k], block + k * kBlock<float>, sizeof values[k]);
  store_triples(values[0], values[1], values[2], records);
}
inline void join_triples(const double* /*block*/, double* /*records*/) {}  // two rows of a transpose serve there

// `count` <= kBlock plain records of `size` values -> one block; lanes from `count` on become 0.
template <class T>
void to_block(const T* records, std::size_t count, std::size_t size, T* block) {
  std::size_t i = 0;
  if (size == 3 && kSide<T> == 4) {
    for (; i + 4 <= count; i += 4) spread_triples(records + i * size, block + i);
  } else if (size >= kSide<T>) {
    for (; i + kTaken<T> <= count; i += kTaken<T>) {
      for (std::size_t k = 0; k < size; k += kSide<T>) {
        if (size < k + kSide<T>) k = size - kSide<T>;  // the last ones overlap those before
        spread_records(records + i * size + k, size, block + k * kBlock<T> + i);
      }
    }
    for (; i + kSide<T> <= count; i += kSide<T>) {
      for (std::size_t k = 0; k < size; k += kSide<T>) {
        if (size < k + kSide<T>) k = size - kSide<T>;
        transpose(records + i * size + k, size, block + k * kBlock<T> + i, kBlock<T>);
      }
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = i; j < count; ++j) block[k * kBlock<T> + j] = records[j * size + k];
    for (std::size_t j = count; j < kBlock<T>; ++j) block[k * kBlock<T> + j] = T(0);
  }
}

// One block -> `count` <= kBlock plain records of `size` values.
template <class T>
void to_records(const T* block, std::size_t count, std::size_t size, T* records) {
  std::size_t i = 0;
  if (size == 3 && kSide<T> == 4) {
    for (; i + kWide <= count; i += kWide) join_triples(block + i, records + i * size);
  } else if (size >= kSide<T>) {
    for (; i + kSide<T> <= count; i += kSide<T>) {
      for (std::size_t k = 0; k < size; k += kSide<T>) {
        if (size < k + kSide<T>) k = size - kSide<T>;
        transpose(block + k * kBlock<T> + i, kBlock<T>, records + i * size + k, size);
      }
    }
  }
  for (; i < count; ++i) {
    for (std::size_t k = 0; k < size; ++k) records[i * size + k] = block[k * kBlock<T> + i];
  }
}

// The first `count` lanes of a block of `size` values to another block, whose other lanes stay as they are.
template <class T>
void copy_lanes(const T* from, std::size_t count, std::size_t size, T* to) {
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = 0; j < count; ++j) to[k * kBlock<T> + j] = from[k * kBlock<T> + j];
  }
}

// The same with 0 in the other lanes.
template <class T>
void copy_lanes_and_zeros(const T* from, std::size_t count, std::size_t size, T* to) {
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = 0; j < kBlock<T>; ++j) to[k * kBlock<T> + j] = j < count ? from[k * kBlock<T> + j] : T(0);
  }
}

// A half-precision number (IEEE 754 binary16) as float, exactly.
inline float widen(Half half) {
  const auto bits = static_cast<std::uint32_t>(half);
  const std::uint32_t magnitude = (bits & 0x7fffU) << 13U;
  std::uint32_t wide = magnitude + 0x38000000U;                     // exponent bias 127 for 15
  if ((bits & 0x7c00U) == 0x7c00U) wide = magnitude | 0x7f800000U;  // infinite or not a number
  float value;
  std::memcpy(&value, &wide, sizeof value);
  if ((bits & 0x7c00U) == 0) value = float(bits & 0x3ffU) * 5.9604645e-08F;  // 2^-24: subnormal
  return (bits & 0x8000U) != 0 ? -value : value;
}

// Four of them.
inline Four widen_four(const Half* from) {
  std::int16_t __attribute__((vector_size(8))) halves;
  std::memcpy(&halves, from, sizeof halves);
  const Words bits = __builtin_convertvector(halves, Words);  // the sign fills the upper half
  const Words exponent = bits & 0x7c00;
  Words wide = ((bits & 0x7fff) << 13) + 0x38000000;                                // exponent bias 127 for 15
  wide += Words(exponent == 0x7c00) & 0x38000000;                                   // infinite or not a number
  const Four small = __builtin_convertvector(bits & 0x3ff, Four) * 5.9604645e-08F;  // 2^-24: subnormal
  Words small_bits;
  std::memcpy(&small_bits, &small, sizeof small);
  const auto is_small = Words(exponent == 0);
  wide = (small_bits & is_small) | (wide & ~is_small) | (bits & std::numeric_limits<std::int32_t>::min());
  Four values;
  std::memcpy(&values, &wide, sizeof values);
  return values;
}

// `count` of them.
inline void widen(const Half* from, std::size_t count, float* to) {
  std::size_t i = 0;
#if defined(__AVX512F__)
  for (; i + 16 <= count; i += 16) {
    const __m256i halves = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + i));
    _mm512_storeu_ps(to + i, _mm512_cvtph_ps(halves));
  }
#elif defined(__F16C__)
  for (; i + 8 <= count; i += 8) {
    const __m128i halves = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from + i));
    _mm256_storeu_ps(to + i, _mm256_cvtph_ps(halves));
  }
#else
  for (; i + 4 <= count; i += 4) {
    const Four values = widen_four(from + i);
    std::memcpy(to + i, &values, sizeof values);
  }
#endif
  for (; i < count; ++i) to[i] = widen(from[i]);
}
inline void widen(const Half* /*from*/, std::size_t /*count*/, double* /*to*/) {}  // float only

// A line of 64 bytes, aligned in `to` at least, written past the cache.
template <class T>
inline void stream_line(const T* from, T* to) {
#if defined(__AVX512F__)
  _mm512_stream_ps(reinterpret_cast<float*>(to), _mm512_loadu_ps(from));
#elif defined(__AVX__)
  for (int i = 0; i < 2; ++i) {
    const auto* source = reinterpret_cast<const float*>(from) + 8 * i;
    _mm256_stream_ps(reinterpret_cast<float*>(to) + 8 * i, _mm256_loadu_ps(source));
  }
#elif defined(__SSE2__)
  for (int i = 0; i < 4; ++i) {
    const auto* source = reinterpret_cast<const float*>(from) + 4 * i;
    _mm_stream_ps(reinterpret_cast<float*>(to) + 4 * i, _mm_loadu_ps(source));
  }
#else
  std::memcpy(to, from, detail::kLine);
#endif
}

// `count` values; whole lines of `to` past the cache when `stream` is set.
template <class T>
void copy(const T* from, std::size_t count, bool stream, T* to) {
  const std::size_t past = reinterpret_cast<std::uintptr_t>(to) / sizeof(T) % kBlock<T>;
  const std::size_t before = (kBlock<T> - past) % kBlock<T>;
  if (!stream || before >= count) {
    std::memcpy(to, from, count * sizeof(T));
    return;
  }
  std::memcpy(to, from, before * sizeof(T));
  std::size_t i = before;
  for (; i + kBlock<T> <= count; i += kBlock<T>) stream_line(from + i, to + i);
  std::memcpy(to + i, from + i, (count - i) * sizeof(T));
}

// Orders streamed stores before whatever follows the call.
inline void finish_stream() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

}  // namespace sh::batch::SH_BATCH_ISA
