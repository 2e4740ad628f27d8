#include "prt/transfer/widen.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "prt/rays/widest.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace sh::prt {

namespace {

float widened(std::uint16_t half) {
  return static_cast<float>(Eigen::half(Eigen::half_impl::raw_uint16_to_half(half)));
}

#if defined(__x86_64__)
// The numbers that whole registers hold; returns their count.
__attribute__((target("avx,f16c"))) std::size_t widen_registers(const std::uint16_t* from, std::size_t count,
                                                                float* to) {
  constexpr std::size_t kLanes = 8;
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    _mm256_storeu_ps(to + i, _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from + i))));
  }
  return i;
}

const bool kHasRegisters = __builtin_cpu_supports("avx2") > 0;  // all of these have F16C
#endif

SHFORGE_WIDEST void scale_bytes(const std::int8_t* from, std::size_t count, const float* scales, float* to) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]) * scales[i];
}

}  // namespace

void widen_halves(const std::uint16_t* from, std::size_t count, float* to) {
  std::size_t i = 0;
#if defined(__x86_64__)
  if (kHasRegisters) i = widen_registers(from, count, to);
#endif
  for (; i < count; ++i) to[i] = widened(from[i]);
}

void widen_bytes(const std::int8_t* from, std::size_t count, std::span<const float> scales, float* to) {
  for (std::size_t done = 0; done < count; done += scales.size()) {
    scale_bytes(from + done, std::min(scales.size(), count - done), scales.data(), to + done);
  }
}

}  // namespace sh::prt
