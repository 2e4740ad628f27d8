// Vectors as bits, the keys by which welding compares vertices.
#pragma once
#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace sh::prt {

/// Equal numbers, equal bits: -0 counts as 0.
template <int N>
std::array<std::uint32_t, static_cast<std::size_t>(N)> bits_of(const Eigen::Matrix<float, N, 1>& vector) {
  std::array<std::uint32_t, static_cast<std::size_t>(N)> bits{};
  for (int i = 0; i < N; ++i) bits[i] = std::bit_cast<std::uint32_t>(vector[i] + 0.0F);
  return bits;
}

/// Hash of an array of words: multiply and fold, word by word.
struct WordsHash {
  template <std::size_t N>
  std::size_t operator()(const std::array<std::uint32_t, N>& words) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15U;
    for (const std::uint32_t word : words) {
      hash = (hash ^ word) * 0xD6E8FEB86659FD93U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace sh::prt
