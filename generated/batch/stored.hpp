// Transfer in blocks of receivers, as memory may hold what files store, for batch.hpp.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <cstdint>

#include "records.hpp"

namespace sh::batch {

/// Whole blocks of 16 receivers, whatever the type of their numbers: number k of receiver i is
/// data[i / 16 * 16 * size + 16 k + i % 16], where size = rows * columns. Any number of columns serves.
/// Stored: float, Half, or std::int8_t, which the scale of its number multiplies.
template <class Stored>
struct StoredBlocks {
  const Stored* data = nullptr;
  const float* scales = nullptr;  ///< (rows * columns) for std::int8_t; else not read
  std::size_t rows = 1;           ///< 1: one row meets the light of all channels; 3: row c meets channel c
  std::size_t columns = 0;
};

/// Exit radiance of the receivers of some blocks under one light: out (16 blocks, 3), plain, channel c is factors[c] times
/// the sum over k of row[k] light[c][k]. light (3, columns); factors (16 blocks, 3), e.g. colors, or null: 1.
/// past_caches: writes past the caches where `out` is aligned to 16 bytes.
/// Terms are added in their order, and nothing is contracted: the bits are those of a plain loop on every machine.
/// Throws std::invalid_argument when an array is missing or there are neither one nor three rows.
void relight_stored(const StoredBlocks<float>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out, bool past_caches = false);
void relight_stored(const StoredBlocks<Half>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out, bool past_caches = false);
void relight_stored(const StoredBlocks<std::int8_t>& transfer, std::size_t blocks, const float* light,
                    const float* factors, float* out, bool past_caches = false);

}  // namespace sh::batch
