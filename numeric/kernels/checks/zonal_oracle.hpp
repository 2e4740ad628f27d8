// Exact zonal functions, turned, and irradiance for the checks, from numeric's basis and clamped cosine.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric {

// out (bands^2): the zonal function z_0, z_1, ... turned from +z to the unit direction d.
template <class Real>
void turned_zonal(int degree, const Real* zonal, const Real* d, Real* out) {
  using std::sqrt;
  basis(degree, d[0], d[1], d[2], out);
  for (int l = 0; l <= degree; ++l) {
    const Real factor = sqrt(Real(4 * pi<Real>() / static_cast<Real>(2 * l + 1))) * zonal[l];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
  }
}

// E(n) = sum A_l c_lm Y_lm(n), |n| = 1.
template <class Real>
Real irradiance_at(int degree, const Real* c, const Real& x, const Real& y, const Real& z) {
  std::vector<Real> values(static_cast<std::size_t>(coefficient_count(degree)));
  basis(degree, x, y, z, values.data());
  Real sum = 0;
  for (int l = 0; l <= degree; ++l) {
    const Real factor = clamped_cosine_factor<Real>(l);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += factor * c[i] * values[static_cast<std::size_t>(i)];
  }
  return sum;
}

}  // namespace sh::numeric
