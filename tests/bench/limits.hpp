// The limits of the machine that the batched kernels are held against, measured where they are used.
#pragma once

#include <cstddef>
#include <functional>

namespace sh::bench {

/// A task that fills `count` values, 64 bytes a store.
std::function<void()> fill_task(float* values, std::size_t count);

/// A task that reads `count` values once.
std::function<void()> read_task(const float* values, std::size_t count);

/// A task that reads `inputs` values once and writes `outputs` values once, by turns as they go along; the stores may
/// go past the caches. Both arrays aligned to 64 bytes.
std::function<void()> stream_task(const float* in, std::size_t inputs, float* out, std::size_t outputs,
                                  bool past_caches);

/// Operations of fma_task: each a multiply-add of 16 floats.
inline constexpr int kFmaOperations = 16 * 256;
/// A task of independent multiply-adds of 16 floats: chains enough to hide their latency.
std::function<void()> fma_task();

}  // namespace sh::bench
