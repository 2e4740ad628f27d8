// The largest of several errors, in which a NaN counts as infinite: std::max would drop it.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace sh::numeric {

inline void keep_worst(double& worst, double error) {
  const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
  if (size > worst) worst = size;
}

// The largest error of a coefficient, of the length of all.
inline double relative_error(const std::vector<double>& c, const std::vector<double>& exact) {
  double worst = 0;
  double square = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    keep_worst(worst, c[i] - exact[i]);
    square += exact[i] * exact[i];
  }
  return worst / std::sqrt(square);
}

}  // namespace sh::numeric
