// Random numbers whose bits are the same on every machine.
#pragma once

#include <cstdint>

namespace sh::numeric {

// SplitMix64 (Steele, Lea and Flood 2014): one multiply-xorshift generator with 64 bits of state.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Uniform in [-1, 1), a multiple of 2^-52.
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

}  // namespace sh::numeric
