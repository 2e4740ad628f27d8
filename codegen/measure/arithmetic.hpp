// The types that errors of kernels are measured in.
#pragma once

#include <limits>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/half.hpp"

namespace sh::codegen {

/// The arithmetic of T (float, double, Half).
template <class T>
struct Arithmetic {
  static constexpr const char* kName = "double";
  static constexpr double kEpsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  static constexpr bool kWideRange = true;
  static Evaluator<T> rounded(const Kernel& kernel) { return Evaluator<T>(kernel); }
};
template <>
struct Arithmetic<float> {
  static constexpr const char* kName = "float";
  static constexpr double kEpsilon = 0x1p-23;
  static constexpr bool kWideRange = true;
  static Evaluator<float> rounded(const Kernel& kernel) { return Evaluator<float>(kernel); }
};
template <>
struct Arithmetic<Half> {
  static constexpr const char* kName = "half";
  static constexpr double kEpsilon = 0x1p-10;
  static constexpr bool kWideRange = false;  // vectors of lengths far from 1 overflow
  static Evaluator<Half> rounded(const Kernel& kernel) {
    return {kernel, [](const ExactReal& constant) { return Half(nearest<double>(constant)); }};
  }
};

}  // namespace sh::codegen
