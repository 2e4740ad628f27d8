// The committed caps, zonal functions, irradiance and windows against quadrature, angles and each other.
#include "generated/cpp/zonal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "generated/cpp/add_cap.hpp"
#include "generated/cpp/add_cap_rgb.hpp"
#include "generated/cpp/cap.hpp"
#include "generated/cpp/irradiance.hpp"
#include "generated/cpp/irradiance_evaluate.hpp"
#include "generated/cpp/irradiance_matrix.hpp"
#include "generated/cpp/irradiance_zh3.hpp"
#include "generated/cpp/irradiance_zh3_rgb.hpp"
#include "generated/cpp/lightmap.hpp"
#include "generated/cpp/lightmap_evaluate.hpp"
#include "generated/cpp/lightmap_project.hpp"
#include "generated/cpp/window_gaussian.hpp"
#include "generated/cpp/window_hann.hpp"
#include "generated/cpp/window_lanczos.hpp"
#include "generated/cpp/window_lanczos2.hpp"
#include "generated/cpp/window_lanczos4.hpp"
#include "generated/cpp/window_laplacian.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh {
namespace {

using test::coefficient_count;
using test::Direction;
using test::directions;
using test::for_degrees_from;
using test::random_array;

int band(std::size_t index) { return static_cast<int>(std::sqrt(static_cast<double>(index))); }

// z_l = 2 pi integral of Y_l0 over the cap, by a Gauss rule in the cosine.
double cap_by_quadrature(int l, double u) {
  const auto rule = numeric::gauss_legendre<double>(12);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double t = 1 - u * (1 + rule.nodes[i]) / 2;
    const double across = std::sqrt(std::max(0.0, 1 - t * t));
    sum += rule.weights[i] * numeric::basis_value<double>(l, 0, across, 0.0, t);
  }
  return std::numbers::pi * u * sum;
}

TEST(GeneratedCap, AgreesWithQuadrature) {
  for_degrees_from<0>([]<int kDegree>() {
    for (const double u : {1e-3, 0.1, 0.5, 1.0, 1.7, 1.99, 2.0}) {
      std::array<double, kDegree + 1> z;
      cap<kDegree>(u, z.data());
      for (int l = 0; l <= kDegree; ++l) EXPECT_NEAR(z[l], cap_by_quadrature(l, u), 8e-15) << l << " " << u;
    }
  });
}

TEST(GeneratedZonal, TurnsALobeToADirection) {
  for_degrees_from<0>([]<int kDegree>() {
    const auto lobe = random_array<kDegree + 1>(3);
    for (const Direction& d : directions(20)) {
      std::array<double, coefficient_count(kDegree)> out;
      zonal<kDegree>(lobe.data(), d[0], d[1], d[2], out.data());
      const auto y = numeric::basis<double>(kDegree, d[0], d[1], d[2]);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const auto l = static_cast<double>(band(i));
        EXPECT_NEAR(out[i], std::sqrt(4 * std::numbers::pi / (2 * l + 1)) * lobe[band(i)] * y[i], 1e-14);
      }
    }
  });
}

TEST(GeneratedZonal, TowardsThePoleIsTheLobeItself) {
  for_degrees_from<0>([]<int kDegree>() {
    const auto lobe = random_array<kDegree + 1>(4);
    std::array<double, coefficient_count(kDegree)> out;
    zonal<kDegree>(lobe.data(), 0.0, 0.0, 1.0, out.data());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t l = band(i);
      EXPECT_NEAR(out[i], i == l * (l + 1) ? lobe[l] : 0.0, 4e-15);
    }
  });
}

TEST(GeneratedAddCap, AddsTheCapTurnedToItsDirection) {
  for_degrees_from<0>([]<int kDegree>() {
    constexpr std::size_t kCount = coefficient_count(kDegree);
    for (const Direction& d : directions(5)) {
      std::array<double, kDegree + 1> z;
      cap<kDegree>(0.3, z.data());
      std::array<double, kCount> light;
      zonal<kDegree>(z.data(), d[0], d[1], d[2], light.data());
      const auto before = random_array<3 * kCount>(5);
      auto sum = before;
      add_cap<kDegree>(d[0], d[1], d[2], 0.3, 2.5, sum.data());
      for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(sum[i], before[i] + 2.5 * light[i], 2e-14);
      EXPECT_EQ(sum[kCount], before[kCount]);
      sum = before;
      add_cap_rgb<kDegree>(d[0], d[1], d[2], 0.3, 2.5, -1.0, 0.125, sum.data());
      const std::array<double, 3> color{2.5, -1, 0.125};
      for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(sum[i], before[i] + color[i / kCount] * light[i % kCount], 2e-14);
    }
  });
}

TEST(GeneratedAddCap, TinyLightsOfGreatRadianceKeepTheirEnergy) {
  // Radiance 1 / solid angle: a delta function of unit energy, c_lm = Y_lm(d), to 24 bits.
  const double u = 1e-30;
  const auto intensity = static_cast<float>(1 / (2 * std::numbers::pi * u));
  for (const Direction& d : directions(10)) {
    std::array<float, 25> sum{};
    add_cap_l4(static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2]), static_cast<float>(u),
               intensity, sum.data());
    const auto y = numeric::basis<double>(4, d[0], d[1], d[2]);
    for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(static_cast<double>(sum[i]), y[i], 1e-6);
  }
}

TEST(GeneratedIrradiance, MultipliesEveryBandByTheClampedCosine) {
  for_degrees_from<0>([]<int kDegree>() {
    const auto before = random_array<coefficient_count(kDegree)>(6);
    auto c = before;
    irradiance<kDegree>(c.data());
    for (std::size_t i = 0; i < c.size(); ++i) {
      const int l = band(i);
      EXPECT_NEAR(c[i], numeric::clamped_cosine_factor<double>(l) * before[i], 1e-15);
      if (l % 2 == 1 && l > 1) {
        EXPECT_EQ(c[i], 0.0);
      }
    }
  });
}

TEST(GeneratedIrradiance, EvaluatesLikeTheConvolutionAndTheQuadraticForm) {
  for_degrees_from<0>([]<int kDegree>() {
    const auto c = random_array<coefficient_count(kDegree)>(7);
    auto e = c;
    irradiance<kDegree>(e.data());
    for (const Direction& n : directions(20)) {
      const auto y = numeric::basis<double>(kDegree, n[0], n[1], n[2]);
      double expected = 0;
      for (std::size_t i = 0; i < e.size(); ++i) expected += e[i] * y[i];
      EXPECT_NEAR(irradiance_evaluate<kDegree>(c.data(), n[0], n[1], n[2]), expected, 1e-14);
    }
  });
  const auto c = random_array<9>(8);
  std::array<double, 16> m;
  irradiance_matrix<2>(c.data(), m.data());
  for (const Direction& n : directions(20)) {
    const std::array<double, 4> v{n[0], n[1], n[2], 1};
    double form = 0;
    for (std::size_t i = 0; i < 16; ++i) {
      form += v[i / 4] * m[i] * v[i % 4];
      EXPECT_EQ(m[i], m[4 * (i % 4) + i / 4]);
    }
    EXPECT_NEAR(form, irradiance_evaluate_l2(c.data(), n[0], n[1], n[2]), 4e-15);
  }
}

TEST(GeneratedLightmap, ProjectsAndEvaluatesIrradianceOfDegreeOne) {
  // Samples, their coefficients, and the irradiance they give towards a normal.
  std::array<double, 4> projected{};
  std::array<double, 4> c{};
  int k = 0;
  for (const Direction& d : directions(30)) {
    const double weight = 0.1 + 0.01 * k++;
    lightmap_project_l1(d[0], d[1], d[2], weight, projected.data());
    const auto y = numeric::basis<double>(1, d[0], d[1], d[2]);
    for (std::size_t i = 0; i < 4; ++i) c[i] += weight * y[i];
  }
  std::array<double, 4> e;
  lightmap_l1(c.data(), e.data());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(e[i], projected[i], 1e-14);
  for (const Direction& n : directions(10)) {
    EXPECT_NEAR(lightmap_evaluate_l1(e.data(), n[0], n[1], n[2]), irradiance_evaluate_l1(c.data(), n[0], n[1], n[2]),
                1e-14);
  }
  lightmap_l1(c.data(), c.data());  // in place
  EXPECT_EQ(c, e);
}

// Band 2 about the axis of band 1 that these coefficients suggest, turned by the kernel of zonal functions.
std::array<double, 9> with_suggested_band(const std::array<double, 4>& c) {
  const double size = std::sqrt(c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
  const std::array<double, 3> zonal{0, 0, size * (0.08 + 0.6 * size / c[0])};
  std::array<double, 9> all;
  sh::zonal<2>(zonal.data(), c[3] / size, c[1] / size, c[2] / size, all.data());
  std::copy(c.begin(), c.end(), all.begin());
  return all;
}

TEST(GeneratedZh3, AddsAZonalBandAboutTheAxisOfBand1) {
  for (const Direction& d : directions(20)) {
    const double size = 0.1 + 0.8 * (1 + d[0]);  // up to sqrt(3), as radiance has it
    const std::array<double, 4> c{1, size * d[1], size * d[2], size * d[0]};
    const std::array<double, 9> all = with_suggested_band(c);
    for (const Direction& n : directions(20)) {
      const double expected = irradiance_evaluate_l2(all.data(), n[0], n[1], n[2]);
      EXPECT_NEAR(irradiance_zh3_l1(c.data(), n[0], n[1], n[2]), expected, 4e-15);
      // Three equal channels share the axis of each.
      std::array<double, 12> gray;
      for (std::size_t i = 0; i < gray.size(); ++i) gray[i] = c[i % 4];
      std::array<double, 3> rgb;
      irradiance_zh3_rgb_l1(gray.data(), n[0], n[1], n[2], rgb.data());
      for (const double channel : rgb) EXPECT_NEAR(channel, expected, 4e-15);
    }
  }
}

TEST(GeneratedZh3, IsCloserToALightThanDegree1) {
  // A light towards d: E(n) = max(0, d n), and its coefficients are the basis at d.
  for (const Direction& d : directions(10)) {
    const auto c = numeric::basis<double>(1, d[0], d[1], d[2]);
    double of_degree_1 = 0;
    double of_zh3 = 0;
    for (const Direction& n : directions(200)) {
      const double exact = std::max(0.0, d[0] * n[0] + d[1] * n[1] + d[2] * n[2]);
      of_degree_1 += std::pow(irradiance_evaluate_l1(c.data(), n[0], n[1], n[2]) - exact, 2);
      of_zh3 += std::pow(irradiance_zh3_l1(c.data(), n[0], n[1], n[2]) - exact, 2);
    }
    EXPECT_LT(of_zh3, 0.1 * of_degree_1);
  }
}

TEST(GeneratedZh3, StaysFiniteWithoutAnAxisAndOutsideOfRadiance) {
  const std::array<float, 4> black{};
  EXPECT_EQ(irradiance_zh3_l1(black.data(), 0.0F, 0.0F, 1.0F), 0.0F);
  const std::array<float, 4> constant{2, 0, 0, 0};
  EXPECT_FLOAT_EQ(irradiance_zh3_l1(constant.data(), 0.6F, 0.0F, 0.8F),
                  static_cast<float>(std::sqrt(std::numbers::pi)));
  std::array<float, 12> channels{};
  std::array<float, 3> rgb;
  irradiance_zh3_rgb_l1(channels.data(), 0.0F, 0.0F, 1.0F, rgb.data());
  EXPECT_EQ(rgb, (std::array<float, 3>{0, 0, 0}));
  // At and beyond sqrt(3), the largest quotient of radiance, and without a mean or with a negative one.
  for (const float mean : {1.0F, 0.57735F, 1e-6F, 1e-37F, 0.0F, -1.0F}) {
    for (const float size : {1.0F, 1e-15F, 1e15F}) {
      const std::array<float, 4> c{mean * size, 0, size, 0};
      for (const float z : {1.0F, 0.0F, -1.0F}) {
        const float x = z == 0 ? 1.0F : 0.0F;
        // The band is at most (0.08 + 0.6 sqrt(3)) size.
        const float linear = irradiance_evaluate_l1(c.data(), x, 0.0F, z);
        EXPECT_LE(std::abs(irradiance_zh3_l1(c.data(), x, 0.0F, z) - linear), 0.56F * size) << mean << " " << size;
        for (std::size_t i = 0; i < 12; ++i) channels[i] = c[i % 4];
        irradiance_zh3_rgb_l1(channels.data(), x, 0.0F, z, rgb.data());
        for (const float channel : rgb) EXPECT_LE(std::abs(channel - linear), 0.56F * size) << mean << " " << size;
      }
    }
  }
  // The channels' axes cancel: no luminance has an axis, and degree 1 remains.
  channels = {1, 0, 0, 0.7152F, 1, 0, 0, -0.2126F, 1, 0, 0, 0};
  irradiance_zh3_rgb_l1(channels.data(), 1.0F, 0.0F, 0.0F, rgb.data());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(rgb[k], irradiance_evaluate_l1(&channels[4 * k], 1.0F, 0.0F, 0.0F), 0.56F * 0.7152F);
  }
}

// Applies `window` to ones and compares with expected(l).
template <int Degree, class Window, class Expected>
void expect_window(const Window& window, const Expected& expected, double tolerance) {
  std::array<double, coefficient_count(Degree) + 2> c;
  c.fill(1);
  c.front() = c.back() = std::numeric_limits<double>::quiet_NaN();
  window(c.data() + 1);
  for (std::size_t i = 0; i < coefficient_count(Degree); ++i)
    EXPECT_NEAR(c[i + 1], i == 0 ? 1.0 : expected(static_cast<double>(band(i))), tolerance) << i;
  EXPECT_TRUE(std::isnan(c.front()));
  EXPECT_TRUE(std::isnan(c.back()));
}

TEST(GeneratedWindows, FollowTheirFormulas) {
  for_degrees_from<1>([]<int kDegree>() {
    for (const double w : {double(kDegree), kDegree + 0.5, 3.0 * kDegree, 1000.0}) {
      const double angle = std::numbers::pi / w;
      const double cosine = std::cos(angle);
      const double sinc = std::sin(angle) / angle;
      const auto sinc_at = [&](double l) { return std::sin(angle * l) / (angle * l); };
      expect_window<kDegree>([&](double* c) { window_hann<kDegree>(cosine, c); },
                             [&](double l) { return (1 + std::cos(angle * l)) / 2; }, 5e-15);
      expect_window<kDegree>([&](double* c) { window_lanczos<kDegree>(cosine, sinc, c); }, sinc_at, 5e-15);
      expect_window<kDegree>([&](double* c) { window_lanczos2<kDegree>(cosine, sinc, c); },
                             [&](double l) { return std::pow(sinc_at(l), 2); }, 5e-15);
      expect_window<kDegree>([&](double* c) { window_lanczos4<kDegree>(cosine, sinc, c); },
                             [&](double l) { return std::pow(sinc_at(l), 4); }, 8e-15);
      expect_window<kDegree>([&](double* c) { window_gaussian<kDegree>(std::exp(-1 / (2 * w * w)), c); },
                             [&](double l) { return std::exp(-l * l / (2 * w * w)); }, 1e-14);
      expect_window<kDegree>([&](double* c) { window_laplacian<kDegree>(w, c); },
                             [&](double l) { return 1 / (1 + w * l * l * (l + 1) * (l + 1)); }, 1e-15);
    }
  });
}

TEST(GeneratedWindows, CutOffWhereTheyShould) {
  std::array<double, 25> c;
  c.fill(1);
  window_hann_l4(std::cos(std::numbers::pi / 4), c.data());
  EXPECT_NEAR(c[20], 0, 1e-15);
  EXPECT_NEAR(c[6], 0.5, 1e-15);
  c.fill(1);
  window_laplacian_l4(std::numeric_limits<double>::infinity(), c.data());
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_EQ(c[i], i == 0 ? 1.0 : 0.0);
}

TEST(GeneratedZonalFamilies, AreConstantExpressions) {
  constexpr auto kLight = [] {
    std::array<double, 9> sum{};
    add_cap_l2(0.0, 0.0, 1.0, 2.0, 1.0, sum.data());
    irradiance_l2(sum.data());
    window_hann_l2(1.0, sum.data());
    return sum;
  }();
  // The whole sphere of unit radiance: irradiance pi in every direction.
  static_assert(kLight[0] > 11.1366 && kLight[0] < 11.1367);  // pi 2 sqrt(pi)
  static_assert(kLight[6] == 0);
  constexpr std::array<double, 9> kSky{1};
  static_assert(irradiance_evaluate_l2(kSky.data(), 0.0, 0.6, 0.8) > 0.886);
  EXPECT_NEAR(irradiance_evaluate_l2(kLight.data(), 0.0, 0.6, 0.8), std::pow(std::numbers::pi, 2), 1e-13);
}

}  // namespace
}  // namespace sh
