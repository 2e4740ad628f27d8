// How fast the projection of a function converges, for every rule of sphere_nodes.hpp and every test function.
//
// Output: error against number of samples and time. Coefficients up to degree 5 in double, by the generated kernel
// project_l5. Errors are the same in every run, times are measured.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::numeric {

/// A function on the sphere, and its coefficients by an independent way, exact to rounding: an integral over one
/// variable times the addition theorem. Conventions: numeric/README.md.
struct TestFunction {
  std::string name;         ///< "band_limited", "smooth", "cap", "sun"
  std::string description;  ///< in words, with its numbers
  std::function<double(double x, double y, double z)> value;
  std::function<std::vector<double>(int degree)> coefficients;  ///< (bands^2)
};

/// Of rising difficulty. band_limited: degree 5, coefficients uniform in [-1, 1). The others are zonal about an axis that
/// favors no rule. smooth: exp(4 (cos - 1)). cap: 1 within 40 degrees of the axis, else 0. sun: a sky of radiance 1 and
/// a disc of 1e6 of radius 1 degree.
std::span<const TestFunction> test_functions();

/// Coefficients of profile(cos of the angle to the axis (x, y, z)), which vanishes outside from <= cos <= 1:
/// c_lm = 2 pi Y_lm(axis) INT profile(t) P_l(t) dt, by Gauss-Legendre with `nodes` nodes over [from, 1].
std::vector<double> zonal_coefficients(int degree, const std::function<double(double)>& profile, double from, int nodes,
                                       std::span<const double, 3> axis);

inline constexpr int kConvergenceDegree = 5;

struct ConvergencePoint {
  int samples;         ///< nodes of the rule
  double error_rms;    ///< over the seeds of a random rule (one error else)
  double error_max;    ///< error: largest of a coefficient, over the norm of the exact coefficients
  double nanoseconds;  ///< of one projection: making the nodes, evaluating the function, summing; least of the seeds
};

struct ConvergenceSeries {
  std::string rule;
  std::string function;
  int seeds;  ///< 1 unless the rule is random
  std::vector<ConvergencePoint> points;
};

/// One series: a point for each of `counts` that gives another number of nodes than the one before.
ConvergenceSeries converge(const SphereRule& rule, const TestFunction& function, const std::vector<int>& counts,
                           int seeds);

/// Every rule x every function. Quick: up to 16,000 samples, 16 seeds, under a second; full: a million, 32 seeds.
/// Calls `step` after each series.
std::vector<ConvergenceSeries> projection_convergence(bool quick, const std::function<void()>& step = {});

}  // namespace sh::numeric
