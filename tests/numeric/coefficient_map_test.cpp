// Maps of coefficients between conventions: the same function before and after, bits where a sign is all, refusals.
// The exact entries: tests/symbolic/coefficient_map_test.cpp.
#include "numeric/identify/coefficient_map.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "numeric/oracle/zonal.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric::identify {
namespace {

using test::message_of;

std::vector<double> random_coefficients(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> c(count);
  for (double& x : c) x = random.next();
  return c;
}

// sum c_lm Y_lm(d), with the factors of A_l / pi where the other side holds them.
double our_value(const std::vector<double>& c, int degree, const Direction& d, Folded hold) {
  std::vector<double> y(coefficient_count(degree));
  basis(degree, d.x, d.y, d.z, y.data());
  double sum = 0;
  for (int l = 0; l <= degree; ++l) {
    const double factor = hold == Folded::kNothing ? 1 : clamped_cosine_factor<double>(l) / std::acos(-1.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += factor * c[i] * y[i];
  }
  return sum;
}

// Of the other convention, by the definition of its functions; complex elements are pairs.
double their_value(const std::vector<double>& c, const Convention& convention, int degree, const Direction& d) {
  const auto y = convention_values(convention, degree, {d.x, d.y, d.z});
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    sum += convention.complex ? c[2 * i] * y[i].real() - c[2 * i + 1] * y[i].imag() : c[i] * y[i].real();
  }
  return sum;
}

TEST(CoefficientMaps, DescribeTheSameFunctionInEveryPresetAndDegree) {
  const auto directions = random_directions(40, 5);
  for (const Preset& preset : presets()) {
    const int largest = largest_mapped_degree(preset.convention, preset.coefficients_hold);
    for (int degree = 0; degree <= largest; ++degree) {
      const CoefficientMap map(preset, degree);
      const auto c = random_coefficients(map.our_size(), 7 + degree);
      const auto theirs = map.to(c);
      for (const auto& d : directions) {
        EXPECT_NEAR(their_value(theirs, in_world(preset), degree, d), our_value(c, degree, d, preset.coefficients_hold),
                    2e-15 * (degree + 1) * (degree + 1))
            << preset.name << " " << degree;
      }
      const auto back = map.from(theirs);
      for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(back[i], c[i], 2e-15) << preset.name << " " << degree;
    }
  }
}

// Folded into the functions, the factor leaves the coefficients; held by the coefficients, it comes into them.
TEST(CoefficientMaps, FoldAndHoldTheCosineInOppositeWays) {
  const std::vector<double> c = random_coefficients(9, 3);
  const auto folded = CoefficientMap(Convention{.folded = Folded::kCosine}, 2).to(c);
  const auto held = CoefficientMap(Convention{}, 2, Folded::kCosine).to(c);
  for (int l = 0; l <= 2; ++l) {
    const auto factor = clamped_cosine_factor<double>(l);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      EXPECT_NEAR(folded[i], c[i] / factor, 1e-15);
      EXPECT_NEAR(held[i], c[i] * factor, 1e-15);
    }
  }
}

TEST(CoefficientMaps, OfSignsAndOrdersChangeNoBit) {
  constexpr auto kInfinity = std::numeric_limits<float>::infinity();
  constexpr auto kDenormal = std::numeric_limits<float>::denorm_min();
  for (const char* name : {"shforge", "directxmath", "gaussian-splatting"}) {
    const CoefficientMap map(find_preset(name), 3);
    EXPECT_TRUE(map.is_diagonal());
    std::vector<float> c = {0.0F, -0.0F, 0.1F, -kDenormal, kInfinity, -kInfinity, 3e38F, 1e-38F,
                            1.0F, -0.3F, 0.7F, kDenormal,  -1e-20F,   0.25F,      -9.0F, 11.0F};
    std::vector<float> theirs(16), back(16);
    map.to(c.data(), theirs.data());
    map.from(theirs.data(), back.data());
    for (int i = 0; i < 16; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(back[i]), std::bit_cast<std::uint32_t>(c[i])) << name << " " << i;
      EXPECT_EQ(std::abs(theirs[i]), std::abs(c[i])) << name << " " << i;
    }
  }
  EXPECT_EQ(CoefficientMap(find_preset("directxmath"), 1).to(std::vector<double>{1, 2, 3, 4}),
            (std::vector<double>{1, -2, 3, -4}));
}

// Quarter turns about z and reflections permute coefficients; other axes mix them from band 2 on.
TEST(CoefficientMaps, OfAxesAreNoPermutationFromBandTwoOn) {
  for (const Axes& axes : all_axes()) {
    EXPECT_TRUE(CoefficientMap(Convention{.axes = axes}, 1).is_diagonal()) << axes.to_string();
    EXPECT_EQ(CoefficientMap(Convention{.axes = axes}, 20).is_diagonal(), axes.axis[2] == 2) << axes.to_string();
  }
}

// In both directions at every degree: largest error of a round trip, and lengths, which axes keep.
TEST(CoefficientMaps, OfAxesGoBackAtTheLargestDegree) {
  const auto c = random_coefficients(coefficient_count(kMaxDegree), 11);
  double length = 0;
  for (const double x : c) length += x * x;
  for (const Axes& axes : all_axes()) {
    const CoefficientMap map(Convention{.axes = axes}, kMaxDegree);
    const auto theirs = map.to(c);
    const auto back = map.from(theirs);
    double theirs_length = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
      EXPECT_NEAR(back[i], c[i], 2e-15);
      theirs_length += theirs[i] * theirs[i];
    }
    EXPECT_NEAR(theirs_length, length, 1e-12 * length);
  }
}

TEST(CoefficientMaps, TakeChannelsOneAfterTheOther) {
  const CoefficientMap map(find_preset("unity"), 2);
  const auto c = random_coefficients(27, 13);
  const auto all = map.to(c);
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<double> one(c.begin() + 9 * channel, c.begin() + 9 * channel + 9);
    const auto mapped = map.to(one);
    EXPECT_TRUE(std::equal(mapped.begin(), mapped.end(), all.begin() + 9 * channel));
  }
  EXPECT_TRUE(map.to(std::vector<double>{}).empty());
}

TEST(CoefficientMaps, HaveHolesThatHoldZero) {
  const CoefficientMap map(find_preset("shtools"), 2);
  const auto theirs = map.to(random_coefficients(9, 17));
  ASSERT_EQ(theirs.size(), 18U);
  const auto functions = functions_in_order(IndexOrder::kCosineSineArray, 2);
  for (std::size_t i = 0; i < theirs.size(); ++i) EXPECT_EQ(theirs[i] == 0, functions[i].is_hole()) << i;
}

TEST(CoefficientMaps, RefuseWhatTheyCannotMap) {
  EXPECT_EQ(message_of([] { CoefficientMap(find_preset("unity"), 3); }), "degree: expected 0 to 2, got 3");
  EXPECT_EQ(message_of([] { CoefficientMap(find_preset("fuma"), 4); }), "degree: expected 0 to 3, got 4");
  EXPECT_EQ(message_of([] { CoefficientMap(find_preset("scipy"), 21); }), "degree: expected 0 to 20, got 21");
  EXPECT_EQ(message_of([] { CoefficientMap(find_preset("scipy"), -1); }), "degree: expected 0 to 20, got -1");
  EXPECT_EQ(message_of([] { static_cast<void>(CoefficientMap(Convention{}, 1).to(std::vector<double>(6))); }),
            "coefficients: expected 4 a channel, got 6");
  EXPECT_EQ(message_of([] { find_preset("Unity"); }).substr(0, 57),
            "convention: expected one of shforge, directxmath, threejs");
}

}  // namespace
}  // namespace sh::numeric::identify
