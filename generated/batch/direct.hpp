// Calls that need no driver: in the caller, so that a compiler who knows degree and layout leaves one call of a kernel.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <atomic>
#include <cstdint>

#include "call.hpp"

// Whether the compiler of a caller knows a value; what it should expect.
#if defined(__GNUC__)
#define SH_BATCH_KNOWS(value) __builtin_constant_p(value)
#define SH_BATCH_LIKELY(condition) __builtin_expect(condition, true)
#else
#define SH_BATCH_KNOWS(value) false
#define SH_BATCH_LIKELY(condition) (condition)
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

/// Whether all of these arrays are there.
template <class... Array>
[[gnu::always_inline]] inline bool are_given(const Array&... arrays) {
  return (SH_BATCH_LIKELY(arrays.data != nullptr) && ...);
}

template <class... Array>
[[gnu::always_inline]] inline bool are_plain(const Array&... arrays) {
  return ((arrays.layout == Layout::kPlain) && ...);
}

/// Whether an input lies in rows, or is one for all.
template <class T>
[[gnu::always_inline]] inline bool is_in_rows(const Records<const T>& records) {
  return records.layout == Layout::kPlain || records.layout == Layout::kShared;
}

/// Plain records up to which a call costs more than it saves of a kernel of degree 0 or 1. A caller who is compiled for the
/// widest instruction set has nothing to gain from a call.
#if defined(__AVX512F__)
constexpr std::size_t kFewPlain = kMostDirect;
#else
constexpr std::size_t kFewPlain = 32;
#endif
template <class... Array>
[[gnu::always_inline]] inline bool are_few(std::size_t n, const Array&... arrays) {
  return n <= kFewPlain && are_plain(arrays...);
}

/// Calls f(0), ..., f(n - 1). Compilers would begin a loop over vectors for few, too.
template <class F>
[[gnu::always_inline]] inline void for_each_record(std::size_t n, const F& f) {
#if defined(__GNUC__)
  if (n < 8) {
    for (std::size_t i = 0; i < n; ++i) {
      f(i);
      asm volatile("");  // one by one
    }
    return;
  }
#endif
  for (std::size_t i = 0; i < n; ++i) f(i);
}

/// Layouts of the arrays of a call, in one register: with more than six words a call would go through memory.
class Layouts {
 public:
  constexpr Layouts(Layout a, Layout b, Layout out) noexcept
      : bits_(word(a) | word(b) << kBits | word(out) << 2 * kBits) {}
  [[nodiscard]] constexpr Layout a() const noexcept { return at(0); }
  [[nodiscard]] constexpr Layout b() const noexcept { return at(1); }
  [[nodiscard]] constexpr Layout out() const noexcept { return at(2); }

 private:
  static constexpr int kBits = 8;
  static constexpr unsigned word(Layout layout) noexcept { return static_cast<unsigned>(layout); }
  [[nodiscard]] constexpr Layout at(int place) const noexcept {
    return static_cast<Layout>(bits_ >> place * kBits & 0xff);
  }

  unsigned bits_;
};

/// The driver of a call of any layout; b: null where there is one input.
template <class T>
using AnyCall = void (*)(int degree, std::size_t n, const T* a, const T* b, T* out, Layouts layouts);

/// Calls the driver `any`.
template <class T>
[[gnu::always_inline]] inline void run_any(AnyCall<T> any, int degree, std::size_t n, const Records<T>& out,
                                           const Records<const T>& a, const Records<const T>& b = {}) {
  any(degree, n, a.data, b.data, out.data, {a.layout, b.layout, out.layout});
}

/// A call of not too many records, all plain or all in whole blocks, that are given, checked, at once: its kernels by
/// instruction set and degree. `any` serves all other calls, wrong ones and the first of all.
template <class T, class... Second>
[[gnu::always_inline]] inline void run_direct(const DirectKernels<T>* const* every, AnyCall<T> any, int degree,
                                              int largest_degree, std::size_t n, const Records<T>& out,
                                              const Records<const T>& a, const Second&... b) {
  const int set = in_use.load(std::memory_order_relaxed);
  if (SH_BATCH_LIKELY(set != kNotChosen) && SH_BATCH_LIKELY(degree >= 0 && degree <= largest_degree) &&
      SH_BATCH_LIKELY(n - 1 < kMostDirect)) {
    const DirectKernels<T>& kernels = every[set][degree];
    const T* second = nullptr;
    ((second = b.data), ...);
    if (are_plain(out, a, b...)) return kernels.plain(a.data, second, n, out.data);
    if (n % kBlock<T> == 0 && are_lines(out) && are_lines(a) && (are_lines(b) && ...)) {
      return kernels.blocks(a.data, second, n / kBlock<T>, out.data);
    }
    if (a.layout == Layout::kInterleaved && kernels.interleaved != nullptr && are_plain(out, b...)) {
      return kernels.interleaved(a.data, second, n, out.data);
    }
  }
  run_any(any, degree, n, out, a, b...);
}

/// A call of few records, plain or with one `a` for all, or of interleaved records with one `a`, at once. Second: the layout of
/// `b` that the kernels take. `any` serves all other calls.
template <Layout Second, class T>
[[gnu::always_inline]] inline void run_single(const SingleKernels<T>* const* every, AnyCall<T> any, int degree,
                                              int largest_degree, std::size_t n, const Records<T>& out,
                                              const Records<const T>& a, const Records<const T>& b) {
  const int set = in_use.load(std::memory_order_relaxed);
  if (SH_BATCH_LIKELY(set != kNotChosen) && SH_BATCH_LIKELY(degree >= 0 && degree <= largest_degree) &&
      SH_BATCH_LIKELY(n - 1 < kMostDirect)) {
    const SingleKernels<T>& kernels = every[set][degree];
    const bool is_shared = a.layout == Layout::kShared;
    if (are_plain(out) && b.layout == Second && is_in_rows(a) && n <= kernels.most) {
      return kernels.run(a.data, is_shared, b.data, n, out.data);
    }
    if (is_shared && b.layout == Layout::kInterleaved && out.layout == Layout::kInterleaved &&
        kernels.colors != nullptr) {
      return kernels.colors(a.data, b.data, n, out.data);
    }
  }
  run_any(any, degree, n, out, a, b);
}

}  // namespace sh::batch::detail
