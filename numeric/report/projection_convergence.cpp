#include "numeric/report/projection_convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generated/cpp/project_l5.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/output/stopwatch.hpp"

namespace sh::numeric {
namespace {

using Coefficients = std::array<double, coefficient_count(kConvergenceDegree)>;

// Largest error of a coefficient, in units of the norm of the exact ones.
double error_of(const Coefficients& c, const std::vector<double>& exact) {
  double worst = 0;
  double square = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    worst = std::max(worst, std::abs(c[i] - exact[i]));
    square += exact[i] * exact[i];
  }
  return worst / std::sqrt(square);
}

struct Projection {
  Coefficients coefficients{};
  int samples = 0;
  double nanoseconds = 0;
};

Projection project_with(const SphereRule& rule, const TestFunction& function, int count, std::uint64_t seed) {
  Projection result;
  const output::Stopwatch stopwatch;
  const auto nodes = rule.nodes(count, seed);
  for (const auto& [x, y, z, weight] : nodes) {
    sh::project_l5(x, y, z, weight * function.value(x, y, z), result.coefficients.data());
  }
  result.nanoseconds = 1e9 * stopwatch.seconds();
  result.samples = static_cast<int>(nodes.size());
  return result;
}

ConvergencePoint point(const SphereRule& rule, const TestFunction& function, const std::vector<double>& exact,
                       int count, int seeds) {
  ConvergencePoint p{0, 0, 0, std::numeric_limits<double>::infinity()};
  constexpr int kTimings = 3;
  const int runs = rule.random ? seeds : kTimings;
  double squares = 0;
  for (int run = 0; run < runs; ++run) {
    const Projection projection = project_with(rule, function, count, static_cast<std::uint64_t>(run) + 1);
    const double error = error_of(projection.coefficients, exact);
    squares += error * error;
    p.samples = projection.samples;
    p.error_max = std::max(p.error_max, error);
    p.nanoseconds = std::min(p.nanoseconds, projection.nanoseconds);
  }
  p.error_rms = std::sqrt(squares / runs);
  return p;
}

}  // namespace

ConvergenceSeries converge(const SphereRule& rule, const TestFunction& function, const std::vector<int>& counts,
                           int seeds) {
  ConvergenceSeries series{rule.name, function.name, rule.random ? seeds : 1, {}};
  const std::vector<double> exact = function.coefficients(kConvergenceDegree);
  for (const int count : counts) {
    const ConvergencePoint p = point(rule, function, exact, count, seeds);
    if (series.points.empty() || series.points.back().samples != p.samples) series.points.push_back(p);
  }
  return series;
}

std::vector<ConvergenceSeries> projection_convergence(bool quick, const std::function<void()>& step) {
  std::vector<int> counts;
  for (int power = 4; power <= (quick ? 14 : 20); ++power) counts.push_back(1 << power);
  std::vector<ConvergenceSeries> all;
  for (const TestFunction& function : test_functions()) {
    for (const SphereRule& rule : sphere_rules()) {
      all.push_back(converge(rule, function, counts, quick ? 16 : 32));
      if (step) step();
    }
  }
  return all;
}

}  // namespace sh::numeric
