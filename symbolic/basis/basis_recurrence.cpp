// The second derivation of the basis: sparse polynomials over CLN rationals, nothing of GiNaC.
#include <cln/integer.h>

#include <cstdlib>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

cln::cl_I factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }
cln::cl_I binomial(int n, int k) { return cln::binomial(static_cast<unsigned>(n), static_cast<unsigned>(k)); }

// q(z) = 2^-l sum_k (-1)^k C(l,k) C(2l-2k,l) (l-2k)!/(l-2k-a)! z^(l-2k-a)    [AbramowitzStegun64] 22.3.8
Polynomial axial_part(int l, int a) {
  Polynomial q;
  for (int k = 0; l - 2 * k - a >= 0; ++k) {
    const int power = l - 2 * k - a;
    const cln::cl_I term =
        binomial(l, k) * binomial(2 * l - 2 * k, l) * cln::exquo(factorial(l - 2 * k), factorial(power));
    q.add_term({0, 0, power}, (k % 2 == 0 ? term : -term) / cln::ash(cln::cl_I(1), l));
  }
  return q;
}

// Re and Im of (x + iy)^a by c' = x c - y s, s' = x s + y c.
Polynomial azimuthal_part(int order) {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  Polynomial c(1);
  Polynomial s;
  for (int i = 0; i < std::abs(order); ++i) {
    Polynomial next_c = x * c - y * s;
    s = x * s + y * c;
    c = std::move(next_c);
  }
  return order < 0 ? s : c;
}

// (l-a+1) S_(l+1) = (2l+1) z S_l - (l+a) r^2 S_(l-1), from S_a = (2a-1)!! Re or Im (x+iy)^a and S_(a-1) = 0.
Polynomial solid_harmonic(int degree, int a, const Polynomial& azimuthal) {
  const Polynomial z = Polynomial::variable(2);
  const Polynomial r2 = Polynomial::variable(0).power(2) + Polynomial::variable(1).power(2) + z.power(2);
  const cln::cl_RA start = a == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(2 * a - 1));
  Polynomial below;
  Polynomial current = start * azimuthal;
  for (int l = a; l < degree; ++l) {
    const Polynomial above = cln::cl_RA(2 * l + 1) * (z * current) - cln::cl_RA(l + a) * (r2 * below);
    below = std::move(current);
    current = cln::cl_RA(1) / (l - a + 1) * above;
  }
  return current;
}

// 1 / sqrt(integral of the square) = 1 / sqrt(4 pi mean)
Surd normalizing_factor(const Polynomial& p) { return Surd::square_root(1 / (4 * sphere_mean(p * p)), -1); }

}  // namespace

BasisFunction basis_function_by_recurrence(int degree, int order) {
  require_basis_index(degree, order);
  const int a = std::abs(order);
  BasisFunction f{degree, order, {}, axial_part(degree, a), azimuthal_part(order), {}};
  f.homogeneous = solid_harmonic(degree, a, f.azimuthal);
  f.factor = normalizing_factor(f.homogeneous);
  return f;
}

}  // namespace sh::symbolic
