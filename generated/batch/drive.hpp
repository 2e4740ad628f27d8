// A driver: kernels of whole blocks over records in any layout.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <limits>

#include "lanes.hpp"

namespace sh::batch::SH_BATCH_ISA {

/// A kernel of n plain records, one by one.
template <class T>
using RecordKernel = void (*)(const T* const* in, std::size_t n, T* out);

/// The most plain records that are faster one by one than as part of a block. Moving records to blocks and back costs more
/// than registers save where they have two lanes, or where kernels are short. As measured (tests/bench/plain_targets.cpp).
template <class T>
constexpr std::size_t most_by_record(int degree) {
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  constexpr int kLanes = static_cast<int>(Lanes<T>::kWidth);
  if (kLanes == 2 || degree < 2 || (degree == 2 && (kLanes == 4 || sizeof(T) == sizeof(double)))) return kAll;
  if (degree == 2) return 24;
  if (degree == 3) return 8;
  return kLanes > 4 ? 7 : 4;
}

/// A driver at one degree: its kernel and the sizes of its records.
template <class T>
struct Plan {
  int inputs = 0;
  std::size_t in[detail::kMostInputs] = {};
  std::size_t out = 0;
  bool sums = false;  // out is one record, a sum over all
  BlockKernel<T> kernel = nullptr;
  BlockKernel<T> kernel_half = nullptr;  // takes input 0 in half precision
  // When input 0 is shared: what is computed from it once, its size, and the kernel that takes it instead.
  detail::Once<T> prepare = nullptr;
  std::size_t prepared = 0;
  BlockKernel<T> kernel_prepared = nullptr;
  // Where the kernel adds up something else: from that to the sum.
  detail::Once<double> finish = nullptr;
  int shared = -1;  // the input that is always shared, and that the kernel takes as scalars; none: -1
  BlockKernel<T> kernel_records = nullptr;  // from plain records of input 0 to plain records
  RecordKernel<T> kernel_record = nullptr;  // for up to most_by_record(degree) of them
};

/// The kernel where T is float; none for double.
template <class T>
constexpr BlockKernel<T> float_only([[maybe_unused]] BlockKernel<float> kernel) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return kernel;
  } else {
    return nullptr;
  }
}

/// Runs a checked call: hands the caller's blocks to the kernel where they serve, and copies where they do not.
template <class T>
void drive(const detail::Call<T>& call, const Plan<T>& plan);

}  // namespace sh::batch::SH_BATCH_ISA
