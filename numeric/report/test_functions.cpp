// test_functions and zonal_coefficients of projection_convergence.hpp.
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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

// sky + height profile(t) where the cosine t to the axis is above `from` (-1: everywhere), else sky. `more_nodes`: of the
// quadrature, beyond those for a constant profile.
TestFunction zonal(std::string name, std::string description, double sky, double height, double (*profile)(double t),
                   double from, int more_nodes) {
  const auto value = [=](double x, double y, double z) {
    const double t = kAxis[0] * x + kAxis[1] * y + kAxis[2] * z;
    return sky + (from <= -1 || t > from ? height * profile(t) : 0);
  };
  const auto coefficients = [=](int degree) {
    std::vector<double> c = zonal_coefficients(degree, profile, from, degree / 2 + 1 + more_nodes, kAxis);
    for (double& value_of : c) value_of *= height;
    c[0] += sky * std::sqrt(4 * kPi);
    return c;
  };
  return {std::move(name), std::move(description), value, coefficients};
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
  const auto one = [](double /*t*/) { return 1.0; };
  const auto peak = [](double t) { return std::exp(4 * (t - 1)); };
  static const std::array<TestFunction, 4> kFunctions{
      band_limited(), zonal("smooth", "exp(4 (cos - 1)) about an axis", 0, 1, peak, -1, 31),
      zonal("cap", "1 within 40 degrees of an axis, else 0", 0, 1, one, std::cos(40 * kPi / 180), 0),
      zonal("sun", "a sky of 1 with a disc of 1e6, radius 1 degree", 1, 1e6 - 1, one, std::cos(kPi / 180), 0)};
  return kFunctions;
}

}  // namespace sh::numeric
