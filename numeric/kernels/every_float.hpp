// Compares a function of one float with the same in double, at every float of a range, on SIMD lanes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <experimental/simd>
#include <limits>

#include "numeric/kernels/exhaustive.hpp"

namespace sh::numeric {

constexpr int kFloatLanes = 8;
using FloatLanes = std::experimental::fixed_size_simd<float, kFloatLanes>;
using DoubleLanes = std::experimental::fixed_size_simd<double, kFloatLanes>;

/// The largest error at the floats of a range. Positive floats have the order of their bits. kernel(x, out): out
/// (kOutputs), x of FloatLanes or DoubleLanes. size(output, x): the size that errors are compared with, at x of
/// DoubleLanes, > 0.
template <std::size_t kOutputs, class Kernel, class Size>
FloatError worst_float(const FloatRange& range, const Kernel& kernel, const Size& size) {
  using std::experimental::all_of;
  constexpr double kLeastSize = 0x1p-100;
  FloatError worst;
  const std::uint64_t last = std::bit_cast<std::uint32_t>(range.last);
  for (std::uint64_t bits = std::bit_cast<std::uint32_t>(range.first); bits <= last;
       bits += std::uint64_t{kFloatLanes} * range.stride) {
    const FloatLanes x([&](auto lane) {
      return std::bit_cast<float>(
          static_cast<std::uint32_t>(std::min(bits + lane * std::uint64_t{range.stride}, last)));
    });
    const auto wide = std::experimental::static_simd_cast<DoubleLanes>(x);
    std::array<FloatLanes, kOutputs> out;
    std::array<DoubleLanes, kOutputs> exact;
    kernel(x, out.data());
    kernel(wide, exact.data());
    worst.evaluated += kFloatLanes;
    for (std::size_t i = 0; i < kOutputs; ++i) {
      const DoubleLanes error = std::experimental::static_simd_cast<DoubleLanes>(out[i]) - exact[i];
      const DoubleLanes magnitude = std::experimental::max(error, -error);
      const DoubleLanes allowed = size(i, wide) * static_cast<double>(std::numeric_limits<float>::epsilon());
      if (all_of(magnitude <= worst.error * allowed)) continue;  // false for values that are not numbers
      for (std::size_t lane = 0; lane < kFloatLanes; ++lane) {
        if (allowed[lane] < kLeastSize) continue;
        double found = magnitude[lane] / allowed[lane];
        if (!(found >= 0)) found = std::numeric_limits<double>::infinity();
        if (found > worst.error) worst = {found, x[lane], i, worst.evaluated};
      }
    }
  }
  return worst;
}

}  // namespace sh::numeric
