#include "tests/bench/limits.hpp"

#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

// Sixteen floats in whatever registers the machine has. May alias floats.
using Block = float __attribute__((vector_size(64), may_alias));
constexpr std::size_t kLanes = 16;
constexpr int kChains = 16;

}  // namespace

std::function<void()> fill_task(float* values, std::size_t count) {
  return [values, count] {
    const Block one = Block{} + 1.F;
    auto* to = reinterpret_cast<Block*>(values);
    for (std::size_t i = 0; i < count / kLanes; ++i) to[i] = one;
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
