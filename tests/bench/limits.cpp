#include "tests/bench/harness.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace sh::bench {
namespace {

// Sixteen floats in the registers of the machine. May alias floats.
using Block = float __attribute__((vector_size(64), may_alias));
constexpr std::size_t kLanes = 16;
constexpr int kChains = 16;

void store_past_caches(const Block& value, Block* to) {
#if defined(__SSE2__)
  for (std::size_t i = 0; i < kLanes; i += 4) {
    _mm_stream_ps(reinterpret_cast<float*>(to) + i, _mm_loadu_ps(reinterpret_cast<const float*>(&value) + i));
  }
#else
  *to = value;
#endif
}

}  // namespace

std::function<void()> fill_task(float* values, std::size_t count) {
  return [values, count] {
    const Block one = Block{} + 1.F;
    auto* to = reinterpret_cast<Block*>(values);
    const std::size_t blocks = count / kLanes;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < blocks; ++i) to[i] = one;
    keep(*values);
  };
}

std::function<void()> read_task(const float* values, std::size_t count) {
  return [values, count] {
    Block sum[4] = {};
    const auto* from = reinterpret_cast<const Block*>(values);
    for (std::size_t i = 0; i + 4 <= count / kLanes; i += 4) {
      for (std::size_t j = 0; j < 4; ++j) sum[j] += from[i + j];
    }
    keep(sum);
  };
}

std::function<void()> stream_task(const float* in, std::size_t inputs, float* out, std::size_t outputs,
                                  bool past_caches) {
  return [=] {
    Block sum[2] = {};
    const auto* from = reinterpret_cast<const Block*>(in);
    auto* to = reinterpret_cast<Block*>(out);
    const std::size_t reads = inputs / kLanes;
    const std::size_t writes = outputs / kLanes;
    std::size_t i = 0;
    for (std::size_t k = 0; k < writes; ++k) {
      const std::size_t end = reads * (k + 1) / writes;
      for (; i + 2 <= end; i += 2) {
        sum[0] += from[i];
        sum[1] += from[i + 1];
      }
      past_caches ? store_past_caches(sum[0], to + k) : void(to[k] = sum[0]);
    }
    keep(sum);
    keep(*out);
  };
}

std::function<void()> fma_task() {
  return [] {
    Block chain[kChains] = {};
    Block factor = Block{} + 0.5F;
    keep(factor);  // not a constant
    for (int i = 0; i < kFmaOperations / kChains; ++i) {
      for (Block& c : chain) c = c * factor + factor;
    }
    keep(chain);
  };
}

}  // namespace sh::bench
