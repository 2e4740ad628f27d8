// Calls that need no driver: in the caller, so that a compiler who knows degree and layout leaves one call of a kernel.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <atomic>
#include <cstdint>

#include "call.hpp"

// Whether the compiler of a caller knows a value.
#if defined(__GNUC__)
#define SH_BATCH_KNOWS(value) __builtin_constant_p(value)
#else
#define SH_BATCH_KNOWS(value) false
#endif

namespace sh::batch::detail {

/// The place of the instruction set in use in the tables of choice.hpp, once it has been chosen.
constexpr int kNotChosen = -1;
extern std::atomic<int> in_use;

/// Whether a kernel can work on the blocks as they are.
template <class T>
[[gnu::always_inline]] inline bool are_lines(const Records<T>& records) {
  return records.layout == Layout::kBlocked && reinterpret_cast<std::uintptr_t>(records.data) % kLine == 0;
}

/// Whether the records are plain and so few that a call costs more than a kernel of degree 0 or 1.
template <class T, class... In>
[[gnu::always_inline]] inline bool are_few(std::size_t n, const Records<T>& out, const In&... in) {
  constexpr std::size_t kFew = 32;
  return n <= kFew && out.data != nullptr && ((in.data != nullptr) && ...) && out.layout == Layout::kPlain &&
         ((in.layout == Layout::kPlain) && ...);
}

/// Layouts of the arrays of a call, in one register: with more than six words a call would go through memory.
struct Layouts {
  Layout a, b, out;
};

/// The driver of a call of any layout; b: null where there is one input.
template <class T>
using AnyCall = void (*)(int degree, std::size_t n, const T* a, const T* b, T* out, Layouts layouts);

/// A call of not too many records, all plain or all in whole blocks, checked, at once: its kernels by instruction set and
/// degree. `any` serves all other calls, wrong ones and the first of all.
template <class T, class... Second>
[[gnu::always_inline]] inline void run_direct(const DirectKernels<T>* const* every, AnyCall<T> any, int degree,
                                              int largest_degree, std::size_t n, const Records<T>& out,
                                              const Records<const T>& a, const Second&... b) {
  constexpr std::size_t kMost = 1024;  // their outputs stay in a cache
  const T* second = nullptr;
  Layout layout = Layout::kPlain;
  ((second = b.data, layout = b.layout), ...);
  const int set = in_use.load(std::memory_order_relaxed);
  if (set != kNotChosen && degree >= 0 && degree <= largest_degree && n - 1 < kMost && out.data != nullptr &&
      a.data != nullptr && ((b.data != nullptr) && ...)) {
    const DirectKernels<T>& kernels = every[set][degree];
    if (out.layout == Layout::kPlain && a.layout == Layout::kPlain && layout == Layout::kPlain) {
      return kernels.plain(a.data, second, n, out.data);
    }
    if (n % kBlock<T> == 0 && are_lines(out) && are_lines(a) && (are_lines(b) && ...)) {
      return kernels.blocks(a.data, second, n / kBlock<T>, out.data);
    }
  }
  any(degree, n, a.data, second, out.data, {a.layout, layout, out.layout});
}

}  // namespace sh::batch::detail
