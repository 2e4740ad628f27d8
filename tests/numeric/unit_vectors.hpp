// Random coefficient vectors of length 1.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {

/// (bands^2), the same numbers up to rounding in every Real.
template <class Real>
std::vector<Real> unit_vector(int degree, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(coefficient_count(degree));
  double square = 0;
  for (double& v : values) {
    v = random.next();
    square += v * v;
  }
  std::vector<Real> unit;
  unit.reserve(values.size());
  for (const double v : values) unit.push_back(static_cast<Real>(v / std::sqrt(square)));
  return unit;
}

}  // namespace sh::numeric
