// sh::batch::relight_stored on the instruction set SH_BATCH_ISA.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#include <cstring>

#include "lanes.hpp"
#include "stored.hpp"

namespace sh::batch::SH_BATCH_ISA {
namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kReceivers = kBlock<float>;
constexpr std::size_t kWidth = Lanes<float>::kWidth;
constexpr std::size_t kRegisters = kReceivers / kWidth;  // of a block

// A register; not Lanes, of which g++ would write each sum to memory at each step.
using Values = float __attribute__((vector_size(kWidth * sizeof(float))));

// The lanes of a register.
[[gnu::always_inline]] inline Values read_lanes(const float* from) {
  Values values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
[[gnu::always_inline]] inline Values read_lanes(const Half* from) {
#if defined(__AVX512F__)
  return _mm512_cvtph_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
#elif defined(__F16C__)
  return _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
#else
  return widen_four(from);
#endif
}
[[gnu::always_inline]] inline Values read_lanes(const std::int8_t* from) {
#if defined(__AVX512F__)
  return _mm512_cvtepi32_ps(_mm512_cvtepi8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
#elif defined(__AVX2__)
  return _mm256_cvtepi32_ps(_mm256_cvtepi8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from))));
#elif defined(__SSE2__)
  std::int32_t four;
  std::memcpy(&four, from, sizeof four);
  const __m128i bytes = _mm_cvtsi32_si128(four);
  const __m128i twice = _mm_unpacklo_epi8(bytes, bytes);
  return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(twice, twice), 24));  // the upper copies keep the sign
#else
  return Values{float(from[0]), float(from[1]), float(from[2]), float(from[3])};
#endif
}

// What the stream of blocks needs next: as many bytes as a block has, further on.
[[gnu::always_inline]] inline void prefetch_block(const void* block, std::size_t bytes) {
  constexpr std::size_t kAhead = 4096;
  for (std::size_t at = 0; at < bytes; at += detail::kLine) {
    __builtin_prefetch(static_cast<const char*>(block) + kAhead + at, 0, 3);
  }
}

constexpr std::size_t kTogether = kRegisters < 2 ? 1 : 2;  // registers that share what is read of the light

// The scalar products of a row of a block with Sums rows of light. The row is read in the order of memory: where three
// rows take turns, the processor's prefetching loses them.
template <std::size_t Sums, class Stored>
[[gnu::always_inline]] inline void multiply_row(const Stored* row, const float* scales, std::size_t columns,
                                                const float* light, float* out) {
  for (std::size_t lane = 0; lane < kReceivers; lane += kTogether * kWidth) {
    Values sums[Sums][kTogether];
    for (auto& sum : sums) {
      for (Values& part : sum) part = -Values{};  // -0 leaves what is added to it
    }
    for (std::size_t k = 0; k < columns; ++k) {
      unrolled(
          std::make_index_sequence<kTogether>(), [&](std::size_t part) __attribute__((always_inline)) {
            Values value = read_lanes(row + k * kReceivers + lane + part * kWidth);
            if constexpr (sizeof(Stored) == 1) value *= scales[k];
            unrolled(
                std::make_index_sequence<Sums>(), [&](std::size_t sum) __attribute__((always_inline)) {
                  sums[sum][part] += value * light[sum * columns + k];
                });
          });
    }
    unrolled(
        std::make_index_sequence<Sums * kTogether>(), [&](std::size_t i) __attribute__((always_inline)) {
          const Values sum = sums[i / kTogether][i % kTogether];  // so that the sums need no memory
          std::memcpy(out + i / kTogether * kReceivers + lane + i % kTogether * kWidth, &sum, sizeof sum);
        });
  }
}

// The radiance of a block, times factors if there are any. Streams: past the caches, to an aligned array.
template <bool Streams>
[[gnu::always_inline]] inline void write(const float* radiance, const float* factors, float* out) {
  for (std::size_t i = 0; i < kChannels * kReceivers; i += 4) {
    Four values;
    std::memcpy(&values, radiance + i, sizeof values);
    if (factors != nullptr) {
      Four of_values;
      std::memcpy(&of_values, factors + i, sizeof of_values);
      values *= of_values;
    }
#if defined(__SSE2__)
    if constexpr (Streams) {
      _mm_stream_ps(out + i, values);
      continue;
    }
#endif
    std::memcpy(out + i, &values, sizeof values);
  }
}

template <std::size_t Rows, bool Streams, class Stored>
void relight_blocks(const StoredBlocks<Stored>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out) {
  constexpr std::size_t kOut = kChannels * kReceivers;
  const std::size_t step = Rows * transfer.columns * kReceivers;  // numbers of a block
  const Stored* block = transfer.data;
  for (std::size_t b = 0; b < blocks; ++b, block += step, out += kOut) {
    prefetch_block(block, step * sizeof(Stored));
    float sums[kOut];
    float radiance[kOut];
    for (std::size_t row = 0; row < Rows; ++row) {
      const std::size_t first = row * transfer.columns;
      const float* scales = sizeof(Stored) == 1 ? transfer.scales + first : nullptr;
      multiply_row<kChannels / Rows>(block + first * kReceivers, scales, transfer.columns, light + first,
                                     sums + row * kReceivers);
    }
    for (std::size_t i = 0; i < kReceivers; i += kWide) join_triples(sums + i, radiance + kChannels * i);
    write<Streams>(static_cast<const float*>(radiance), factors, out);
    if (factors != nullptr) factors += kOut;
  }
#if defined(__SSE2__)
  if constexpr (Streams) _mm_sfence();
#endif
}

}  // namespace

template <class Stored>
void relight_stored(const StoredBlocks<Stored>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out, bool past_caches) {
  const bool streams = past_caches && reinterpret_cast<std::uintptr_t>(out) % sizeof(Four) == 0;
  const auto relight = transfer.rows == 1
                           ? (streams ? relight_blocks<1, true, Stored> : relight_blocks<1, false, Stored>)
                           : (streams ? relight_blocks<3, true, Stored> : relight_blocks<3, false, Stored>);
  relight(transfer, blocks, light, factors, out);
}
template void relight_stored(const StoredBlocks<float>&, std::size_t, const float*, const float*, float*, bool);
template void relight_stored(const StoredBlocks<Half>&, std::size_t, const float*, const float*, float*, bool);
template void relight_stored(const StoredBlocks<std::int8_t>&, std::size_t, const float*, const float*, float*, bool);

}  // namespace sh::batch::SH_BATCH_ISA
