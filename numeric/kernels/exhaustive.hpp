// The error of the generated kernels of one variable at all floats of a range, or at every n-th: caps by 1 - cos of
// their angle, and windows by their parameter, as the factor of a band.
//
// The reference is the same kernel in double, whose own rounding, 2^-29 of float's, does not matter; kernel_check tests
// the formula itself. Where the size is below 2^-100, digits are lost to underflow: these errors do not count.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sh::numeric {

struct FloatRange {
  float first = 0, last = 0;  // 0 <= first <= last
  std::uint32_t stride = 1;   // 1: every float
};

/// The largest error and where it is.
struct FloatError {
  double error = 0;  // in epsilon x size; infinite where the kernel gives a value that is not a number
  float at = 0;
  std::size_t output = 0;
  std::uint64_t evaluated = 0;
};

struct OneVariableKernel {
  std::string family;
  int degree = 0;
  float largest = 0;                                       // the domain is 0 to this
  FloatError (*worst)(const FloatRange& range) = nullptr;  // in the unit of the family's check

  [[nodiscard]] std::string name() const { return family + "_l" + std::to_string(degree); }
};

std::vector<OneVariableKernel> one_variable_kernels();

}  // namespace sh::numeric
