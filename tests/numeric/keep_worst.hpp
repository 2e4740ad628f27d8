// The largest of several errors, in which a NaN counts as infinite: std::max would drop it.
#pragma once

#include <cmath>
#include <limits>

namespace sh::numeric {

inline void keep_worst(double& worst, double error) {
  const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
  if (size > worst) worst = size;
}

}  // namespace sh::numeric
