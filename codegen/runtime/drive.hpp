// A driver: kernels of whole blocks over records in any layout.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>

#include "lanes.hpp"

namespace sh::batch::SH_BATCH_ISA {

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
  BlockKernel<T> kernel_records = nullptr;               // from plain records of input 0 to plain records
  BlockKernel<T> kernel_records_half = nullptr;          // where they are in half precision
  detail::RecordKernel<T> kernel_plain = nullptr;        // takes and gives plain records
  detail::RecordKernel<T> kernel_interleaved = nullptr;  // the same, but input 0 is interleaved
  const detail::SingleKernels<T>* single = nullptr;      // of few records; null: there are none
  std::size_t most_copied = 0;  // records in other layouts that are copied to rows first, for `single`
};

/// The most records that are faster one by one than in registers of blocks; of_sixteen: than in those of 16 lanes, as measured.
template <class T>
constexpr std::size_t single_records(std::size_t of_sixteen) {
  return (of_sixteen * Lanes<T>::kWidth + 15) / 16;
}

/// The table of T.
template <class T>
constexpr const detail::SingleKernels<T>* of_type([[maybe_unused]] const detail::SingleKernels<float>* floats,
                                                  [[maybe_unused]] const detail::SingleKernels<double>* doubles) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return floats;
  } else {
    return doubles;
  }
}

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
