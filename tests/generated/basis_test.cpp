// The committed basis kernels: values, instantiations, operation counts, constant evaluation.
#include "generated/cpp/basis.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <experimental/simd>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/generated/counting.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh {
namespace {

using numeric::coefficient_index;
using test::coefficient_count;
using test::Direction;
using test::expect_fills;
using test::for_every_degree;
using test::kMaxDegree;

// No direction close to a pole, where the angles of the textbook form below lose digits.
std::vector<Direction> directions() {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Direction> result{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, 0.8}};
  for (int i = 0; i < 500; ++i) {
    const double x = normal(random);
    const double y = normal(random);
    const double z = normal(random);
    const double r = std::sqrt(x * x + y * y + z * z);
    result.push_back({x / r, y / r, z / r});
  }
  return result;
}

// Y_lm from the standard library's Legendre functions and angles: nothing in common with the kernels. std::sph_legendre
// carries the Condon-Shortley phase (-1)^m, which is undone here.
double textbook(int l, int m, const Direction& d) {
  const int a = std::abs(m);
  const double theta = std::atan2(std::hypot(d[0], d[1]), d[2]);
  const double phi = std::atan2(d[1], d[0]);
  const double axial =
      std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(a), theta) * (a % 2 == 0 ? 1 : -1);
  if (m == 0) return axial;
  return std::numbers::sqrt2 * axial * (m > 0 ? std::cos(a * phi) : std::sin(a * phi));
}

template <int Degree, class T>
std::array<T, coefficient_count(Degree)> evaluate(const Direction& d) {
  std::array<T, coefficient_count(Degree)> out;
  basis<Degree>(static_cast<T>(d[0]), static_cast<T>(d[1]), static_cast<T>(d[2]), out.data());
  return out;
}

TEST(GeneratedBasis, AgreesWithLegendreFunctionsOfTheStandardLibrary) {
  for_every_degree([]<int kDegree>() {
    for (const Direction& d : directions()) {
      const auto out = evaluate<kDegree, double>(d);
      for (int l = 0; l <= kDegree; ++l) {
        for (int m = -l; m <= l; ++m) {
          ASSERT_NEAR(out[coefficient_index(l, m)], textbook(l, m, d), 2e-14) << kDegree << " " << l << " " << m;
        }
      }
    }
  });
}

TEST(GeneratedBasis, SatisfiesTheAdditionTheoremInEveryBand) {
  for_every_degree([]<int kDegree>() {
    for (const Direction& d : directions()) {
      const auto out = evaluate<kDegree, double>(d);
      for (int l = 0; l <= kDegree; ++l) {
        double sum = 0;
        for (int m = -l; m <= l; ++m) sum += std::pow(out[coefficient_index(l, m)], 2);
        ASSERT_NEAR(sum, (2 * l + 1) / (4 * std::numbers::pi), 3e-14);
      }
    }
  });
}

TEST(GeneratedBasis, LowerBandsAreTheSameFunctionsAtEveryDegree) {
  for_every_degree([]<int kDegree>() {
    for (const Direction& d : directions()) {
      const auto out = evaluate<kDegree, float>(d);
      const auto all = evaluate<kMaxDegree, float>(d);
      for (std::size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out[i], all[i], 3e-6F);
    }
  });
}

TEST(GeneratedBasis, FloatFollowsDouble) {
  for_every_degree([]<int kDegree>() {
    for (const Direction& d : directions()) {
      const Direction rounded{double(float(d[0])), double(float(d[1])), double(float(d[2]))};
      const auto in_float = evaluate<kDegree, float>(rounded);
      const auto in_double = evaluate<kDegree, double>(rounded);
      // The largest rounding error seen in MANIFEST is 3.3e-6, at degree 10, with the worst input of a search.
      for (std::size_t i = 0; i < in_float.size(); ++i) ASSERT_NEAR(double(in_float[i]), in_double[i], 3e-6);
    }
  });
}

template <class Lanes>
void expect_lanes_equal_scalars() {
  using S = typename Lanes::value_type;
  const auto points = directions();
  for_every_degree([&]<int kDegree>() {
    std::array<Lanes, coefficient_count(kDegree)> out;
    const auto lanes = [&](std::size_t axis) {
      return Lanes([&](auto i) { return static_cast<S>(points[i + 5][axis]); });
    };
    basis<kDegree>(lanes(0), lanes(1), lanes(2), out.data());
    for (std::size_t lane = 0; lane < Lanes::size(); ++lane) {
      const auto scalar = evaluate<kDegree, S>(points[lane + 5]);
      for (std::size_t i = 0; i < scalar.size(); ++i) ASSERT_EQ(static_cast<S>(out[i][lane]), scalar[i]);
    }
  });
}

TEST(GeneratedBasis, SimdLanesEqualScalarsBitForBit) {
  namespace stdx = std::experimental;
  expect_lanes_equal_scalars<stdx::native_simd<float>>();
  expect_lanes_equal_scalars<stdx::native_simd<double>>();
  expect_lanes_equal_scalars<stdx::fixed_size_simd<float, 16>>();
}

// MANIFEST line of every kernel that is written: field name -> value.
std::map<std::string, std::map<std::string, std::string>> manifest() {
  std::ifstream stream(std::string(SHFORGE_SOURCE_DIR) + "/generated/MANIFEST");
  std::map<std::string, std::map<std::string, std::string>> kernels;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string name;
    words >> name;
    // Other recipes are listed too, without this file.
    if (line.find("cpp/" + name + ".hpp") == std::string::npos) continue;
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (equals != std::string::npos) kernels[name][word.substr(0, equals)] = word.substr(equals + 1);
    }
  }
  return kernels;
}

TEST(GeneratedBasis, DoesTheOperationsThatTheManifestClaims) {
  auto claims = manifest();
  for_every_degree([&]<int kDegree>() {
    std::array<test::Counting, coefficient_count(kDegree)> out;
    test::Counting::count() = {};
    basis<kDegree>(test::Counting(0.6), test::Counting(0), test::Counting(0.8), out.data());
    auto& claim = claims.at("basis_l" + std::to_string(kDegree));
    EXPECT_EQ(std::to_string(test::Counting::count().mul), claim.at("mul")) << kDegree;
    EXPECT_EQ(std::to_string(test::Counting::count().add), claim.at("add")) << kDegree;
    EXPECT_EQ(test::Counting::count().neg, 0) << kDegree;
  });
}

TEST(GeneratedBasis, IsAConstantExpression) {
  constexpr auto kPole = [] {
    std::array<double, 25> out{};
    basis<4>(0.0, 0.0, 1.0, out.data());
    return out;
  }();
  static_assert(kPole[1] == 0);
  static_assert(kPole[0] == 0.28209479177387814);
  EXPECT_DOUBLE_EQ(kPole[2], std::sqrt(3 / (4 * std::numbers::pi)));
}

TEST(GeneratedBasis, WritesExactlyItsOwnElements) {
  for_every_degree([]<int kDegree>() {
    expect_fills(coefficient_count(kDegree), [](double* out) { basis<kDegree>(0.48, 0.6, 0.64, out); });
  });
}

}  // namespace
}  // namespace sh
