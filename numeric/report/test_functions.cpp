// test_functions and zonal_coefficients of projection_convergence.hpp.
#include <array>
#include <cmath>
#include <numbers>

#include "generated/cpp/evaluate_l5.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/report/projection_convergence.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::array<double, 3> kAxis{0.36, -0.48, 0.8};
constexpr int kBandLimit = 5;
constexpr double kSharpness = 4;
const double kCapCosine = std::cos(40 * kPi / 180);
constexpr double kSunRadiance = 1e6;
constexpr double kSunRadius = kPi / 180;

double along_axis(double x, double y, double z) { return kAxis[0] * x + kAxis[1] * y + kAxis[2] * z; }

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

std::vector<double> about_axis(int degree, const std::function<double(double)>& profile, double from, int nodes) {
  return zonal_coefficients(degree, profile, from, nodes, kAxis);
}

// Exact: P_l is a polynomial.
std::vector<double> disc(int degree, double cosine) {
  return about_axis(
      degree, [](double) { return 1.0; }, cosine, degree / 2 + 1);
}

TestFunction band_limited() {
  std::vector<double> c(coefficient_count(kBandLimit));
  Random random(7);
  for (double& value : c) value = random.next();
  const auto value = [c](double x, double y, double z) { return sh::evaluate_l5(c.data(), x, y, z); };
  const auto coefficients = [c](int degree) {
    std::vector<double> all = c;
    all.resize(coefficient_count(degree));
    return all;
  };
  return {"band_limited", "a random function of degree 5", value, coefficients};
}

TestFunction smooth() {
  const auto profile = [](double t) { return std::exp(kSharpness * (t - 1)); };
  return {"smooth", "exp(4 (cos - 1)) about an axis",
          [profile](double x, double y, double z) { return profile(along_axis(x, y, z)); },
          [profile](int degree) { return about_axis(degree, profile, -1, degree / 2 + 32); }};
}

TestFunction cap() {
  return {"cap", "1 within 40 degrees of an axis, else 0",
          [](double x, double y, double z) { return along_axis(x, y, z) > kCapCosine ? 1.0 : 0.0; },
          [](int degree) { return disc(degree, kCapCosine); }};
}

TestFunction sun() {
  const double cosine = std::cos(kSunRadius);
  const auto coefficients = [cosine](int degree) {
    std::vector<double> c = times(kSunRadiance - 1, disc(degree, cosine));
    c[0] += std::sqrt(4 * kPi);
    return c;
  };
  return {"sun", "a sky of 1 with a disc of 1e6, radius 1 degree",
          [cosine](double x, double y, double z) { return along_axis(x, y, z) > cosine ? kSunRadiance : 1.0; },
          coefficients};
}

}  // namespace

std::vector<double> zonal_coefficients(int degree, const std::function<double(double)>& profile, double from, int nodes,
                                       std::span<const double, 3> axis) {
  const auto rule = gauss_legendre<double>(nodes);
  const double half = 0.5 * (1 - from);
  std::vector<double> integrals(static_cast<std::size_t>(degree) + 1);  // of profile P_l
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = 1 - half * (1 - rule.nodes[k]);
    const double sine = std::sqrt(half * (1 - rule.nodes[k]) * (1 + t));
    const std::vector<double> y = basis(degree, sine, 0.0, t);
    for (int l = 0; l <= degree; ++l) {
      const double legendre = y[coefficient_index(l, 0)] / std::sqrt((2 * l + 1) / (4 * kPi));
      integrals[l] += rule.weights[k] * half * profile(t) * legendre;
    }
  }
  std::vector<double> c = basis(degree, axis[0], axis[1], axis[2]);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      c[coefficient_index(l, m)] *= 2 * kPi * integrals[l];
    }
  }
  return c;
}

std::span<const TestFunction> test_functions() {
  static const std::array<TestFunction, 4> kFunctions{band_limited(), smooth(), cap(), sun()};
  return kFunctions;
}

}  // namespace sh::numeric
