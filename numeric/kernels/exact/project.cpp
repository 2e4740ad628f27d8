// Projection of samples: project and project_moments (d, weight, sum in place), project_finish moments -> c. Against
// the oracle's basis, powers of x + iy, and the interpolated polynomials of polynomial_forms.
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/kernels/exact/polynomial_forms.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/directions.hpp"

namespace sh::numeric {
namespace {

// out (bands^2) = z^n Re (x+iy)^m at l(l+1)+m, z^n Im (x+iy)^m at l(l+1)-m, l = m+n.
template <class Real>
void moments(int degree, const Real& x, const Real& y, const Real& z, Real* out) {
  Real real = 1;
  Real imaginary = 0;
  for (int m = 0; m <= degree; ++m) {
    Real power = 1;
    for (int l = m; l <= degree; ++l) {
      out[coefficient_index(l, -m)] = power * imaginary;
      out[coefficient_index(l, m)] = power * real;
      power *= z;
    }
    const Real next = x * real - y * imaginary;
    imaginary = x * imaginary + y * real;
    real = next;
  }
}

// x, y, z, weight, sum (bands^2); function(degree, x, y, z, values): added by a sample of weight 1.
template <class Function>
auto sample_of(Function function) {
  return [function](int degree, const auto* in, auto* out) {
    std::vector<std::remove_cvref_t<decltype(*in)>> values(coefficient_count(degree));
    function(degree, in[0], in[1], in[2], values.data());
    for (std::size_t i = 0; i < values.size(); ++i) out[i] = in[4 + i] + in[3] * values[i];
  };
}

// Moments of a few random samples whose weights have the sum 1.
std::vector<NamedInput> moments_of_samples(int degree) {
  constexpr std::size_t kInputs = 150;
  constexpr std::size_t kSamples = 5;
  const auto directions = random_directions(kInputs * kSamples, 324);
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<NamedInput> inputs;
  std::vector<double> values(count);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (i % kSamples == 0) inputs.push_back({"samples " + std::to_string(i / kSamples), std::vector<double>(count)});
    const Direction& d = directions[i];
    moments(degree, d.x, d.y, d.z, values.data());
    for (std::size_t j = 0; j < count; ++j) inputs.back().values[j] += values[j] / kSamples;
  }
  return inputs;
}

}  // namespace

std::vector<ExactFamily> exact_project() {
  return {{"project", sample_of([](int degree, const auto& x, const auto& y, const auto& z, auto* out) {
             basis(degree, x, y, z, out);
           })},
          {"project_moments", sample_of([](int degree, const auto& x, const auto& y, const auto& z, auto* out) {
             moments(degree, x, y, z, out);
           })},
          {"project_finish", [](int degree, const auto* in, auto* out) { multiply(finish_matrix(degree), in, out); },
           moments_of_samples}};
}

}  // namespace sh::numeric
