// How fast an error falls: y = factor x^exponent through points, by least squares in the logarithms.
#pragma once

#include <algorithm>
#include <cmath>
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
inline std::optional<PowerLaw> fit_power_law(const std::vector<std::pair<double, double>>& points,
                                             double least = -std::numeric_limits<double>::infinity(),
                                             double most = std::numeric_limits<double>::infinity()) {
  const auto n = static_cast<double>(points.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += std::log(x) / n;
    mean_y += std::log(y) / n;
  }
  double xx = 0;
  double xy = 0;
  for (const auto& [x, y] : points) {
    xx += (std::log(x) - mean_x) * (std::log(x) - mean_x);
    xy += (std::log(x) - mean_x) * (std::log(y) - mean_y);
  }
  if (!(xx > 0)) return std::nullopt;
  const double exponent = std::clamp(xy / xx, least, most);
  return PowerLaw{std::exp(mean_y - exponent * mean_x), exponent};
}

}  // namespace sh::numeric
