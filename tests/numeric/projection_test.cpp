// Projection by quadrature and by least squares: band-limited functions come back, refusals name the fault.
#include "numeric/sampling/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/message_of.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

std::vector<double> random_coefficients(int degree) {
  Random random(11);
  std::vector<double> c(coefficient_count(degree));
  for (double& value : c) value = random.next();
  return c;
}

double evaluate(int degree, const std::vector<double>& c, double x, double y, double z) {
  const auto values = basis(degree, x, y, z);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += c[i] * values[i];
  return sum;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) keep_worst(worst, a[i] - b[i]);
  return worst;
}

TEST(Projection, GivesBackABandLimitedFunction) {
  for (const int degree : {0, 3, 20}) {
    const auto c = random_coefficients(degree);
    const auto f = [&](double x, double y, double z) { return evaluate(degree, c, x, y, z); };
    EXPECT_LT(largest_difference(project(degree, sphere_rule<double>(2 * degree), f), c), 1e-13) << degree;
  }
}

TEST(Projection, NamesANodeWhereTheFunctionIsNotFinite) {
  const auto nodes = sphere_rule<double>(4);
  const auto f = [&](double x, double y, double z) {
    return x == nodes[7].x && y == nodes[7].y && z == nodes[7].z ? std::nan("") : 1.0;
  };
  EXPECT_EQ(message_of([&] { project(2, nodes, f); }), "project: node 7: expected a finite value, got nan");
  EXPECT_EQ(message_of([&] { project(-1, nodes, f); }), "project: degree: expected 0 or more, got -1");
}

std::vector<SphereSample> samples_of(int degree, const std::vector<double>& c, const std::vector<Direction>& at) {
  std::vector<SphereSample> samples;
  samples.reserve(at.size());
  for (const Direction& d : at) samples.push_back({d.x, d.y, d.z, evaluate(degree, c, d.x, d.y, d.z)});
  return samples;
}

TEST(LeastSquares, RecoversABandLimitedFunctionFromScatteredSamples) {
  for (const int degree : {0, 1, 4, 12}) {
    const auto c = random_coefficients(degree);
    // 1500 rows: several blocks of the triangularisation.
    const auto fit = fit_samples(degree, samples_of(degree, c, random_directions(1500, 5)));
    EXPECT_LT(largest_difference(fit.coefficients, c), 1e-14 * fit.condition * (degree + 1)) << degree;
    EXPECT_LT(fit.residual_rms, 1e-13);
    EXPECT_LT(fit.residual_max, 1e-12);
    EXPECT_LT(fit.condition, degree < 12 ? 2 : 4) << degree;
  }
}

TEST(LeastSquares, NeedsNoMoreSamplesThanCoefficients) {
  const auto c = random_coefficients(3);
  const auto fit = fit_samples(3, samples_of(3, c, random_directions(16, 2)));
  EXPECT_LT(largest_difference(fit.coefficients, c), 1e-14 * fit.condition);
  EXPECT_LT(fit.residual_max, 1e-13);
}

// The minimum of a quadratic: its gradient, the residual against every basis function, vanishes.
TEST(LeastSquares, LeavesAResidualOrthogonalToTheBasis) {
  auto samples = samples_of(6, random_coefficients(6), random_directions(400, 3));
  Random random(4);
  for (auto& s : samples) s.weight = 1 + random.next();
  const auto fit = fit_samples(2, samples);
  std::vector<double> gradient(9);
  double squares = 0;
  double weights = 0;
  for (const auto& s : samples) {
    const double residual = s.value - evaluate(2, fit.coefficients, s.x, s.y, s.z);
    const auto y = basis(2, s.x, s.y, s.z);
    for (std::size_t i = 0; i < 9; ++i) gradient[i] += s.weight * residual * y[i];
    squares += s.weight * residual * residual;
    weights += s.weight;
    EXPECT_LE(std::abs(residual), fit.residual_max * (1 + 1e-12));
  }
  EXPECT_LT(largest_difference(gradient, std::vector<double>(9)), 1e-11);
  EXPECT_NEAR(fit.residual_rms, std::sqrt(squares / weights), 1e-12);
  const auto& worst = samples[fit.worst_sample];
  EXPECT_NEAR(std::abs(worst.value - evaluate(2, fit.coefficients, worst.x, worst.y, worst.z)), fit.residual_max,
              1e-12);
}

TEST(LeastSquares, CountsASampleOfWeightTwoAsTwoSamples) {
  auto weighted = samples_of(5, random_coefficients(5), random_directions(60, 8));
  auto repeated = weighted;
  for (std::size_t i = 0; i < 20; ++i) {
    repeated.push_back(weighted[i]);
    weighted[i].weight = 2;
  }
  weighted.push_back({0, 0, 1, 1e9, 0});  // weight 0: left out
  const auto fit = fit_samples(3, weighted);
  const auto expected = fit_samples(3, repeated);
  EXPECT_LT(largest_difference(fit.coefficients, expected.coefficients), 1e-13);
  EXPECT_NEAR(fit.residual_rms, expected.residual_rms, 1e-13);
  EXPECT_NEAR(fit.residual_max, expected.residual_max, 1e-13);
}

std::string refusal(int degree, const std::vector<SphereSample>& samples) {
  return message_of([&] { fit_samples(degree, samples); });
}

void expect_rank(int rank, int degree, const std::vector<SphereSample>& samples) {
  EXPECT_EQ(refusal(degree, samples), "fit_samples: expected directions that determine the " +
                                          std::to_string(coefficient_count(degree)) + " coefficients of degree " +
                                          std::to_string(degree) + ", got rank " + std::to_string(rank) +
                                          "; spread them over more of the sphere or lower the degree");
}

std::vector<SphereSample> on_the_equator(int count) {
  std::vector<SphereSample> samples;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    samples.push_back({std::cos(angle), std::sin(angle), 0, 1});
  }
  return samples;
}

TEST(LeastSquares, RefusesDirectionsThatDoNotDetermineTheCoefficients) {
  // A circle carries 2 degree + 1 functions.
  expect_rank(5, 2, on_the_equator(100));
  auto turned = on_the_equator(1000);  // the same circle, in no special place
  for (auto& s : turned) s = {0.6 * s.x - 0.64 * s.y, 0.8 * s.x + 0.48 * s.y, 0.6 * s.y, 2};
  expect_rank(9, 4, turned);
  const std::vector<SphereSample> same(40, SphereSample{0, 0.6, 0.8, 3});
  expect_rank(1, 2, same);
  std::vector<SphereSample> five = samples_of(1, random_coefficients(1), random_directions(5, 1));
  for (int i = 0; i < 50; ++i) five.push_back(five[i % 5]);
  expect_rank(5, 2, five);
  EXPECT_EQ(refusal(0, same), "nothing thrown");
}

TEST(LeastSquares, NamesASampleThatIsWrong) {
  auto samples = samples_of(1, random_coefficients(1), random_directions(10, 1));
  EXPECT_EQ(refusal(3, samples), "fit_samples: samples of weight > 0 for degree 3: expected 16 or more, got 10");
  EXPECT_NE(refusal(-1, samples).find("expected 0 or more, got -1"), std::string::npos);
  EXPECT_NE(refusal(0, {}).find("expected 1 or more, got 0"), std::string::npos);
  const auto changed = [&](const SphereSample& sample) {
    auto copy = samples;
    copy[6] = sample;
    const std::string message = refusal(1, copy), start = "fit_samples: sample 6: expected a ";
    return message.starts_with(start) ? message.substr(start.size()) : message;
  };
  EXPECT_EQ(changed({0, 0, 1.01, 1}), "direction of length 1 to within 0.001, got 1.010000");
  EXPECT_EQ(changed({0, 0, 0, 1}), "direction of length 1 to within 0.001, got 0.000000");
  EXPECT_EQ(changed({std::nan(""), 0, 1, 1}), "direction of length 1 to within 0.001, got nan");
  EXPECT_EQ(changed({0, 0, 1, HUGE_VAL}), "finite value, got inf");
  EXPECT_EQ(changed({0, 0, 1, 1, -1}), "finite weight >= 0, got -1.000000");
  EXPECT_EQ(changed({0, 0, 1, 1, std::nan("")}), "finite weight >= 0, got nan");
  EXPECT_EQ(changed({0, 0, 1.0005, 1}), "nothing thrown");
}

}  // namespace
}  // namespace sh::numeric
