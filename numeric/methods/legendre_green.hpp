// The textbook's recurrence: unnormalised P_lm times a factor with factorials. Input, output: legendre_common.hpp.
#pragma once

#include "numeric/methods/legendre_common.hpp"

namespace sh::numeric {

// Source: [Green03], after Numerical Recipes (Press et al. 1992, section 6.8): P_mm = (2m-1)!! sin^m theta,
// (l-m) P_lm = (2l-1) z P_(l-1,m) - (l+m-1) P_(l-2,m), times K_lm = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!).
// Cost: O(L^2), a root, two divisions and 5 products a value (the source restarts every value: O(L^3)).
// Fails: (l+m)! overflows beyond 34! in float and 170! in double. From degree 18 (float) and 86 (double) on, the
// highest orders get K_lm = 0: a silent zero where the value is a third of the band's maximum. Where P_lm or both
// factorials overflow too, NaN: from degree 29 (float) and 151 (double) on.
template <class Real>
void legendre_green(int degree, const Real& z, const Real& sine, Real* out) {
  using std::sqrt;
  std::vector<Real> factorial(2 * static_cast<std::size_t>(degree) + 1, Real(1));
  for (std::size_t n = 1; n < factorial.size(); ++n) factorial[n] = factorial[n - 1] * static_cast<Real>(n);
  const auto factor = [&](int l, int m) {
    const auto degree_l = static_cast<std::size_t>(l), order = static_cast<std::size_t>(m);
    const Real ratio = factorial[degree_l - order] / factorial[degree_l + order];
    return Real(sqrt(Real(static_cast<Real>(2 * l + 1) / (4 * pi<Real>()) * ratio)));
  };
  Real sectoral = 1;
  for (int m = 0; m <= degree; ++m) {
    Real current = sectoral, before = 0;
    out[legendre_index(m, m)] = factor(m, m) * current;
    for (int l = m + 1; l <= degree; ++l) {
      const Real next = (static_cast<Real>(2 * l - 1) * z * current - static_cast<Real>(l + m - 1) * before) /
                        static_cast<Real>(l - m);
      before = current;
      current = next;
      out[legendre_index(l, m)] = factor(l, m) * current;
    }
    sectoral *= static_cast<Real>(2 * m + 1) * sine;
  }
}

}  // namespace sh::numeric
