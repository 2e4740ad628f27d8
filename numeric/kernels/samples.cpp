// See samples.hpp.
#include "numeric/kernels/samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "numeric/kernels/flat_call.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

// The oracle's real beside kernels of type T: many more digits, and no more than that.
template <class T>
using OracleReal = std::conditional_t<std::is_same_v<T, float>, long double, Mpfr50>;

template <class Real>
void append(std::vector<Wide>& all, const std::vector<Real>& values) {
  for (const auto& value : values) all.push_back(Wide::from(value));
}

}  // namespace

std::string output_label(const Signature& signature, int degree, std::size_t output) {
  if (signature.returns_value && output-- == 0) return "value";
  for (const auto& parameter : signature.parameters) {
    if (!parameter.is_written()) continue;
    const auto values = static_cast<std::size_t>(parameter.values());
    if (output >= values) {
      output -= values;
      continue;
    }
    if (parameter.values() != coefficient_count(degree)) return parameter.name + "[" + std::to_string(output) + "]";
    const auto l = static_cast<std::size_t>(std::sqrt(static_cast<double>(output)));
    const auto m = static_cast<long>(output) - static_cast<long>(l * (l + 1));
    return parameter.name + " l=" + std::to_string(l) + " m=" + std::to_string(m);
  }
  throw std::logic_error("output_label: no such output");
}

template <class T>
Samples<T> make_samples(const FamilyCheck& check, int degree) {
  using Real = OracleReal<T>;
  Samples<T> samples;
  samples.signature = check.signature(degree);
  const auto width = static_cast<std::size_t>(samples.signature.input_count());
  const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
  std::vector<Real> exact(outputs);
  for (const auto& input : check.inputs(degree)) {
    std::vector<double> rounded;
    for (const double value : input.values) rounded.push_back(static_cast<double>(static_cast<T>(value)));
    samples.names.push_back(input.name);
    for (const double value : rounded) samples.inputs.push_back(static_cast<T>(value));
    std::vector<Real> point(rounded.begin(), rounded.end());
    if (check.nearest) {
      std::vector<Real> nearest(width);
      check.nearest(degree, point.data(), nearest.data());
      append(samples.in_domain, nearest);
      point = nearest;
    }
    check.oracle(degree, point.data(), exact.data());
    append(samples.exact, exact);
    for (std::size_t i = 0; i < outputs; ++i) samples.sizes.push_back(check.size(degree, rounded.data(), i));
  }
  return samples;
}

template <class T>
std::vector<Wide> own_formula(const BoundKernel& kernel, const Samples<T>& samples) {
  if (samples.in_domain.empty()) return samples.exact;
  const auto width = static_cast<std::size_t>(samples.signature.input_count());
  const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
  FlatCall<Wide> call(kernel, samples.signature);
  std::vector<Wide> result = samples.exact;
  std::vector<Wide> at_input(outputs);
  std::vector<Wide> at_nearest(outputs);
  for (std::size_t k = 0; k < samples.count(); ++k) {
    const T* const input = samples.input(k);
    std::vector<Wide> rounded;
    for (std::size_t i = 0; i < width; ++i) rounded.emplace_back(static_cast<double>(input[i]));
    call(rounded.data(), at_input.data());
    call(samples.in_domain.data() + k * width, at_nearest.data());
    for (std::size_t i = 0; i < outputs; ++i) {
      Wide& own = result[k * outputs + i];
      own = own + (at_input[i] - at_nearest[i]);
    }
  }
  return result;
}

template <class T>
ErrorStats errors_of(const Samples<T>& samples, const std::vector<T>& values, const std::vector<Wide>& truth,
                     double smallest_size) {
  ErrorStats errors(static_cast<double>(std::numeric_limits<T>::epsilon()));
  const auto outputs = static_cast<std::size_t>(std::max(1, samples.signature.output_count()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double size = samples.sizes[i] == 0 ? 0 : std::max(samples.sizes[i], smallest_size);
    errors.add({i / outputs, i % outputs}, (Wide(static_cast<double>(values[i])) - truth[i]).high(), size);
  }
  return errors;
}

template <class T>
WorstCase worst_case(const Place& worst, int degree, const Samples<T>& samples) {
  const T* const input = samples.input(worst.input);
  return {samples.names[worst.input],
          {input, input + samples.signature.input_count()},
          output_label(samples.signature, degree, worst.output)};
}

template Samples<float> make_samples<float>(const FamilyCheck&, int);
template Samples<double> make_samples<double>(const FamilyCheck&, int);
template std::vector<Wide> own_formula<float>(const BoundKernel&, const Samples<float>&);
template std::vector<Wide> own_formula<double>(const BoundKernel&, const Samples<double>&);
template ErrorStats errors_of<float>(const Samples<float>&, const std::vector<float>&, const std::vector<Wide>&,
                                     double);
template ErrorStats errors_of<double>(const Samples<double>&, const std::vector<double>&, const std::vector<Wide>&,
                                      double);
template WorstCase worst_case<float>(const Place&, int, const Samples<float>&);
template WorstCase worst_case<double>(const Place&, int, const Samples<double>&);

}  // namespace sh::numeric
