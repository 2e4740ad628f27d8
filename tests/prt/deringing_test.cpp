// Windows, the extremes of band-limited functions, and the least window that leaves no negative value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "numeric/oracle/zonal.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/light/sphere_extremes.hpp"
#include "prt/light/window.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr WindowType kAll[] = {WindowType::kHann, WindowType::kSinc, WindowType::kLaplacian, WindowType::kGaussian,
                               WindowType::kFejer};

LightCoefficients sun(int degree) { return white(project_directional(kSlanted, degree), degree); }

std::vector<double> ones(int degree) { return std::vector<double>(degree + 1, 1.0); }

double least_of(const LightCoefficients& light) {
  return BandLimited(light.values.data(), light.degree).least(ones(light.degree)).value;
}

double largest_of(const LightCoefficients& light) {
  return BandLimited(light.values.data(), light.degree).largest(ones(light.degree)).value;
}

TEST(Window, FactorsAreTheFormulasAndNeverGrow) {
  for (const double width : {1.5, 4.0, 10.0, 37.5}) {
    const auto hann = window_factors({WindowType::kHann, width}, kMaxDegree);
    const auto sinc = window_factors({WindowType::kSinc, width, 7}, kMaxDegree);
    const auto gaussian = window_factors({WindowType::kGaussian, width}, kMaxDegree);
    const auto laplacian = window_factors({WindowType::kLaplacian, width}, kMaxDegree);
    for (std::size_t l = 0; l <= kMaxDegree; ++l) {
      const auto degree = static_cast<double>(l);
      const double x = kPi * degree / width;
      EXPECT_NEAR(hann[l], degree < width ? 0.5 + 0.5 * std::cos(x) : 0.0, 1e-14);
      EXPECT_NEAR(sinc[l], l == 0 ? 1.0 : degree < width ? std::pow(std::sin(x) / x, 7.0) : 0.0, 1e-14);
      EXPECT_NEAR(gaussian[l], std::exp(-0.5 * degree * degree / (width * width)), 1e-14);
      EXPECT_NEAR(laplacian[l], 1.0 / (1.0 + width * std::pow(degree * (degree + 1.0), 2.0)), 1e-14);
    }
  }
}

TEST(Window, StrengthsGoFromNothingToBandZeroAndNoFactorGrows) {
  for (const WindowType type : kAll) {
    for (int degree = 0; degree <= kMaxDegree; ++degree) {
      std::vector<double> before = window_factors(window_of_strength(type, 4, 0.0), degree);
      EXPECT_EQ(before, ones(degree));
      for (int step = 1; step <= 100; ++step) {
        const std::vector<double> now = window_factors(window_of_strength(type, 4, step / 100.0), degree);
        EXPECT_EQ(now[0], 1.0);
        for (std::size_t l = 0; l < now.size(); ++l) {
          EXPECT_LE(now[l], before[l] + 1e-14) << describe(window_of_strength(type, 4, step / 100.0)) << " l=" << l;
        }
        before = now;
      }
    }
  }
}

TEST(Window, FejersKernelIsPositiveAndPeaksWhereTheTheoremSays) {
  for (int degree = 1; degree <= kMaxDegree; ++degree) {
    const auto factors = window_factors({WindowType::kFejer, 1.0}, degree);
    double peak = 0.0;
    for (std::size_t l = 0; l < factors.size(); ++l) peak += (2.0 * static_cast<double>(l) + 1.0) * factors[l];
    const int k = degree / 2;
    EXPECT_NEAR(peak, degree % 2 == 0 ? (k + 1.0) * (k + 1.0) : (k + 1.0) * (k + 2.0), 1e-12) << degree;
    const LightCoefficients point = sun(degree);
    const BandLimited kernel(point.values.data(), degree);
    EXPECT_GE(kernel.least(factors).value, -1e-13);
  }
}

TEST(Window, RefusesWidthsThatAreNone) {
  for (const Window& window :
       {Window{WindowType::kHann, 0.5}, Window{WindowType::kSinc, 6.0, 17}, Window{WindowType::kLaplacian, -1.0},
        Window{WindowType::kFejer, 1.5}, Window{WindowType::kHann, std::nan("")}}) {
    EXPECT_THROW(static_cast<void>(window_factors(window, 4)), std::invalid_argument) << describe(window);
  }
}

/// The least value at the points of a spiral; none may lie below the result of the search.
double least_sample(const LightCoefficients& light, int points) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> basis(light.bands_squared());
  for (const auto& node : numeric::fibonacci_nodes(points)) {
    evaluate_basis(light.degree, node.x, node.y, node.z, basis.data());
    least = std::min(least, std::inner_product(basis.begin(), basis.end(), light.values.begin(), 0.0));
  }
  return least;
}

TEST(SphereExtremes, AMillionPointsFindNothingLower) {
  double worst = 0.0;  // how far the points stay above, over the peak
  for (const int degree : {1, 2, 4, 7, kMaxDegree}) {
    const int points = degree == 4 || degree == kMaxDegree ? 1'000'000 : 50'000;
    const LightCoefficients light = random_light(degree, 11U + static_cast<unsigned>(degree));
    const double least = least_of(light);
    const double peak = largest_of(light);
    const double above = least_sample(light, points) - least;
    EXPECT_GE(above, -1e-13 * peak) << degree;
    EXPECT_LT(above, 2.0 * degree * degree * 4.0 * kPi / points * peak) << degree;  // their spacing squared
    worst = std::max(worst, above / peak);
  }
  std::printf("least of a million points above the least found, over the peak: %.1e\n", worst);
}

TEST(SphereExtremes, ManyRandomFunctionsAreNeverLowerThanFound) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const LightCoefficients light = random_light(static_cast<int>(seed) % kMaxDegree + 1, seed);
    ASSERT_GE(least_sample(light, 20'000), least_of(light) - 1e-12) << seed;
  }
}

TEST(SphereExtremes, KnowsTheExtremesOfZonalAndConstantFunctions) {
  const LightCoefficients constant = white({3.5, 0.0, 0.0, 0.0}, 1);
  EXPECT_NEAR(least_of(constant), 3.5 * std::sqrt(0.25 / kPi), 1e-15);
  const LightCoefficients point = sun(2);  // 1 + 3 z + 5 P_2(z), over 4 pi: least at z = -1/5
  EXPECT_NEAR(4.0 * kPi * least_of(point), -1.8, 1e-13);
  EXPECT_NEAR(4.0 * kPi * largest_of(point), 9.0, 1e-13);
}

TEST(Deringing, AConstantLightNeedsNoWindow) {
  LightCoefficients light = white(std::vector<double>{std::sqrt(4.0 * kPi), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 2);
  const LightCoefficients before = light;
  const Deringing done = apply_window({}, light);
  EXPECT_FALSE(done.needed);
  EXPECT_EQ(light.values, before.values);
  EXPECT_EQ(done.contrast_kept, 1.0);
  LightCoefficients black = LightCoefficients::zero(3);
  EXPECT_FALSE(apply_window({}, black).needed);
}

/// The kept function's factors.
LightCoefficients seen(LightCoefficients light, Keep keep) {
  if (keep == Keep::kIrradiance) {
    std::vector<double> factors;
    for (int l = 0; l <= light.degree; ++l) factors.push_back(numeric::clamped_cosine_factor<double>(l));
    apply_factors(factors, light);
  }
  return light;
}

TEST(Deringing, TheLeastWindowLeavesNothingNegativeAndASlightlyWeakerOneSomething) {
  for (const WindowType type : kAll) {
    for (const Keep keep : {Keep::kRadiance, Keep::kIrradiance}) {
      for (const int degree : {2, 3, 4, 6, kMaxDegree}) {
        LightCoefficients light = sun(degree);
        const double peak = largest_of(seen(light, keep));
        const Deringing done = apply_window({{type, 0.0, 2}, true, keep}, light);
        EXPECT_TRUE(done.needed);
        EXPECT_GE(least_of(seen(light, keep)), -1e-9 * peak) << describe(done);
        EXPECT_NEAR(largest_of(seen(light, keep)), done.peak_kept * peak, 1e-9 * peak);
        Window weaker = done.choice.window;
        const bool falls = type == WindowType::kLaplacian || type == WindowType::kFejer;  // with the number
        weaker.size *= falls ? 0.999 : 1.001;
        LightCoefficients again = sun(degree);
        apply_factors(window_factors(weaker, degree), again);
        EXPECT_LT(least_of(seen(again, keep)), -1e-9 * peak) << describe(done);
      }
    }
  }
}

TEST(Deringing, FejerKeepsTheMostOfASunsContrast) {
  for (const int degree : {4, kMaxDegree}) {
    for (const WindowType type : kAll) {
      LightCoefficients light = sun(degree);
      const Deringing done = apply_window({{type, 0.0, 4}, true, Keep::kRadiance}, light);
      std::printf("degree %d, %s: keeps %.1f %% of the peak, %.1f %% of the contrast\n", degree,
                  describe(done.choice.window).c_str(), 100.0 * done.peak_kept, 100.0 * done.contrast_kept);
      LightCoefficients other = sun(degree);
      EXPECT_LE(done.contrast_kept, apply_window({}, other).contrast_kept + 1e-12);
    }
  }
}

TEST(Deringing, OneWindowServesAllChannelsSoThatNoColorShifts) {
  LightCoefficients light = white(project_sky(kClearSky, kSlanted, 4), 4);
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    light.at(1, i) = project_cap(kSlanted, 0.1, 4)[i];  // rings more than the sky
  }
  const LightCoefficients before = light;
  apply_window({}, light);
  EXPECT_GE(BandLimited(&light.values[25], 4).least(ones(4)).value, -1e-9);
  for (const std::size_t i : {2U, 6U, 20U}) {
    EXPECT_NEAR(light.at(0, i) / before.at(0, i), light.at(1, i) / before.at(1, i), 1e-12);
  }
}

TEST(Deringing, NegativeLightsAreRefused) {
  LightCoefficients light = sun(2);
  for (double& value : light.values) value = -value;
  EXPECT_THROW(static_cast<void>(apply_window({}, light)), std::runtime_error);
  LightCoefficients no_mean = sun(2);
  no_mean.at(1, 0) = 0.0;
  EXPECT_THROW(static_cast<void>(apply_window({}, no_mean)), std::runtime_error);
}

}  // namespace
}  // namespace sh::prt::test
