#include "codegen/measure/measure.hpp"

#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "codegen/measure/arithmetic.hpp"
#include "codegen/measure/rotations.hpp"
#include "numeric/kernels/size_formula.hpp"

namespace sh::codegen {
namespace {

// More than double needs, even after the cancellation at the largest degree.
constexpr int kDigits = 40;

// Every float and double is exact in more digits. CLN reads no subnormal double; these count as 0.
cln::cl_F exact(double value) {
  const bool subnormal = std::abs(value) < std::numeric_limits<double>::min();
  return cln::cl_float(subnormal ? 0 : value, cln::float_format(kDigits));
}

// True if the difference is larger in eps than the error so far.
template <class T>
bool take_largest(Error& error, const cln::cl_F& difference, double size) {
  if (cln::zerop(difference)) return false;  // the size may be 0
  const double absolute = cln::double_approx(cln::abs(difference));
  const double eps = absolute / (Arithmetic<T>::kEpsilon * size);
  error.absolute = std::max(error.absolute, absolute);
  if (eps <= error.eps) return false;
  error.eps = eps;
  return true;
}

template <class T>
std::vector<double> as_doubles(const std::vector<T>& values) {
  std::vector<double> result;
  for (const T value : values) result.push_back(static_cast<double>(value));
  return result;
}

using Iterator = std::vector<cln::cl_F>::iterator;

void scale_to_length_one(Iterator first, std::size_t size) {
  cln::cl_F square = first[0] * first[0];
  for (std::size_t i = 1; i < size; ++i) square = square + first[static_cast<long>(i)] * first[static_cast<long>(i)];
  const cln::cl_F length = cln::sqrt(square);
  std::for_each(first, first + static_cast<long>(size), [&](cln::cl_F& value) { value = value / length; });
}

void move_to_domain(const Parameter& parameter, Iterator first) {
  switch (parameter.role) {
    case Role::kDirection:
      if (parameter.axis == 0) scale_to_length_one(first, 3);
      break;
    case Role::kQuaternion:
      scale_to_length_one(first, 4);
      break;
    case Role::kCosine:  // its sine follows
      scale_to_length_one(first, 2);
      break;
    case Role::kRotationMatrix: {
      const std::vector<cln::cl_F> nearest = nearest_rotation({first, first + parameter.size()});
      std::copy(nearest.begin(), nearest.end(), first);
      break;
    }
    default:
      break;
  }
}

numeric::Parameter described(const Parameter& array, numeric::Access access) {
  return {.name = array.name,
          .count = array.shape.empty() ? 0 : array.size(),
          .access = access,
          .role = role_name(array.role),
          .degree = array.degree,
          .channels = array.channels()};
}

}  // namespace

std::vector<cln::cl_F> nearest_in_domain(const std::vector<Parameter>& parameters, std::vector<cln::cl_F> inputs) {
  auto first = inputs.begin();
  for (const Parameter& parameter : parameters) {
    move_to_domain(parameter, first);
    first += parameter.size();
  }
  return inputs;
}

std::string nearest_point(const std::vector<Parameter>& parameters) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
  for (const Parameter& parameter : parameters) {
    if (parameter.role == Role::kDirection && parameter.axis == 0) {
      add(parameters.size() == 3 ? "the input scaled to length 1" : "the direction scaled to length 1");
    }
    if (parameter.role == Role::kQuaternion) add("the quaternion scaled to length 1");
    if (parameter.role == Role::kCosine) add("cosine and sine scaled to the unit circle");
    if (parameter.role == Role::kRotationMatrix) add("the nearest rotation matrix");
  }
  return text;
}

numeric::Signature printed_signature(const Kernel& kernel) {
  using numeric::Access;
  numeric::Signature signature;
  signature.returns_value = kernel.returns_scalar();
  for (const Parameter& parameter : kernel.parameters) {
    const bool updated = position_of(kernel.results, parameter.name) >= 0;
    signature.parameters.push_back(described(parameter, updated ? Access::kInOut : Access::kIn));
  }
  if (signature.returns_value) return signature;
  for (const Parameter& result : kernel.results) {
    if (position_of(kernel.parameters, result.name) < 0)
      signature.parameters.push_back(described(result, Access::kOut));
  }
  return signature;
}

Size size_of(const Kernel& kernel, const Domain& domain) {
  if (domain.size) return domain.size;
  std::function<double(std::size_t)> gain;
  if (domain.gain) gain = [of = domain.gain, degree = kernel.degree](std::size_t i) { return of(degree, i); };
  return [formula = numeric::SizeFormula(domain.sizes, printed_signature(kernel), kernel.degree, gain)](
             std::span<const double> inputs, std::size_t element) { return formula(inputs.data(), element); };
}

template <class T>
void measure_more(MeasuredError& error, const Kernel& kernel, const Domain& domain,
                  const std::vector<std::vector<double>>& inputs) {
  Evaluator<T> rounded = Arithmetic<T>::rounded(kernel);
  Evaluator<cln::cl_F> formula(kernel, kDigits);
  const bool always_in_domain = nearest_point(kernel.parameters).empty();
  const Size size_at = size_of(kernel, domain);
  for (const std::vector<double>& wanted : inputs) {
    std::vector<T> input;
    std::vector<cln::cl_F> exact_input;
    for (const double component : wanted) {
      input.push_back(static_cast<T>(component));
      exact_input.push_back(exact(static_cast<double>(input.back())));
    }
    const std::vector<T> computed = rounded(input);
    const std::vector<cln::cl_F> same_input = formula(exact_input);
    const std::vector<cln::cl_F> in_domain =
        always_in_domain ? same_input : formula(nearest_in_domain(kernel.parameters, exact_input));
    for (std::size_t i = 0; i < computed.size(); ++i) {
      const cln::cl_F value = exact(static_cast<double>(computed[i]));
      const auto element = static_cast<std::size_t>(kernel.element(i));
      const double size = size_at(wanted, element);
      if (take_largest<T>(error.rounding, value - same_input[i], size)) error.worst = as_doubles(input);
      take_largest<T>(error.total, value - in_domain[i], size);
    }
  }
}

template <class T>
MeasuredError measure(const Kernel& kernel, const Domain& domain) {
  const std::vector<std::vector<double>> inputs = domain.test_inputs(kernel.degree);
  MeasuredError error;
  error.inputs = static_cast<int>(inputs.size());
  measure_more<T>(error, kernel, domain, inputs);
  return error;
}

template void measure_more<float>(MeasuredError&, const Kernel&, const Domain&,
                                  const std::vector<std::vector<double>>&);
template void measure_more<double>(MeasuredError&, const Kernel&, const Domain&,
                                   const std::vector<std::vector<double>>&);
template void measure_more<Half>(MeasuredError&, const Kernel&, const Domain&, const std::vector<std::vector<double>>&);
template MeasuredError measure<float>(const Kernel&, const Domain&);
template MeasuredError measure<double>(const Kernel&, const Domain&);
template MeasuredError measure<Half>(const Kernel&, const Domain&);

FinishedKernel finish(Kernel kernel, Domain domain) {
  const Cost operations = cost(kernel);
  const MeasuredError in_float = measure<float>(kernel, domain);
  const MeasuredError in_double = measure<double>(kernel, domain);
  return {std::move(kernel), std::move(domain), operations, in_float, in_double};
}

}  // namespace sh::codegen
