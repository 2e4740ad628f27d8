// Checks the arguments of the drivers and chooses the instruction set.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <atomic>
#include <cstdint>

#include "call.hpp"

// {the driver or table of every instruction set}, in the order of InstructionSet; the last one: of AVX-512 where the
// processor works on its registers in two halves. SH_BATCH_NARROW: of what is faster on 8 lanes there.
#if defined(SH_BATCH_X86)
#define SH_BATCH_EVERY(name) \
  { baseline::name, avx2::name, avx512::name, avx512::name }
#define SH_BATCH_NARROW(name) \
  { baseline::name, avx2::name, avx512::name, avx2::name }
#else
#define SH_BATCH_EVERY(name) \
  { baseline::name }
#define SH_BATCH_NARROW(name) SH_BATCH_EVERY(name)
#endif

namespace sh::batch::detail {

/// The place in these tables of the instruction set in use, once it has been chosen.
constexpr int kNotChosen = -1;
extern std::atomic<int> in_use;
/// The same, chosen if need be.
int chosen() noexcept;

/// Values of an output record: sets of bands^2 and some more; none where the output is a sum.
struct OutputSize {
  std::size_t sets = 0;
  std::size_t more = 0;
};

/// Throws std::invalid_argument, naming the function, for a degree that is not 0 to `largest`.
void check_degree(const char* function, int degree, int largest);

/// Checks one call, which takes `inputs` arrays, and decides whether it streams. Throws std::invalid_argument.
template <class T>
void check(const char* driver, Call<T>& call, int inputs, int largest_degree, OutputSize size);

template <class T>
using Run = void (*)(const Call<T>&);

/// Checks the call and runs the driver of the instruction set in use. The call stays where it was made: a copy would wait
/// for what has just been written.
template <class T>
void run(const char* driver, const Run<T>* every, Call<T>&& call, int inputs, int largest_degree, OutputSize size) {
  check(driver, call, inputs, largest_degree, size);
  every[chosen()](call);
}

/// Whether a kernel can work on the blocks as they are.
template <class T>
[[gnu::always_inline]] inline bool are_lines(const Records<T>& records) {
  return records.layout == Layout::kBlocked && reinterpret_cast<std::uintptr_t>(records.data) % kLine == 0;
}

/// A call of not too many records, all plain or all in whole blocks, checked, at once: its kernels by instruction set and
/// degree. False for all other calls, wrong ones and the first of all.
template <class T, class... Second>
[[gnu::always_inline]] inline bool run_direct(const DirectKernels<T>* const* every, int degree, int largest_degree,
                                              std::size_t n, const Records<T>& out, const Records<const T>& a,
                                              const Second&... b) {
  constexpr std::size_t kMost = 1024;  // their outputs stay in a cache
  const int set = in_use.load(std::memory_order_relaxed);
  const bool serves = set != kNotChosen && degree >= 0 && degree <= largest_degree && n - 1 < kMost &&
                      out.data != nullptr && a.data != nullptr && ((b.data != nullptr) && ...);
  if (!serves) return false;
  const T* second = nullptr;
  ((second = b.data), ...);
  const DirectKernels<T>& kernels = every[set][degree];
  if (out.layout == Layout::kPlain && a.layout == Layout::kPlain && ((b.layout == Layout::kPlain) && ...)) {
    kernels.plain(a.data, second, n, out.data);
    return true;
  }
  if (n % kBlock<T> == 0 && are_lines(out) && are_lines(a) && (are_lines(b) && ...)) {
    kernels.blocks(a.data, second, n / kBlock<T>, out.data);
    return true;
  }
  return false;
}

}  // namespace sh::batch::detail
