// Checks the arguments of the drivers and chooses the instruction set.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include "direct.hpp"

// {the driver or table of every instruction set}, in the order of InstructionSet.
#if defined(SH_BATCH_X86)
#define SH_BATCH_EVERY(name) \
  { baseline::name, avx2::name, avx512::name }
#else
#define SH_BATCH_EVERY(name) \
  { baseline::name }
#endif

namespace sh::batch::detail {

/// The place in these tables of the instruction set in use, chosen if need be.
int chosen() noexcept;

/// Values of an output record: sets of bands^2 and some more; none where the output is a sum.
struct OutputSize {
  std::size_t sets = 0;
  std::size_t more = 0;
};

/// The arrays that may be interleaved: inputs by their bits, then the output.
struct Colors {
  unsigned arrays = 0;
  bool in_records = false;  ///< their records hold the three channels; else a kernel computes one
};
constexpr unsigned kOutput = 1U << kMostInputs;

/// Throws std::invalid_argument, naming the function, for a degree that is not 0 to `largest`.
void check_degree(const char* function, int degree, int largest);

/// Checks one call, which takes `inputs` arrays, and decides whether it streams. Throws std::invalid_argument.
template <class T>
void check(const char* driver, Call<T>& call, int inputs, int largest_degree, OutputSize size, Colors colors);

template <class T>
using Run = void (*)(const Call<T>&);

/// Checks the call and runs the driver of the instruction set in use. The call stays where it was made: a copy would wait
/// for what has just been written.
template <class T>
void run(const char* driver, const Run<T>* every, Call<T>&& call, int inputs, int largest_degree, OutputSize size,
         Colors colors = {}) {
  check(driver, call, inputs, largest_degree, size, colors);
  if (call.n > 0) every[chosen()](call);
}

}  // namespace sh::batch::detail
