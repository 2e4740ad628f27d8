// Projection of samples: project and project_moments (d, weight, sum in place), project_finish moments -> c. Against
// numeric's basis, powers of x + iy, and the interpolated polynomials of polynomial_forms.
#include <cmath>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/kernels/checks/polynomial_forms.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

constexpr int kRandomDirections = 150;

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

// x, y, z, weight, sum (bands^2); function(degree, x, y, z, values) is what a sample of weight 1 adds.
template <class Function>
FamilyCheck sample_check(const std::string& family, const std::string& unit, double (*largest)(int degree),
                         Function function) {
  return {
      .family = family,
      .signature =
          [](int degree) {
            return Signature{{scalar("x"), scalar("y"), scalar("z"), scalar("weight"),
                              in_out_array("sum", coefficient_count(degree))}};
          },
      .inputs =
          [](int degree) {
            const int count = coefficient_count(degree);
            auto before = vector_inputs(count, 43, 321);
            // Every second sample is added to nothing, so that its own error shows.
            for (std::size_t i = 0; i < before.size(); i += 2) {
              before[i] = {"from zero", std::vector<double>(static_cast<std::size_t>(count))};
            }
            std::vector<NamedInput> weights = {{"weight 1", {1}}, {"weight -0.3", {-0.3}}, {"weight 17", {17}}};
            return combined(combined(direction_inputs(kRandomDirections), weights), before);
          },
      .oracle =
          [function](int degree, const auto* in, auto* out) {
            std::vector<std::remove_cvref_t<decltype(*in)>> values(static_cast<std::size_t>(coefficient_count(degree)));
            function(degree, in[0], in[1], in[2], values.data());
            for (std::size_t i = 0; i < values.size(); ++i) out[i] = in[4 + i] + in[3] * values[i];
          },
      .nearest = with_unit_direction([](int) { return 0; }, [](int degree) { return 4 + coefficient_count(degree); }),
      .size =
          [largest](int /*degree*/, const double* in, std::size_t output) {
            return std::abs(in[3]) * largest(degree_of(output)) + std::abs(in[4 + output]);
          },
      .unit = unit};
}

// Moments of a few random samples whose weights have the sum 1.
std::vector<NamedInput> moment_inputs(int degree) {
  constexpr int kInputs = 150;
  constexpr int kSamples = 5;
  Random random(323);
  const auto directions = random_directions(kInputs * kSamples, 324);
  std::vector<NamedInput> inputs;
  for (int i = 0; i < kInputs; ++i) {
    const auto count = static_cast<std::size_t>(coefficient_count(degree));
    inputs.push_back({"samples " + std::to_string(i), std::vector<double>(count)});
    std::vector<double> values(count);
    for (int k = 0; k < kSamples; ++k) {
      const auto& d = directions[static_cast<std::size_t>(i * kSamples + k)];
      moments(degree, d.x, d.y, d.z, values.data());
      for (std::size_t j = 0; j < count; ++j) inputs.back().values[j] += values[j] / kSamples;
    }
  }
  return inputs;
}

}  // namespace

FamilyCheck project_check() {
  return sample_check(
      "project", "(|weight| sqrt((2l+1)/4pi) + |sum|)", band_maximum,
      [](int degree, const auto& x, const auto& y, const auto& z, auto* out) { basis(degree, x, y, z, out); });
}

FamilyCheck project_moments_check() {
  return sample_check(
      "project_moments", "(|weight| + |moment|)", [](int /*degree*/) { return 1.0; },
      [](int degree, const auto& x, const auto& y, const auto& z, auto* out) { moments(degree, x, y, z, out); });
}

FamilyCheck project_finish_check() {
  return {
      .family = "project_finish",
      .signature =
          [](int degree) {
            const int count = coefficient_count(degree);
            return Signature{{in_array("moments", count), out_array("c", count)}};
          },
      .inputs = moment_inputs,
      .oracle =
          [](int degree, const auto* in, auto* out) {
            multiply(finish_matrix(degree), static_cast<std::size_t>(coefficient_count(degree)), in, out);
          },
      .nearest = {},
      .size = [](int /*degree*/, const double* /*in*/, std::size_t output) { return band_maximum(degree_of(output)); },
      .unit = "sqrt((2l+1)/4pi) x the sum of |weights|"};
}

}  // namespace sh::numeric
