// Random numbers and points of low discrepancy, whose bits are the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sh::numeric {

/// SplitMix64 (Steele, Lea and Flood 2014): one multiply-xorshift generator with 64 bits of state.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Uniform in [-1, 1), a multiple of 2^-52.
  double next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t bits = state_;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    bits ^= bits >> 31U;
    return static_cast<double>(bits >> 11U) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// The first `count` points of the two-dimensional Sobol' sequence [Sobol67], scrambled by a seed. It is a
/// (0,2)-sequence in base 2: any 2^k of them from a multiple of 2^k on lie one each in every grid of 2^k equal boxes.
/// Nested uniform scrambling [Owen95] of all 32 bits keeps that, makes every point uniform in (0, 1)^2 and every
/// average over a square unbiased; for smooth integrands the rms error falls as count^-3/2. Throws
/// std::invalid_argument for count < 0.
std::vector<std::array<double, 2>> sobol_points(int count, std::uint64_t seed);

}  // namespace sh::numeric
