// Maps of high degree: against sums of the oracle's basis, as each other's transpose, round and round, any number of
// longitudes and any threads.
#include "numeric/oracle/sphere_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric {
namespace {

using test::message_of;
constexpr double kPi = std::numbers::pi;

struct Circle {
  std::vector<double> z, sine, weight;
};

Circle gauss_circle(int degree, int around) {
  const auto rule = gauss_legendre<double>(degree + 1);
  Circle circle{rule.nodes, {}, {}};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    circle.sine.push_back(std::sqrt((1 - rule.nodes[i]) * (1 + rule.nodes[i])));
    circle.weight.push_back(rule.weights[i] * 2 * kPi / around);
  }
  return circle;
}

// Poles, a ring twice, the equator, in no order.
Circle any_circle() {
  Circle circle;
  for (const double theta : {0.0, 0.3, 1.2, 0.3, kPi / 2, 2.8, kPi, 1e-3, 1.9}) {
    circle.z.push_back(std::cos(theta));
    circle.sine.push_back(std::max(std::sin(theta), 0.0));
    circle.weight.push_back(0.1 + theta);
  }
  return circle;
}

std::vector<double> some_values(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(1.7 * static_cast<double>(i * i % 1009));
  return values;
}

std::vector<double> direct(const Circle& circle, int degree, int around, double phi_0, const std::vector<double>& a) {
  std::vector<double> map, basis_of(a.size());
  for (std::size_t i = 0; i < circle.z.size(); ++i) {
    for (int j = 0; j < around; ++j) {
      const double phi = phi_0 + 2 * kPi * j / around;
      basis(degree, circle.sine[i] * std::cos(phi), circle.sine[i] * std::sin(phi), circle.z[i], basis_of.data());
      double sum = 0;
      for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * basis_of[k];
      map.push_back(sum);
    }
  }
  return map;
}

// Too few longitudes alias, as sums over the map do; 1, 2 and odd numbers of them; 4 rings are one task, 9 are not.
TEST(SphereTransform, SynthesisIsTheSumOfTheOraclesBasis) {
  const Circle circle = any_circle();
  for (const int degree : {0, 1, 2, 5, 12}) {
    for (const int around : {1, 2, 3, 4, 7, 10, 24, 25, 26, 64}) {
      for (const double phi_0 : {0.0, kPi / around, -2.5}) {
        const auto a = some_values(coefficient_count(degree));
        std::vector<double> map(circle.z.size() * around);
        SphereTransform(degree, circle.z, circle.sine, around, phi_0).synthesis(a, map);
        const auto wanted = direct(circle, degree, around, phi_0, a);
        for (std::size_t i = 0; i < map.size(); ++i) {
          ASSERT_NEAR(map[i], wanted[i], 4e-14) << degree << ' ' << around << ' ' << phi_0 << ' ' << i;
        }
      }
    }
  }
}

TEST(SphereTransform, AnalysisIsTheTransposeOfSynthesis) {
  const Circle circle = any_circle();
  for (const int degree : {0, 1, 9}) {
    for (const int around : {1, 2, 5, 6, 18, 40}) {
      const SphereTransform transform(degree, circle.z, circle.sine, around, 0.4);
      const auto a = some_values(coefficient_count(degree));
      const auto map = some_values(circle.z.size() * around);
      std::vector<double> values(map.size()), b(a.size());
      transform.synthesis(a, values);
      transform.analysis(map, circle.weight, b);
      double left = 0, right = 0;
      for (std::size_t i = 0; i < map.size(); ++i) left += circle.weight[i / around] * map[i] * values[i];
      for (std::size_t i = 0; i < a.size(); ++i) right += a[i] * b[i];
      EXPECT_NEAR(left, right, 1e-12) << degree << ' ' << around;
    }
  }
}

TEST(SphereTransform, AnalysisUndoesSynthesisOnGaussLegendreRings) {
  for (const int degree : {0, 1, 31, 200, 257}) {
    const int around = smooth_around(2 * degree + 1);
    const Circle circle = gauss_circle(degree, around);
    const SphereTransform transform(degree, circle.z, circle.sine, around, kPi / around);
    const auto a = some_values(coefficient_count(degree));
    std::vector<double> map(circle.z.size() * around), back(a.size());
    transform.synthesis(a, map);
    transform.analysis(map, circle.weight, back);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(back[i], a[i], 4e-13) << degree << ' ' << i;
  }
}

TEST(SphereTransform, GivesTheSameBitsForAnyThreads) {
  const ForEach backwards_on_threads = [](int count, const std::function<void(int)>& task) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 3; ++t) {
      threads.emplace_back([&task, count, t] {
        for (int i = count - 1 - t; i >= 0; i -= 3) task(i);
      });
    }
    for (std::thread& thread : threads) thread.join();
  };
  const Circle circle = gauss_circle(40, 96);
  const SphereTransform transform(40, circle.z, circle.sine, 96);
  const auto a = some_values(coefficient_count(40));
  std::vector<double> map(circle.z.size() * 96), same(map.size()), back(a.size()), again(a.size());
  transform.synthesis(a, map);
  transform.synthesis(a, same, backwards_on_threads);
  EXPECT_EQ(map, same);
  transform.analysis(map, circle.weight, back);
  transform.analysis(map, circle.weight, again, backwards_on_threads);
  EXPECT_EQ(back, again);
}

TEST(SphereTransform, SmoothNumbersOfLongitudes) {
  EXPECT_EQ(smooth_around(-3), 4);
  EXPECT_EQ(smooth_around(4), 4);
  EXPECT_EQ(smooth_around(5), 8);
  EXPECT_EQ(smooth_around(201), 216);
  EXPECT_EQ(smooth_around(2001), 2048);
}

TEST(SphereTransform, RefusesWhatItCannotTransform) {
  const std::vector<double> z{0.6, -0.8}, sine{0.8, 0.6};
  EXPECT_EQ(message_of([&] { SphereTransform(-1, z, sine, 4); }),
            "LegendreRings: max_degree: expected 0 to 100000, got -1");
  EXPECT_EQ(message_of([&] { SphereTransform(2, z, sine, 0); }), "SphereTransform: around: expected 1 or more, got 0");
  EXPECT_EQ(message_of([&] { SphereTransform(2, z, sine, 4, std::nan("")); }),
            "SphereTransform: phi_0: expected a finite angle");
  const SphereTransform transform(2, z, sine, 4);
  std::vector<double> a(9), map(8), weights(2), wrong(7);
  EXPECT_EQ(message_of([&] { transform.synthesis(a, map); }), "nothing thrown");
  EXPECT_EQ(message_of([&] { transform.synthesis(wrong, map); }),
            "SphereTransform: coefficients: expected 9 values, got 7");
  EXPECT_EQ(message_of([&] { transform.synthesis(a, wrong); }), "SphereTransform: map: expected 8 values, got 7");
  EXPECT_EQ(message_of([&] { transform.analysis(map, wrong, a); }),
            "SphereTransform: weights: expected 2 values, got 7");
  EXPECT_EQ(message_of([&] { transform.analysis(wrong, weights, a); }),
            "SphereTransform: map: expected 8 values, got 7");
  EXPECT_EQ(message_of([&] { transform.analysis(map, weights, wrong); }),
            "SphereTransform: coefficients: expected 9 values, got 7");
}

TEST(SphereTransform, NoRingsAreNoWork) {
  const SphereTransform transform(3, {}, {}, 8);
  std::vector<double> a(16, 1.0), map;
  transform.synthesis(a, map);
  transform.analysis(map, {}, a);
  for (const double value : a) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace sh::numeric
