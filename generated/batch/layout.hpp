// Moves records between layouts: plain to blocked and back by tiles, and past the cache.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "tiles.hpp"

namespace sh::batch::SH_BATCH_ISA {

// The last values of records that a tile would have to overlap by all but one: they move one by one.
template <class T>
constexpr bool ends_alone(std::size_t k, std::size_t size) {
  return k + 1 == size && kSide<T> > 2;
}

// `count` <= kBlock plain records of `size` values -> one block; lanes from `count` on become 0.
template <class T, class Rows = InOrder>
void to_block(const T* records, std::size_t count, std::size_t size, T* block, const Rows& rows = {}) {
  if (count < kBlock<T>) std::memset(block, 0, size * kBlock<T> * sizeof(T));
  std::size_t i = 0;
  if (size == 3 && kHasTriples<T>) {
    if constexpr (kHasTriples<T>) {
      for (; i + kTaken<T> <= count; i += kTaken<T>) spread_triples(records + i * size, block + i);
    }
  } else if (size >= kSide<T>) {
    for (; i + kTaken<T> <= count; i += kTaken<T>) {
      for (std::size_t k = 0; k < size; k += kSide<T>) {
        if (ends_alone<T>(k, size)) {
          for (std::size_t j = i; j < i + kTaken<T>; ++j) block[rows(k) * kBlock<T> + j] = records[j * size + k];
          break;
        }
        if (size < k + kSide<T>) k = size - kSide<T>;  // the last ones overlap those before
        const auto tile = load_columns(records + i * size + k, size);
#pragma GCC unroll 4
        for (std::size_t j = 0; j < kSide<T>; ++j) store(block + rows(k + j) * kBlock<T> + i, tile.v[j]);
      }
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = i; j < count; ++j) block[rows(k) * kBlock<T> + j] = records[j * size + k];
  }
}

// kTaken lanes of a block -> plain records of `size` >= kSide values.
template <class T, class Rows>
void join_whole_records(const T* block, std::size_t size, T* records, const Rows& rows) {
  constexpr std::size_t kSlab = kTilesOfSlab<T> * kRow<T>;
  const auto columns = [&](std::size_t first) {
    return [ block, first, &rows ](std::size_t k) __attribute__((always_inline)) {
      return load_column(block + rows(first + k) * kBlock<T>);
    };
  };
  const T* alone = size > kRow<T> && size % kRow<T> == 1 ? block : nullptr;
  std::size_t k = alone != nullptr ? 1 : 0;
  for (; k + kSlab <= size; k += kSlab) {
    join_slab<kTilesOfSlab<T>>(columns(k), alone, records + k, size);
    alone = nullptr;
  }
  for (; k + kRow<T> <= size; k += kRow<T>) {
    join_slab<1>(columns(k), alone, records + k, size);
    alone = nullptr;
  }
  for (; k < size; k += kSide<T>) {
    if (size < k + kSide<T>) k = size - kSide<T>;  // the last ones overlap those before
    join_tile(columns(k), records + k, size);
  }
}

// One block -> `count` <= kBlock plain records of `size` values.
template <class T, class Rows = InOrder>
void to_records(const T* block, std::size_t count, std::size_t size, T* records, const Rows& rows = {}) {
  std::size_t i = 0;
  if (size == 3 && sizeof(T) == sizeof(float)) {
    for (; i + kWide <= count; i += kWide) join_triples(block + i, records + i * size);
  } else if (size >= kSide<T>) {
    for (; i + kTaken<T> <= count; i += kTaken<T>) join_whole_records(block + i, size, records + i * size, rows);
  }
  for (; i < count; ++i) {
    for (std::size_t k = 0; k < size; ++k) records[i * size + k] = block[rows(k) * kBlock<T> + i];
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
