#include "numeric/sampling/power_law.hpp"

#include <algorithm>
#include <cmath>

namespace sh::numeric {

std::optional<PowerLaw> fit_power_law(const std::vector<std::pair<double, double>>& points, double least, double most) {
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
