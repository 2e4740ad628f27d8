#include "numeric/plot/sphere_function.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/legendre.hpp"

namespace sh::numeric::plot {
namespace {

// sum_i c_i Y_i = sum_m s_m(z) Re (x+iy)^m + s_-m(z) Im (x+iy)^m with s_m(z) = sqrt 2 sum_l c_lm Q_l|m|(z): the sums of
// a ring are kept until z changes.
class CoefficientSum {
 public:
  CoefficientSum(std::vector<double> coefficients, int channels, int degree)
      : coefficients_(std::move(coefficients)),
        channels_(channels),
        degree_(degree),
        rows_(degree),
        ring_(static_cast<std::size_t>(channels * (2 * degree + 1))) {}

  Channels operator()(const Vector3& s) {
    const double u2 = s[0] * s[0] + s[1] * s[1];
    if (s[2] != z_) sum_ring(s[2], u2);
    Channels values{};
    for (int channel = 0; channel < channels_; ++channel) {
      const auto* sums = ring_.data() + ring_size() * channel + degree_;
      double real = 1;
      double imaginary = 0;
      double value = sums[0];
      for (int m = 1; m <= degree_; ++m) {
        const double next = real * s[0] - imaginary * s[1];
        imaginary = real * s[1] + imaginary * s[0];
        real = next;
        value += sums[m] * real + sums[-m] * imaginary;
      }
      values[channel] = value;
    }
    return values;
  }

 private:
  [[nodiscard]] std::ptrdiff_t ring_size() const { return 2 * std::ptrdiff_t{degree_} + 1; }

  void sum_ring(double z, double u2) {
    z_ = z;
    std::fill(ring_.begin(), ring_.end(), 0.0);
    for (int l = 0; l <= degree_; ++l) {
      rows_.visit(l, 0, z, u2,
                  [&](int m, const Scaled<double>& q) { add(l, m, std::ldexp(q.mantissa, int(q.exponent))); });
    }
  }

  void add(int l, int m, double q) {
    const double factor = m == 0 ? q : std::numbers::sqrt2 * q;
    for (int channel = 0; channel < channels_; ++channel) {
      const auto* c = coefficients_.data() + std::ptrdiff_t{coefficient_count(degree_)} * channel;
      auto* sums = ring_.data() + ring_size() * channel + degree_;
      sums[m] += factor * c[coefficient_index(l, m)];
      if (m > 0) sums[-m] += factor * c[coefficient_index(l, -m)];
    }
  }

  std::vector<double> coefficients_;  // (channels, bands^2)
  int channels_;
  int degree_;
  ReducedRows<double> rows_;
  double z_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> ring_;  // (channels, 2 degree + 1), order 0 in the middle
};

// The bands of so many coefficients; 0 if the count is no square.
int bands_of(std::size_t count) {
  const auto bands = std::lround(std::sqrt(static_cast<double>(count)));
  return bands <= kLargestDegree + 1 && bands * bands == static_cast<long>(count) ? static_cast<int>(bands) : 0;
}

double magnitude_at(const SphereFunction& f, const Vector3& s) {
  const auto values = f.value(s);
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

}  // namespace

SphereFunction function_of_coefficients(std::span<const double> coefficients) {
  const std::size_t count = coefficients.size();
  constexpr std::size_t kMost = coefficient_count(kLargestDegree);
  if (count > 3 * kMost) {
    throw std::invalid_argument(
        fmt::format("expected at most {} numbers a channel, for degree {}, got {}", kMost, kLargestDegree, count));
  }
  const bool single = bands_of(count) > 0;
  const int bands = single ? bands_of(count) : (count % 3 == 0 ? bands_of(count / 3) : 0);
  if (bands == 0) {
    throw std::invalid_argument(fmt::format(
        "expected bands^2 numbers (1, 4, 9, 16, ..., {}) or, for red, green and blue, three times that, got {}", kMost,
        count));
  }
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(coefficients[i]))
      throw std::invalid_argument(fmt::format("number {}: expected a finite one", i + 1));
    largest = std::max(largest, std::abs(coefficients[i]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<double> scaled(coefficients.begin(), coefficients.end());
  for (double& c : scaled) c = std::ldexp(c, -exponent);
  const int channels = single ? 1 : 3;
  return {channels, bands - 1, CoefficientSum(std::move(scaled), channels, bands - 1), exponent};
}

Vector3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

SphereFunction basis_function(int degree, int order) {
  std::vector<double> coefficients(coefficient_count(degree));
  coefficients[coefficient_index(degree, order)] = 1;
  return function_of_coefficients(coefficients);
}

SphereFunction channel_of(const SphereFunction& f, int channel) {
  const auto place = static_cast<std::size_t>(channel);
  return {1, f.degree, [value = f.value, place](const Vector3& s) { return Channels{value(s)[place]}; }, f.exponent};
}

Largest largest_magnitude(const SphereFunction& f) {
  Largest best;
  double theta = 0;
  double phi = 0;
  const auto try_at = [&](double t, double p) {
    const Vector3 s = direction(t, p);
    const double magnitude = magnitude_at(f, s);
    if (magnitude <= best.magnitude) return false;
    best = {magnitude, s};
    theta = t;
    phi = p;
    return true;
  };
  // A grid that includes the poles and the axes: 8 nodes a half-wave at least.
  const int rings = 8 * (f.degree + 2);
  double step = std::numbers::pi / rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) try_at(i * step, j * step);
  }
  // Uphill from the best node, along theta and along phi, with a step that shrinks where nothing is gained.
  while (step > 1e-9) {
    const double t = theta;
    const double p = phi;
    const bool higher = try_at(t + step, p) || try_at(t - step, p) || try_at(t, p + step) || try_at(t, p - step);
    if (!higher) step /= 2;
  }
  return best;
}

std::string describe(const Largest& largest, int exponent) {
  if (largest.magnitude == 0) return "zero function";
  // Rounded first, so that no "-0.00" appears.
  const auto part = [&](int i) { return std::round(100 * largest.where[i]) / 100 + 0.0; };
  return fmt::format("largest magnitude {} at ({:.2f}, {:.2f}, {:.2f})", format_value(largest.magnitude, exponent),
                     part(0), part(1), part(2));
}

std::string format_value(double value, int exponent) {
  // long double holds every double times every power that a coefficient can have.
  return fmt::format("{:.3g}", std::ldexp(static_cast<long double>(value) + 0.0L, exponent));
}

}  // namespace sh::numeric::plot
