#include "codegen/measure/measure.hpp"

#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/nearest.hpp"
#include "codegen/measure/size.hpp"

namespace sh::codegen {
namespace {

// More than double needs, even after the cancellation at the largest degree.
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

template <class T>
void take_largest(Error& error, const cln::cl_F& difference, double size) {
  if (cln::zerop(difference)) return;  // the size may be 0
  const double absolute = cln::double_approx(cln::abs(difference));
  error.absolute = std::max(error.absolute, absolute);
  error.eps = std::max(error.eps, absolute / (static_cast<double>(std::numeric_limits<T>::epsilon()) * size));
}

}  // namespace

template <class T>
MeasuredError measure(const Kernel& kernel, const Domain& domain) {
  MeasuredError result;
  Evaluator<T> rounded(kernel);
  Evaluator<cln::cl_F> formula(kernel, kDigits);
  const bool always_in_domain = nearest_point(kernel.parameters).empty();
  const Size size_at = size_of(kernel, domain);
  for (const std::vector<double>& wanted : domain.test_inputs(kernel.degree)) {
    std::vector<T> input;
    std::vector<cln::cl_F> exact_input;
    for (const double component : wanted) {
      input.push_back(static_cast<T>(component));
      exact_input.push_back(exact(input.back()));
    }
    const std::vector<T> computed = rounded(input);
    const std::vector<cln::cl_F> same_input = formula(exact_input);
    const std::vector<cln::cl_F> in_domain =
        always_in_domain ? same_input : formula(nearest_in_domain(kernel.parameters, exact_input));
    for (std::size_t i = 0; i < computed.size(); ++i) {
      const cln::cl_F value = exact(computed[i]);
      const auto element = static_cast<std::size_t>(kernel.element(i));
      const double size = size_at(wanted, element);
      take_largest<T>(result.rounding, value - same_input[i], size);
      take_largest<T>(result.total, value - in_domain[i], size);
    }
    ++result.inputs;
  }
  return result;
}

template MeasuredError measure<float>(const Kernel&, const Domain&);
template MeasuredError measure<double>(const Kernel&, const Domain&);

}  // namespace sh::codegen
