// How fast an error falls: y = factor x^exponent through points, by least squares in the logarithms.
#pragma once
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sh::numeric {

struct PowerLaw {
  double factor;
  double exponent;
};

/// Points are (x, y), both > 0. The exponent is clamped to least .. most, and the factor fitted to it. None unless
/// there are two different x.
std::optional<PowerLaw> fit_power_law(const std::vector<std::pair<double, double>>& points,
                                      double least = -std::numeric_limits<double>::infinity(),
                                      double most = std::numeric_limits<double>::infinity());

}  // namespace sh::numeric
