// Half precision to float, exactly.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "tiles.hpp"

namespace sh::batch::SH_BATCH_ISA {

using Words = std::int32_t __attribute__((vector_size(16)));

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

// load_rows and load_columns of records in half precision.
inline Wide load_rows(const Half* first, const Half* second) {
#if defined(__AVX2__)
  const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(first)));
  const __m128 both = _mm_loadh_pi(low, reinterpret_cast<const __m64*>(second));
  return _mm256_cvtph_ps(_mm_castps_si128(both));
#else
  static_cast<void>(second);
  return widen_four(first);
#endif
}
[[gnu::always_inline]] inline Tiles load_columns(const Half* records, std::size_t size, std::size_t count = kWide) {
  const auto rows = [=](std::size_t i) __attribute__((always_inline)) {
    return load_rows(record_of(records, size, count, i), record_of(records, size, count, i + 4));
  };
  return transposed(rows(0), rows(1), rows(2), rows(3));
}

}  // namespace sh::batch::SH_BATCH_ISA
