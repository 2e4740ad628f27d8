// The generated kernels of one variable, to be run on every float of their domain (every_float.hpp): caps by 1 - cos of
// their angle, and windows by their parameter, as the factor that they multiply a band with.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernels/every_float.hpp"

namespace sh::numeric {

struct OneVariableKernel {
  std::string family;
  int degree = 0;
  float largest = 0;  // the domain is 0 to this
  // Of the kernel on the floats of a range, in the unit of the family's check.
  FloatError (*worst)(const FloatRange& range) = nullptr;

  [[nodiscard]] std::string name() const { return family + "_l" + std::to_string(degree); }
};

std::vector<OneVariableKernel> one_variable_kernels();

}  // namespace sh::numeric
