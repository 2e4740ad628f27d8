#include "codegen/measure.hpp"

#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "codegen/directions.hpp"
#include "codegen/evaluate.hpp"

namespace sh::codegen {
namespace {

// Far beyond double, and what the largest degree loses on the way.
constexpr int kDigits = 40;

template <class T>
cln::cl_F exact(T value) {
  // Every float and double is an integer times a power of two.
  int exponent = 0;
  const double mantissa = std::frexp(static_cast<double>(value), &exponent);
  const auto integer = static_cast<long>(std::ldexp(mantissa, std::numeric_limits<double>::digits));
  return cln::scale_float(cln::cl_float(cln::cl_I(integer), cln::float_format(kDigits)),
                          exponent - std::numeric_limits<double>::digits);
}

std::vector<cln::cl_F> normalised(const std::vector<cln::cl_F>& d) {
  const cln::cl_F length = cln::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

template <class T>
void take_largest(Error& error, const cln::cl_F& difference, std::size_t output) {
  const double absolute = cln::double_approx(cln::abs(difference));
  const double band = std::floor(std::sqrt(static_cast<double>(output)));
  const double band_maximum = std::sqrt((2 * band + 1) / (4 * std::numbers::pi));
  error.absolute = std::max(error.absolute, absolute);
  error.eps = std::max(error.eps, absolute / (static_cast<double>(std::numeric_limits<T>::epsilon()) * band_maximum));
}

}  // namespace

template <class T>
MeasuredError measure_on_sphere(const Kernel& kernel) {
  MeasuredError result;
  Evaluator<T> rounded(kernel);
  Evaluator<cln::cl_F> formula(kernel, kDigits);
  for (const std::array<T, 3>& d : test_directions<T>()) {
    const std::vector<cln::cl_F> input{exact(d[0]), exact(d[1]), exact(d[2])};
    const std::vector<T> computed = rounded(d);
    const std::vector<cln::cl_F> same_input = formula(input);
    const std::vector<cln::cl_F> unit_input = formula(normalised(input));
    for (std::size_t i = 0; i < computed.size(); ++i) {
      const cln::cl_F value = exact(computed[i]);
      take_largest<T>(result.rounding, value - same_input[i], i);
      take_largest<T>(result.total, value - unit_input[i], i);
    }
    ++result.directions;
  }
  return result;
}

template MeasuredError measure_on_sphere<float>(const Kernel&);
template MeasuredError measure_on_sphere<double>(const Kernel&);

}  // namespace sh::codegen
