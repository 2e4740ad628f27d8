// Transforms over rings: against the oracle's values, as each other's transpose, round and round with a quadrature that
// is exact, on every instruction set that is here.
#include "numeric/oracle/legendre_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "tests/message_of.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

struct Circle {
  std::vector<double> z, sine;
  void add(double theta) { add(std::cos(theta), std::sin(theta)); }
  void add(double zed, double s) {
    z.push_back(zed);
    sine.push_back(s);
  }
};

// In no order: poles, next to them, the equator, a ring twice, pairs and single ones.
Circle some_rings() {
  Circle rings;
  for (const double theta : {0.3, 1e-3, 2.9, 1.1, 1.57, 3.0, 0.3}) rings.add(theta);
  rings.add(1, 0);
  rings.add(-1, 0);
  rings.add(1, 1e-300);
  rings.add(0, 1);
  for (int i = 0; i < 40; ++i) {
    rings.add(0.02 + 0.037 * i);
    rings.add(-rings.z.back(), rings.sine.back());
  }
  return rings;
}

std::vector<double> random_values(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> values(count);
  for (double& v : values) v = uniform(random);
  return values;
}

std::vector<RingLanes> all_lanes() {
  std::vector<RingLanes> all;
  for (const RingLanes lanes : {RingLanes::kBaseline, RingLanes::kAvx2, RingLanes::kAvx512}) {
    if (available(lanes)) all.push_back(lanes);
  }
  return all;
}

// Largest error of a synthesis in units of the root of the sum of squares of its terms' sizes.
double synthesis_error(const LegendreRings& rings, const Circle& circle, int degree, int order) {
  const int terms = degree - order + 1;
  const auto a = random_values(2 * terms, static_cast<unsigned>(order));
  std::vector<double> got(2 * circle.z.size());
  rings.synthesis(degree, order, a, got);
  double worst = 0;
  for (std::size_t i = 0; i < circle.z.size(); ++i) {
    std::vector<long double> p(terms);
    legendre_column<long double>(degree, order, circle.z[i], circle.sine[i], p.data());
    for (std::size_t c = 0; c < 2; ++c) {
      long double sum = 0;
      double size = 0;
      for (int k = 0; k < terms; ++k) {
        sum += p[k] * a[2 * k + c];
        size += a[2 * k + c] * a[2 * k + c] * (2 * (order + k) + 1) / (4 * std::acos(-1.0));
      }
      keep_worst(worst, static_cast<double>(sum - got[2 * i + c]) / std::sqrt(size));
    }
  }
  return worst;
}

// Measured: 7.4e-15, most of it from rings whose rounded z and sine are not quite on the circle.
TEST(LegendreRings, SynthesisIsTheSumOfTheOraclesValues) {
  const Circle circle = some_rings();
  for (const RingLanes lanes : all_lanes()) {
    const LegendreRings rings(60, circle.z, circle.sine, lanes);
    for (const int degree : {0, 1, 2, 3, 17, 60}) {
      for (int order = 0; order <= degree; order += order < 4 ? 1 : 7) {
        EXPECT_LT(synthesis_error(rings, circle, degree, order), 2e-14) << degree << ' ' << order;
      }
    }
  }
}

TEST(LegendreRings, AnalysisIsTheTransposeOfSynthesis) {
  const Circle circle = some_rings();
  for (const RingLanes lanes : all_lanes()) {
    const LegendreRings rings(200, circle.z, circle.sine, lanes);
    for (const int order : {0, 1, 5, 63, 64, 130, 199, 200}) {
      const auto a = random_values(2 * (200 - order + 1), 1);
      const auto f = random_values(2 * circle.z.size(), 2);
      std::vector<double> values(f.size());
      std::vector<double> b(a.size());
      rings.synthesis(200, order, a, values);
      rings.analysis(200, order, f, b);
      for (std::size_t c = 0; c < 2; ++c) {
        double left = 0;
        double right = 0;
        double size = 0;
        for (std::size_t i = c; i < f.size(); i += 2) left += f[i] * values[i];
        for (std::size_t i = c; i < f.size(); i += 2) size += std::abs(f[i] * values[i]);
        for (std::size_t i = c; i < a.size(); i += 2) right += a[i] * b[i];
        EXPECT_NEAR(left, right, 1e-14 * size + 1e-300) << order;
      }
    }
  }
}

// 2 pi times the sum over Gauss-Legendre rings of weight * P_lm P_km is 1 for l = k, else 0. Measured: 1.3e-13, most of
// which rounding of the nodes causes at degree 300.
TEST(LegendreRings, AnalysisUndoesSynthesisOnGaussLegendreRingsAtDegree300) {
  constexpr int kDegree = 300;
  const auto rule = gauss_legendre<double>(kDegree + 1);
  Circle circle;
  for (const double z : rule.nodes) circle.add(z, std::sqrt((1 - z) * (1 + z)));
  const LegendreRings rings(kDegree, circle.z, circle.sine);
  for (const int order : {0, 1, 2, 10, 100, 250, 300}) {
    const auto a = random_values(2 * (kDegree - order + 1), 3);
    std::vector<double> values(2 * circle.z.size());
    std::vector<double> back(a.size());
    rings.synthesis(kDegree, order, a, values);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= 2 * std::acos(-1.0) * rule.weights[i / 2];
    rings.analysis(kDegree, order, values, back);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(back[i], a[i], 4e-13) << order << ' ' << i;
  }
}

// All pairs anchored at the pole or all at the equator, alone and both with nothing between: blocks of every size.
TEST(LegendreRings, OfEveryNumberOfRegistersIsTheSumOfTheOraclesValues) {
  for (const int near_pole : {0, 1, 8, 9, 17, 33}) {
    for (const int near_equator : {0, 1, 8, 9, 17, 33}) {
      for (const int between : {0, 1, 9, 25, 41}) {
        Circle circle;
        for (int i = 0; i < near_pole; ++i) circle.add(0.004 + 0.0041 * i);
        for (int i = 0; i < between; ++i) circle.add(0.2 + 0.03 * i);
        for (int i = 0; i < near_equator; ++i) circle.add(std::acos(-1.0) / 2 - 0.0005 * i);
        if (circle.z.empty()) continue;
        for (const RingLanes lanes : all_lanes()) {
          const LegendreRings rings(21, circle.z, circle.sine, lanes);
          EXPECT_LT(synthesis_error(rings, circle, 21, 2), 2e-14) << near_pole << ' ' << near_equator << ' ' << between;
        }
      }
    }
  }
}

// To degree 200 the tables are made once, of the largest degree, and serve all.
TEST(LegendreRings, GivesTheSameBitsWithAndWithoutKeptTables) {
  const Circle circle = some_rings();
  const LegendreRings kept(200, circle.z, circle.sine);
  const LegendreRings made(201, circle.z, circle.sine);
  for (const int degree : {0, 7, 199, 200}) {
    for (const int order : {0, degree / 2, degree}) {
      const auto a = random_values(2 * (degree - order + 1), 4);
      std::vector<double> values(2 * circle.z.size()), others(values.size());
      kept.synthesis(degree, order, a, values);
      made.synthesis(degree, order, a, others);
      EXPECT_EQ(values, others) << degree << ' ' << order;
    }
  }
}

// In more registers of pairs than a panel has, dead, mixed and plain ones, against synthesis as the transpose.
TEST(LegendreRings, AnalysisOfManyRingsIsTheTransposeOfSynthesis) {
  Circle circle;
  for (int i = 0; i < 700; ++i) circle.add(1e-4 + 0.00224 * i);
  for (const RingTail tail : {RingTail::kNegligible, RingTail::kAll}) {
    for (const RingLanes lanes : all_lanes()) {
      const LegendreRings rings(1200, circle.z, circle.sine, lanes, tail);
      for (const int order : {0, 300, 900, 1200}) {
        const auto a = random_values(2 * (1200 - order + 1), 1);
        const auto f = random_values(2 * circle.z.size(), 2);
        std::vector<double> values(f.size());
        std::vector<double> b(a.size());
        rings.synthesis(1200, order, a, values);
        rings.analysis(1200, order, f, b);
        for (std::size_t c = 0; c < 2; ++c) {
          double left = 0;
          double right = 0;
          double size = 0;
          for (std::size_t i = c; i < f.size(); i += 2) left += f[i] * values[i];
          for (std::size_t i = c; i < f.size(); i += 2) size += std::abs(f[i] * values[i]);
          for (std::size_t i = c; i < a.size(); i += 2) right += a[i] * b[i];
          EXPECT_NEAR(left, right, 1e-13 * size + 1e-300) << order;
        }
      }
    }
  }
}

TEST(LegendreRings, LeaveOutNothingButWhatIsNegligible) {
  Circle circle;
  for (int i = 1; i <= 64; ++i) circle.add(0.01 * i);
  int left_out = 0;
  for (const RingLanes lanes : all_lanes()) {
    const LegendreRings rings(3000, circle.z, circle.sine, lanes, RingTail::kNegligible);
    for (const int order : {100, 400, 2000, 2900}) {
      for (const int above : {3, 40, 100}) {
        for (const int degree : {order + above, 3000}) {  // the highest of all, where rings without work are chosen
          std::vector<double> a(2 * (degree - order + 1), 0.0);
          std::vector<double> values(2 * circle.z.size());
          a[2 * above] = 1;
          rings.synthesis(degree, order, a, values);
          for (std::size_t i = 0; i < circle.z.size(); ++i) {
            const double wanted = legendre_value(order + above, order, circle.z[i], circle.sine[i]);
            if (values[2 * i] == 0 && wanted != 0) {
              ++left_out;
              EXPECT_LT(std::abs(wanted), 1e-71) << degree << ' ' << order << ' ' << i;
            } else {
              EXPECT_NEAR(values[2 * i], wanted, 1e-12 * std::abs(wanted) + 1e-300)
                  << degree << ' ' << order << ' ' << i;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(left_out, 0);
}

TEST(LegendreRings, TheTailKeepsItsDigitsDownToTheSmallestNormalNumber) {
  Circle circle;
  for (int i = 1; i <= 64; ++i) circle.add(0.01 * i);
  for (const RingLanes lanes : all_lanes()) {
    const LegendreRings rings(500, circle.z, circle.sine, lanes, RingTail::kAll);
    for (const int order : {100, 200, 400}) {
      std::vector<double> a(2 * (500 - order + 1), 0.0);
      std::vector<double> values(2 * circle.z.size());
      a[6] = 1;  // degree order + 3
      rings.synthesis(500, order, a, values);
      for (std::size_t i = 0; i < circle.z.size(); ++i) {
        const double wanted = legendre_value(order + 3, order, circle.z[i], circle.sine[i]);
        EXPECT_NEAR(values[2 * i], wanted, 2e-13 * std::abs(wanted) + 1e-300) << order << ' ' << i;
        EXPECT_EQ(values[2 * i] == 0, std::abs(wanted) < 1e-323) << order << ' ' << i << ' ' << wanted;
      }
    }
  }
}

TEST(LegendreRings, RefusesWhatItCannotTransform) {
  const std::vector<double> z{0.6, 0.8}, sine{0.8, 0.6}, off{0.8, 0.61}, negative{0.8, -0.6}, one{0.8};
  EXPECT_EQ(message_of([&] { LegendreRings(-1, z, sine); }), "LegendreRings: max_degree: expected 0 to 100000, got -1");
  EXPECT_EQ(message_of([&] { LegendreRings(2, z, one); }), "LegendreRings: sine: expected 2 values, got 1");
  EXPECT_EQ(message_of([&] { LegendreRings(2, z, off); }),
            "LegendreRings: ring 1: expected a point of the circle with sine >= 0, got z = 0.800000, sine = 0.610000");
  EXPECT_NE(message_of([&] { LegendreRings(2, z, negative); }), "nothing thrown");
  const LegendreRings rings(2, z, sine);
  std::vector<double> a(6), values(4);
  EXPECT_EQ(message_of([&] { rings.synthesis(2, 0, a, values); }), "nothing thrown");
  EXPECT_EQ(message_of([&] { rings.synthesis(3, 0, a, values); }),
            "LegendreRings: synthesis: degree: expected 0 to 2, got 3");
  EXPECT_EQ(message_of([&] { rings.synthesis(2, 3, a, values); }),
            "LegendreRings: synthesis: order: expected 0 to 2, got 3");
  EXPECT_EQ(message_of([&] { rings.analysis(2, 1, values, a); }),
            "LegendreRings: analysis: coefficients: expected 4 values, got 6");
  EXPECT_EQ(message_of([&] { rings.analysis(2, 0, a, a); }),
            "LegendreRings: analysis: values: expected 4 values, got 6");
}

TEST(LegendreRings, NoRingsAreNoWork) {
  const LegendreRings rings(2, {}, {});
  std::vector<double> a(6, 1.0), values;
  rings.analysis(2, 0, values, a);
  for (const double v : a) EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace sh::numeric
