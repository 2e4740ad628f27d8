#include <cln/integer.h>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"

namespace sh::symbolic {
namespace {

// integral S(s) (s.n)^k ds / (4 pi), S of degree at most k: the multinomial terms of (s.n)^k, integrated one by one.
Polynomial mean_against_power(const Polynomial& solid, int k) {
  const auto factorial = [](int n) { return cln::factorial(static_cast<unsigned>(n)); };
  Polynomial result;
  for (int a = 0; a <= k; ++a) {
    for (int b = 0; a + b <= k; ++b) {
      const Monomial monomial{a, b, k - a - b};
      Polynomial power;
      power.add_term(monomial, factorial(k) / cln::cl_RA(factorial(a) * factorial(b) * factorial(k - a - b)));
      result.add_term(monomial, sphere_mean(power * solid));
    }
  }
  return result;
}

// z_l of t^k by its definition.
Surd zonal_of_power(int l, int k) {
  const Polynomial integrand = Polynomial::variable(0).power(k) * legendre_polynomial(l, 0);
  const Polynomial moment = definite_integral(integrand, 0, Polynomial(-1), Polynomial(1));
  return Surd::square_root(2 * l + 1, 1) * Surd(moment.coefficient({}));
}

}  // namespace

int prove_zonal_family(const ZonalFamily& family, const std::vector<ZonalTerm>& claimed) {
  const int count = static_cast<int>(claimed.size());
  for (int l = 0; l < count; ++l) {
    if (same_value(family.closed_form(l), claimed[l])) continue;
    throw Refuted(family.name + ": closed form and integral differ" + at_degree(l));
  }
  return count;
}

int prove_cap_complement(const std::vector<ZonalTerm>& cap, const std::vector<ZonalTerm>& complement) {
  if (cap.size() != complement.size()) throw Refuted("the cap and its complement have different numbers of bands");
  const int count = static_cast<int>(cap.size());
  for (int l = 0; l < count; ++l) {
    // cap = rest - complement, with rest = sqrt(4 pi) in band 0
    ZonalTerm negated = complement[l];
    negated.factor = -negated.factor;
    if (l == 0) {
      const Surd constant = Surd(2) * Surd::square_root(1, 1) / complement[l].factor;
      if (!negated.denominator.empty() || negated.numerator.size() != 1 || !constant.is_rational()) {
        throw Refuted("the complement is no polynomial over sqrt(pi)" + at_degree(l));
      }
      negated.numerator.front() -= Polynomial(constant.rational());
    }
    if (!same_value(cap[l], negated)) throw Refuted("cap and complement do not add up" + at_degree(l));
  }
  return count;
}

int prove_irradiance_factors(const std::vector<Surd>& claimed, const std::vector<Surd>& integral) {
  const int count = static_cast<int>(claimed.size());
  for (int l = 0; l < count; ++l) {
    if (!(integral.at(l) == claimed[l])) throw Refuted("the factor differs from its integral" + at_degree(l));
  }
  return count;
}

int prove_irradiance_convolution(const std::vector<Surd>& irradiance, const std::vector<Surd>& convolution,
                                 const std::vector<ZonalTerm>& clamped_cosine,
                                 const std::function<Surd(Folded folded, int degree)>& folded) {
  const int count = static_cast<int>(irradiance.size());
  const Surd pi = Surd::square_root(1, 2);
  for (int l = 0; l < count; ++l) {
    if (!(convolution.at(l) * clamped_cosine.at(l).at({}) == irradiance[l])) {
      throw Refuted("the factor differs from the convolution with the clamped cosine" + at_degree(l));
    }
    const bool is_kept = folded(Folded::kNothing, l) == Surd(1);
    if (!is_kept || (l <= 2 && !(pi * folded(Folded::kCosineOverPi, l) == irradiance[l]))) {
      throw Refuted("the folded factor differs from A_l / pi" + at_degree(l));
    }
  }
  return count;
}

int prove_convolution(const std::vector<Surd>& factors) {
  const int degree = static_cast<int>(factors.size()) - 1;
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  int identities = 0;
  for (const BasisFunction& y : derive_basis(degree)) {
    const int l = y.degree;
    for (int k = l; k <= degree; k += 2) {  // other powers of t have no part in band l
      const Surd eigenvalue = factors[l] * zonal_of_power(l, k) / sphere_area;
      const Polynomial expected = eigenvalue.rational() * (dot_product(0, 0).power((k - l) / 2) * y.homogeneous);
      if (!eigenvalue.is_rational() || !(mean_against_power(y.homogeneous, k) == expected)) {
        throw Refuted(y.name() + " convolved with t^" + std::to_string(k));
      }
      ++identities;
    }
  }
  return identities;
}

int prove_turned_zonal(const std::vector<TurnedZonal>& entries) {
  const int last = static_cast<int>(entries.size()) - 1;
  const int degree = degree_order(last).degree;
  if (coefficient_count(degree) != last + 1) throw Refuted("the last band is not complete");
  std::vector<Polynomial> sums(degree + 1);
  for (const BasisFunction& y : derive_basis(degree)) {
    const TurnedZonal& entry = entries[coefficient_index(y.degree, y.order)];
    const Surd ratio = entry.factor * y.factor / orthonormal_factor(y.degree, 0);
    if (entry.degree != y.degree || entry.order != y.order) throw Refuted(y.name() + ": the entry belongs elsewhere");
    if (!ratio.is_rational()) throw Refuted(y.name() + ": the factor has another radical");
    sums[y.degree] += ratio.rational() * (entry.polynomial * moved(y.homogeneous, 3));
  }
  const std::vector<Polynomial> legendre = two_point_legendre(degree);
  for (int l = 0; l <= degree; ++l) {
    if (!(sums[l] == legendre[l])) throw Refuted("the sum over m differs from Y_l0(d.s)" + at_degree(l));
  }
  return degree + 1;
}

}  // namespace sh::symbolic
