// The least window that keeps a light from ringing below zero [Sloan17]; sphere_extremes.hpp finds the least values.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "numeric/oracle/zonal.hpp"
#include "prt/light/sphere_extremes.hpp"
#include "prt/light/window.hpp"
#include "prt/names.hpp"

namespace sh::prt {
namespace {

constexpr double kRounding = 1e-10;  // of the peak: values above minus this count as not negative
constexpr int kSteps = 64;

/// A_l / pi for irradiance over pi, 1 for radiance.
std::vector<double> kept_factors(Keep keep, int degree) {
  std::vector<double> out(degree + 1, 1.0);
  for (int l = 0; keep == Keep::kIrradiance && l <= degree; ++l) {
    out[l] = numeric::clamped_cosine_factor<double>(l) / numeric::clamped_cosine_factor<double>(0);
  }
  return out;
}

/// The channels of a light, times the factors of the kept quantity and of a window.
class Channels {
 public:
  Channels(const LightCoefficients& light, Keep keep) : kept_(kept_factors(keep, light.degree)), degree_(light.degree) {
    const std::size_t n = light.bands_squared();
    for (int channel = 0; channel < 3; ++channel) {
      const double* c = &light.at(channel, 0);
      const bool is_white = channel > 0 && std::equal(c, c + n, c - n);
      if (!is_white) functions_.emplace_back(c, light.degree);  // white light is searched once
    }
    peak_ = largest(std::vector<double>(kept_.size(), 1.0));
  }

  [[nodiscard]] double peak() const { return peak_; }

  /// The least value over the peak without a window.
  [[nodiscard]] double least(const std::vector<double>& window) const {
    double out = functions_[0].least(times_kept(window)).value;
    for (const BandLimited& f : functions_) out = std::min(out, f.least(times_kept(window)).value);
    return peak_ > 0.0 ? out / peak_ : 0.0;
  }

  [[nodiscard]] double largest(const std::vector<double>& window) const {
    double out = 0.0;
    for (const BandLimited& f : functions_) out = std::max(out, f.largest(times_kept(window)).value);
    return out;
  }

  [[nodiscard]] bool is_negative(const Window& window) const {
    return least(window_factors(window, degree_)) < -kRounding;
  }

  /// The root of the sum of squares of all bands except 0.
  [[nodiscard]] double contrast(LightCoefficients light, const std::vector<double>& window) const {
    apply_factors(times_kept(window), light);
    for (int channel = 0; channel < 3; ++channel) light.at(channel, 0) = 0.0;
    return std::sqrt(std::inner_product(light.values.begin(), light.values.end(), light.values.begin(), 0.0));
  }

 private:
  [[nodiscard]] std::vector<double> times_kept(std::vector<double> window) const {
    std::transform(window.begin(), window.end(), kept_.begin(), window.begin(), std::multiplies<>());
    return window;
  }

  std::vector<double> kept_;
  int degree_;
  std::vector<BandLimited> functions_;
  double peak_ = 0.0;
};

void refuse_negative(const LightCoefficients& light) {
  static constexpr const char* kChannels[] = {"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel) {
    const double* c = &light.at(channel, 0);
    const bool black = std::all_of(c, c + light.bands_squared(), [](double value) { return value == 0.0; });
    if (!black && !(c[0] > 0.0)) {
      throw std::runtime_error(
          fmt::format("the light's mean {} is {:.3g}; a window can keep a light positive only if its mean is positive",
                      kChannels[channel], c[0]));
    }
  }
}

/// The weakest window that leaves nothing negative. Under fejer the function moves along a line, so that its least
/// value is concave in the strength and bisection finds the only crossing. The other kinds are searched from weak to
/// strong.
double least_strength(const Channels& channels, const WindowChoice& choice) {
  const auto is_negative = [&](double strength) {
    return channels.is_negative(window_of_strength(choice.window.type, choice.window.power, strength));
  };
  double weak = 0.0;
  double strong = 1.0;
  for (int step = 1; choice.window.type != WindowType::kFejer && step < kSteps && strong == 1.0; ++step) {
    const double strength = static_cast<double>(step) / kSteps;
    (is_negative(strength) ? weak : strong) = strength;
  }
  while (strong - weak > 1e-10 * strong) {
    const double middle = 0.5 * (weak + strong);
    (is_negative(middle) ? weak : strong) = middle;
  }
  return strong;
}

}  // namespace

Deringing apply_window(const WindowChoice& choice, LightCoefficients& light) {
  const Channels channels(light, choice.keep);
  const std::vector<double> none(light.degree + 1, 1.0);
  Deringing done{choice};
  done.least_before = channels.least(none);
  done.least_after = done.least_before;
  if (choice.automatic) {
    refuse_negative(light);
    done.needed = done.least_before < -kRounding;
    if (!done.needed) return done;
    done.choice.window = window_of_strength(choice.window.type, choice.window.power, least_strength(channels, choice));
  }
  const std::vector<double> factors = window_factors(done.choice.window, light.degree);
  done.least_after = channels.least(factors);
  done.peak_kept = channels.peak() > 0.0 ? channels.largest(factors) / channels.peak() : 1.0;
  const double before = channels.contrast(light, none);
  done.contrast_kept = before > 0.0 ? channels.contrast(light, factors) / before : 1.0;
  apply_factors(factors, light);
  return done;
}

std::string describe(const Deringing& done) {
  const std::string_view what = word_of(done.choice.keep, kKeepNames);
  if (!done.needed) return fmt::format("no window is needed: the {} is nowhere negative", what);
  return fmt::format(
      "{}window {}: least {} {:.3g} of the peak, {:.3g} without; keeps {:.1f} % of the peak and "
      "{:.1f} % of the contrast (root mean square)",
      done.choice.automatic ? "least " : "", describe(done.choice.window), what, done.least_after, done.least_before,
      100.0 * done.peak_kept, 100.0 * done.contrast_kept);
}

}  // namespace sh::prt
