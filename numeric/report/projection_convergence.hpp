// How fast the projection of a function converges, for every rule of sphere_rules.hpp and every one of
// test_functions.hpp.
//
// Output: series of error against number of samples and time, ready to plot on logarithmic axes. Coefficients up to
// degree 5 in double, by the generated kernel project_l5. Errors are the same in every run, times are measured.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/report/test_functions.hpp"
#include "numeric/sampling/sphere_rules.hpp"

namespace sh::numeric {

inline constexpr int kConvergenceDegree = 5;

struct ConvergencePoint {
  int samples;         // nodes of the rule
  double error_rms;    // over the seeds of a random rule (one error else)
  double error_max;    // error: largest of a coefficient, over the norm of the exact coefficients
  double nanoseconds;  // of one projection: making the nodes, evaluating the function, summing; least of the seeds
};

struct ConvergenceSeries {
  std::string rule;
  std::string function;
  int seeds;  // 1 unless the rule is random
  std::vector<ConvergencePoint> points;
};

// One series, a point for every count asked for that gives another number of nodes than the one before.
ConvergenceSeries converge(const SphereRule& rule, const TestFunction& function, const std::vector<int>& counts,
                           int seeds);

// Every rule x every function. Quick: up to 16,000 samples, 16 seeds, under a second; full: a million, 32 seeds.
// `step` is called after each series.
std::vector<ConvergenceSeries> projection_convergence(bool quick, const std::function<void()>& step = {});

// The exponent p of error_rms = C samples^p, fitted by least squares to the logarithms of the points with at least
// `from` samples and an error over 1e-12 (below that it is rounding). NaN with fewer than two such points.
double convergence_exponent(const ConvergenceSeries& series, int from = 0);

}  // namespace sh::numeric
