// The types that errors of kernels are measured in, each with a type of more digits as reference.
#pragma once

#include <limits>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/half.hpp"
#include "numeric/kernels/wide.hpp"

namespace sh::codegen {

/// A constant as the sum of two doubles.
inline numeric::Wide wide(const ExactReal& constant) {
  constexpr int kDigits = 40;
  const cln::cl_F value = evaluate(constant, kDigits);
  const double high = cln::double_approx(value);
  return {high, cln::double_approx(value - cln::cl_float(high, cln::float_format(kDigits)))};
}

/// The arithmetic of T (float, double, Half), a type with more digits, and the type that a search moves inputs in.
template <class T>
struct Arithmetic {
  using Reference = numeric::Wide;
  using Moved = T;
  static constexpr double kEpsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  static constexpr bool kWideRange = true;
  static Evaluator<T> rounded(const Kernel& kernel) { return Evaluator<T>(kernel); }
  static Evaluator<numeric::Wide> formula(const Kernel& kernel) { return Evaluator<numeric::Wide>(kernel, wide); }
};
template <>
struct Arithmetic<float> {
  using Reference = double;
  using Moved = float;
  static constexpr double kEpsilon = 0x1p-23;
  static constexpr bool kWideRange = true;
  static Evaluator<float> rounded(const Kernel& kernel) { return Evaluator<float>(kernel); }
  static Evaluator<double> formula(const Kernel& kernel) { return Evaluator<double>(kernel); }
};
template <>
struct Arithmetic<Half> {
  using Reference = double;
  using Moved = float;
  static constexpr double kEpsilon = 0x1p-10;
  static constexpr bool kWideRange = false;  // vectors of lengths far from 1 overflow
  static Evaluator<Half> rounded(const Kernel& kernel) {
    return {kernel, [](const ExactReal& constant) { return Half(nearest<double>(constant)); }};
  }
  static Evaluator<double> formula(const Kernel& kernel) { return Evaluator<double>(kernel); }
};

}  // namespace sh::codegen
