#include "symbolic/errata/brown_basis.hpp"

#include <cln/integer.h>

#include <cstdlib>

namespace sh::symbolic::errata {
namespace {

// above sqrt(radicand) / (below sqrt(half pi)), half = 1 or 2
Surd constant(int above, int radicand, int below, int half = 1) {
  return Surd(ratio(above, below)) * Surd::square_root(ratio(radicand, half), -1);
}

}  // namespace

Polynomial brown_legendre(int degree, int order) {
  const Angles a;
  Polynomial diagonal(1);  // P_0^0
  for (int m = 1; m <= order; ++m) diagonal = cln::cl_RA(2 * m - 1) * a.sin_theta * diagonal;
  if (degree == order) return diagonal;
  Polynomial below = diagonal;
  Polynomial current = cln::cl_RA(2 * order + 1) * a.cos_theta * diagonal;
  for (int l = order + 2; l <= degree; ++l) {
    const Polynomial next =
        ratio(1, l - order) * (cln::cl_RA(2 * l - 1) * a.cos_theta * current - cln::cl_RA(l + order - 1) * below);
    below = current;
    current = next;
  }
  return current;
}

Surd brown_theta_factor(int degree, int order) {
  const cln::cl_RA quotient = cln::factorial(static_cast<unsigned>(degree - order)) /
                              cln::cl_RA(cln::factorial(static_cast<unsigned>(degree + order)));
  return Surd::square_root(ratio(2 * degree + 1, 4) * quotient, -1);
}

SurdTerm brown_phi(int order) {
  const Surd root_2 = Surd::square_root(2);
  if (order > 0) return {root_2, cosine_of_multiple(order)};
  if (order < 0) return {root_2, sine_of_multiple(-order)};
  return {Surd(cln::cl_RA(1)), Polynomial(1)};
}

SurdTerm brown_function(int degree, int order) {
  const int m = std::abs(order);
  const SurdTerm phi = brown_phi(order);
  return {brown_theta_factor(degree, m) * phi.factor, reduce_angles(brown_legendre(degree, m) * phi.polynomial)};
}

std::vector<BrownRow> brown_table_to_2() {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  const Polynomial one(1);
  const auto& [cp, sp, ct, st] = Angles();
  return {{0, 0, constant(1, 1, 2), one, one},
          {1, 1, constant(1, 3, 2), sp * st, y},
          {1, 0, constant(1, 3, 2), ct, z},
          {1, -1, constant(1, 3, 2), cp * st, x},
          {2, -2, constant(1, 15, 2), cp * sp * st * st, x * y},
          {2, -1, constant(1, 15, 2), sp * ct * st, y * z},
          {2, 0, constant(1, 5, 4), 3 * (ct * ct) - one, 3 * (z * z) - one},
          {2, 1, constant(1, 15, 2), cp * ct * st, x * z},
          {2, 2, constant(1, 15, 4), (cp * cp - sp * sp) * st * st, x * x - y * y}};
}

std::vector<BrownRow> brown_table_3() {
  const Polynomial one(1);
  const auto& [cp, sp, ct, st] = Angles();
  return {{3, -3, constant(1, 35, 4, 2), (3 * (cp * cp) - sp * sp) * sp * st.power(3), {}},
          {3, -2, constant(1, 105, 2), cp * sp * ct * st.power(2), {}},
          {3, -1, constant(1, 21, 4, 2), (5 * (ct * ct) - one) * sp * st, {}},
          {3, 0, constant(1, 7, 4), 5 * ct.power(3) - 3 * ct, {}},
          {3, 1, constant(1, 21, 4, 2), (5 * (ct * ct) - one) * cp * st, {}},
          {3, 2, constant(1, 105, 4), (cp * cp - sp * sp) * ct * st.power(2), {}},
          {3, 3, constant(1, 35, 4, 2), (cp * cp - 3 * (sp * sp)) * cp * st.power(3), {}}};
}

std::vector<BrownRow> brown_table_4() {
  const Polynomial one(1);
  const auto& [cp, sp, ct, st] = Angles();
  const Polynomial c2 = cp * cp;
  const Polynomial s2 = sp * sp;
  const Polynomial t2 = ct * ct;
  return {{4, -4, constant(3, 35, 4), (c2 - s2) * cp * sp * st.power(4), {}},
          {4, -3, constant(3, 35, 4, 2), (3 * c2 - s2) * sp * ct * st.power(3), {}},
          {4, -2, constant(3, 5, 4), (7 * t2 - one) * cp * sp * st.power(2), {}},
          {4, -1, constant(3, 5, 4, 2), (7 * t2 - 3 * one) * sp * ct * st, {}},
          {4, 0, constant(3, 1, 16), 3 * one - 30 * t2 + 35 * (t2 * t2), {}},
          {4, 1, constant(3, 5, 4, 2), (7 * t2 - 3 * one) * cp * ct * st, {}},
          {4, 2, constant(3, 5, 8), (7 * t2 - one) * (c2 - s2) * st.power(2), {}},
          {4, 3, constant(3, 35, 4, 2), (c2 - 3 * s2) * cp * ct * st.power(3), {}},
          {4, 4, constant(3, 35, 16), (s2 * s2 - 6 * (c2 * s2) + c2 * c2) * st.power(4), {}}};
}

}  // namespace sh::symbolic::errata
