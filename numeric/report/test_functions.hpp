// Functions on the sphere of rising difficulty whose coefficients are known to rounding: what quadrature rules and
// projections are tried on.
//
// Output: the function and, by an independent way (a one-variable integral times the addition theorem), its
// coefficients. Conventions: numeric/README.md. All but the first are zonal about an axis that favours no rule.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace sh::numeric {

struct TestFunction {
  std::string name;         // "band_limited", "smooth", "cap", "sun"
  std::string description;  // in words, with its numbers
  std::function<double(double x, double y, double z)> value;
  std::function<std::vector<double>(int degree)> coefficients;  // (bands^2)
};

// band_limited: degree 5, coefficients uniform in [-1, 1). smooth: exp(4 (cos - 1)). cap: 1 within 40 degrees of the
// axis, else 0. sun: a sky of radiance 1 and a disc of 1e6 of radius 1 degree.
std::span<const TestFunction> test_functions();

// 1 + 1e6 exp((cos - 1) / width^2) about the same axis: a peak of 1e6:1 without an edge. 0 < width <= 1, radians.
TestFunction soft_sun(double width);

// Coefficients of profile(cos of the angle to the axis (x, y, z)), which vanishes outside from <= cos <= 1:
// c_lm = 2 pi Y_lm(axis) INT profile(t) P_l(t) dt, by Gauss-Legendre with `nodes` nodes over [from, 1].
std::vector<double> zonal_coefficients(int degree, const std::function<double(double)>& profile, double from, int nodes,
                                       std::span<const double, 3> axis);

}  // namespace sh::numeric
