// What the drivers of sh::batch share, whatever the instruction set.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include "records.hpp"

namespace sh::batch::detail {

constexpr std::size_t kLine = 64;  // bytes of a cache line, and of one value of a block
constexpr int kMostInputs = 4;

/// One call of a driver, checked.
template <class T>
struct Call {
  int degree = 0;
  std::size_t n = 0;
  Records<const T> in[kMostInputs];
  Records<T> out;
  const Half* half = nullptr;  ///< data of input 0 where it is half precision
  bool stream = false;         ///< write past the cache
  std::size_t channels = 1;    ///< that a kernel computes one after the other, of interleaved arrays
};

/// A kernel of n plain records, or of n whole blocks. Pointers to the inputs go one by one (b: null where there is one
/// input): from an array, compilers fetch two at once, which waits for both stores.
template <class T>
using RecordKernel = void (*)(const T* a, const T* b, std::size_t n, T* out);

/// The kernels of a degree that need no driver: of plain records, of blocks that are aligned to lines and, where input 0 has
/// colors, of plain records beside an interleaved input 0.
template <class T>
struct DirectKernels {
  RecordKernel<T> plain;
  RecordKernel<T> blocks;
  RecordKernel<T> interleaved = nullptr;
};

constexpr std::size_t kMostDirect = 1024;  // records of a direct call: their outputs stay in a cache

/// The kernels of a degree for few records, which need no driver.
template <class T>
struct SingleKernels {
  /// a: n records, or one for all; b: n plain records, or the one that always serves all; out: n plain records, or a sum.
  void (*run)(const T* a, bool is_shared, const T* b, std::size_t n, T* out);
  std::size_t most;                  ///< records that it is called for
  RecordKernel<T> colors = nullptr;  ///< a: one record for all; b, out: n interleaved records
};

/// Whether the processor stores a register of 64 bytes in one cycle, but in two or three beside loads. Tests set it.
extern bool loads_delay_stores;

/// Something computed once a call.
template <class T>
using Once = void (*)(int degree, const T* in, T* out);

/// A kernel for one product; c may be a or b.
using ProductOne = void (*)(const float* a, const float* b, float* c);

/// A kernel for one rotation, from a matrix or from a prepared matrix; out may be c.
using RotateOne = void (*)(const float* r, const float* c, float* out);
using RotatePrepare = void (*)(const float* r, float* prepared);

}  // namespace sh::batch::detail
