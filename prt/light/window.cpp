#include "prt/light/window.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "generated/cpp/window_gaussian.hpp"
#include "generated/cpp/window_hann.hpp"
#include "generated/cpp/window_lanczos.hpp"
#include "generated/cpp/window_lanczos2.hpp"
#include "generated/cpp/window_lanczos4.hpp"
#include "generated/cpp/window_laplacian.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/names.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The number of a window, its range, and whether it is the degree from which on the factors are 0.
struct Number {
  std::string_view key;
  double least;
  double most;
  const char* range;
  bool is_cut_off = false;
};

/// In the order of WindowType.
constexpr Number kNumbers[] = {{"width", 1.0, kNoLimit, "a width of 1 or more", true},
                               {"width", 1.0, kNoLimit, "a width of 1 or more", true},
                               {"lambda", 0.0, kNoLimit, "a lambda of 0 or more"},
                               {"width", 0.0, kNoLimit, "a width of 0 or more"},
                               {"strength", 0.0, 1.0, "a strength from 0 to 1"}};

const Number& number_of(WindowType type) { return kNumbers[static_cast<int>(type)]; }

/// The kernels multiply; exponents add up.
template <int Degree>
void apply_sinc(double width, int power, double* c) {
  const double x = kPi / width;
  const double cosine = std::cos(x);
  const double sinc = x > 0.0 ? std::sin(x) / x : 1.0;
  for (; power >= 4; power -= 4) sh::window_lanczos4<Degree>(cosine, sinc, c);
  for (; power >= 2; power -= 2) sh::window_lanczos2<Degree>(cosine, sinc, c);
  if (power == 1) sh::window_lanczos<Degree>(cosine, sinc, c);
}

template <int Degree>
void apply_kernel(const Window& window, double* c) {
  switch (window.type) {
    case WindowType::kHann:
      return sh::window_hann<Degree>(std::cos(kPi / window.size), c);
    case WindowType::kSinc:
      return apply_sinc<Degree>(window.size, window.power, c);
    case WindowType::kLaplacian:
      return sh::window_laplacian<Degree>(window.size, c);
    case WindowType::kGaussian:
      return sh::window_gaussian<Degree>(std::exp(-0.5 / (window.size * window.size)), c);
    case WindowType::kFejer:
      return;  // no kernel
  }
}

/// P_0 .. P_last.
std::vector<double> legendre(int last, double z) {
  std::vector<double> p{1.0, z};
  for (int l = 1; l < last; ++l) {
    const auto at = static_cast<std::size_t>(l);
    p.push_back(((2.0 * l + 1.0) * z * p[at] - l * p[at - 1]) / (l + 1.0));
  }
  return p;
}

/// p_l as defined in the header, l = 0..degree.
std::vector<double> fejer_kernel(int degree) {
  const auto rule = numeric::gauss_legendre<double>(degree + 1);
  const int half = degree / 2;
  std::vector<double> out(degree + 1, 0.0);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double z = rule.nodes[k];
    const std::vector<double> p = legendre(degree + 1, z);
    double root = degree % 2 == 0 ? 0.0 : (half + 1.0) * p[static_cast<std::size_t>(half) + 1];
    for (int l = 0; l <= half; ++l) root += (2.0 * l + 1.0) * p[l];
    const double value = rule.weights[k] * root * root / (degree % 2 == 0 ? 1.0 : 1.0 + z);
    for (std::size_t l = 0; l < out.size(); ++l) out[l] += value * p[l];
  }
  for (std::size_t l = out.size(); l-- > 0;) out[l] /= out[0];
  return out;
}

std::vector<double> fejer_factors(double strength, int degree) {
  std::vector<double> factors = fejer_kernel(degree);
  for (double& factor : factors) factor = 1.0 - strength * (1.0 - factor);
  return factors;
}

}  // namespace

std::string_view number_key(WindowType type) { return number_of(type).key; }

std::string window_flaw(const Window& window) {
  const Number& number = number_of(window.type);
  if (!(window.size >= number.least && window.size <= number.most)) return number.range;
  return window.type == WindowType::kSinc && (window.power < 1 || window.power > kMaxPower)
             ? fmt::format("a power from 1 to {}", kMaxPower)
             : "";
}

std::vector<double> window_factors(const Window& window, int degree) {
  require_degree(degree);
  if (const std::string flaw = window_flaw(window); !flaw.empty()) {
    throw std::invalid_argument(fmt::format("{}: needs {}", word_of(window.type, kWindowNames), flaw));
  }
  if (window.type == WindowType::kFejer) return fejer_factors(window.size, degree);
  std::vector<double> ones(coefficient_count(degree), 1.0);
  at_degree(degree, [&](auto known) {
    if constexpr (known() > 0) apply_kernel<known()>(window, ones.data());
  });
  std::vector<double> factors(1, 1.0);
  for (int l = 1; l <= degree; ++l) {
    const bool beyond = number_of(window.type).is_cut_off && l >= window.size;
    factors.push_back(beyond ? 0.0 : ones[coefficient_count(l - 1)]);
  }
  return factors;
}

void apply_factors(const std::vector<double>& factors, LightCoefficients& light) {
  for (int channel = 0; channel < 3; ++channel) scale_bands(factors, &light.at(channel, 0));
}

Window window_of_strength(WindowType type, int power, double strength) {
  const double odds = strength / (1.0 - strength);  // 0 to infinity
  switch (type) {
    case WindowType::kLaplacian:
      return {type, odds * odds * odds * odds, 1};  // as lambda goes with the fourth power of the degree
    case WindowType::kGaussian:
      return {type, 1.0 / odds, 1};
    case WindowType::kFejer:
      return {type, strength, 1};
    default:
      return {type, 1.0 / strength, power};
  }
}

std::string describe(const Window& window) {
  const std::string power = window.type == WindowType::kSinc ? fmt::format("^{}", window.power) : "";
  return fmt::format("{}{} of {} {:.4g}", word_of(window.type, kWindowNames), power, number_key(window.type),
                     window.size);
}

}  // namespace sh::prt
