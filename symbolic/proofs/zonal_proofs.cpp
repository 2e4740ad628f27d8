#include "symbolic/proofs/zonal_proofs.hpp"

#include <cln/integer.h>

#include <array>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/proofs/basis_proofs.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal_derivations.hpp"

namespace sh::symbolic {
namespace {

std::string at_degree(std::size_t degree) { return " at degree " + std::to_string(degree); }

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

ProofResult prove_turned_band(const std::vector<TurnedZonal>& entries, int l, const Polynomial& legendre) {
  Polynomial sum;
  const Surd axial_factor = basis_function(l, 0).factor;
  for (int m = -l; m <= l; ++m) {
    const TurnedZonal& entry = entries[coefficient_index(l, m)];
    const BasisFunction y = basis_function(l, m);
    const Surd ratio = entry.factor * y.factor / axial_factor;
    const std::string place = " at degree " + std::to_string(l) + ", order " + std::to_string(m);
    if (entry.degree != l || entry.order != m) return refuted("the entry" + place + " belongs elsewhere");
    if (!(ratio == Surd(ratio.rational()))) return refuted("the factor" + place + " has another radical");
    sum += ratio.rational() * (entry.polynomial * moved(y.homogeneous, 3));
  }
  const bool equal = sum == legendre;
  return equal ? proved("") : refuted("the sum over m differs from Y_l0(d.s) at degree " + std::to_string(l));
}

}  // namespace

ProofResult prove_zonal_family(const ZonalFamily& family, const std::vector<ZonalTerm>& claimed) {
  for (std::size_t l = 0; l < claimed.size(); ++l) {
    if (!same_value(family.closed_form(static_cast<int>(l)), claimed[l])) {
      return refuted(family.name + ": closed form and integral differ" + at_degree(l));
    }
  }
  return proved(std::to_string(claimed.size()) + " coefficients of " + family.name);
}

ProofResult prove_cap_complement(const std::vector<ZonalTerm>& cap, const std::vector<ZonalTerm>& complement) {
  if (cap.size() != complement.size()) return refuted("the cap and its complement have different numbers of bands");
  for (std::size_t l = 0; l < cap.size(); ++l) {
    // cap = rest - complement, with rest = sqrt(4 pi) in band 0
    ZonalTerm negated = complement[l];
    negated.factor = -negated.factor;
    if (l == 0) {
      if (!negated.denominator.empty() || negated.numerator.size() != 1) {
        return refuted("the complement is no polynomial" + at_degree(l));
      }
      const Surd constant = Surd(2) * Surd::square_root(1, 1) / complement[l].factor;
      if (!(constant == Surd(constant.rational()))) return refuted("another radical" + at_degree(l));
      negated.numerator.front() -= Polynomial(constant.rational());
    }
    if (!same_value(cap[l], negated)) return refuted("cap and complement do not add up" + at_degree(l));
  }
  return proved(std::to_string(cap.size()) + " bands");
}

ProofResult prove_irradiance_factors(const std::vector<Surd>& claimed) {
  for (std::size_t l = 0; l < claimed.size(); ++l) {
    if (!(irradiance_factor_integral(static_cast<int>(l)) == claimed[l])) {
      return refuted("the factor differs from its integral" + at_degree(l));
    }
  }
  return proved(std::to_string(claimed.size()) + " factors");
}

ProofResult prove_convolution(const std::vector<Surd>& factors) {
  const int degree = static_cast<int>(factors.size()) - 1;
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  int identities = 0;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Polynomial solid = basis_function(l, m).homogeneous;
      for (int k = l; k <= degree; k += 2) {  // other powers of t have no part in band l
        const std::vector<ZonalPiece> power{
            {Polynomial::variable(kAxisVariable).power(k), Polynomial(-1), Polynomial(1)}};
        const Surd eigenvalue = factors[l] * project_profile(l, power).at({}) / sphere_area;
        const Polynomial expected = eigenvalue.rational() * (dot_product(0, 0).power((k - l) / 2) * solid);
        if (!(eigenvalue == Surd(eigenvalue.rational())) || !(mean_against_power(solid, k) == expected)) {
          return refuted("Y_" + std::to_string(l) + "," + std::to_string(m) + " convolved with t^" + std::to_string(k));
        }
        ++identities;
      }
    }
  }
  return proved(std::to_string(identities) + " pairs of a function and a power of s.n");
}

ProofResult prove_turned_zonal(const std::vector<TurnedZonal>& entries) {
  const int count = static_cast<int>(entries.size());
  int bands = 0;
  while ((bands + 1) * (bands + 1) <= count) ++bands;
  if (bands * bands != count) return refuted("the last band is not complete");
  const std::vector<Polynomial> legendre = two_point_legendre(bands - 1);
  for (int l = 0; l < bands; ++l) {
    ProofResult band = prove_turned_band(entries, l, legendre[l]);
    if (!band.proved) return band;
  }
  return proved(std::to_string(bands) + " bands");
}

namespace {

std::vector<Surd> surds_to(int degree, Surd (*of)(int)) {
  std::vector<Surd> values;
  for (int l = 0; l <= degree; ++l) values.push_back(of(l));
  return values;
}

}  // namespace

std::vector<Proof> zonal_proofs() {
  const std::string exponents = "exponents of the square of P_l stay below 128";
  const std::string points = "the identity in two points has a number of terms that grows with the fourth power";
  std::vector<Proof> proofs;
  for (const ZonalFamily& family : zonal_families()) {
    proofs.push_back(
        {"zonal-" + family.name,
         "GiNaC's definition z_l = sqrt((2l+1) pi) integral f(t) P_l(t) dt, f = " + family.function + ", = closed form",
         "two derivations compared as functions of the parameters", 20, kMaxZonalDegree, exponents,
         [&family](int degree) { return prove_zonal_family(family, zonal_coefficients(family, degree)); }});
  }
  proofs.push_back({"cap-complement", "cap + complement = 1", "coefficients as polynomials in c", 10, kMaxZonalDegree,
                    exponents, [](int degree) {
                      return prove_cap_complement(zonal_coefficients(zonal_family("cap"), degree),
                                                  zonal_coefficients(zonal_family("cap-complement"), degree));
                    }});
  proofs.push_back({"irradiance-factors", "GiNaC's definition A_l = 2 pi integral_0^1 t P_l(t) dt = closed form",
                    "two derivations compared", 20, kMaxIrradianceDegree, "exponents stay below 128",
                    [](int degree) { return prove_irradiance_factors(surds_to(degree, irradiance_factor)); }});
  proofs.push_back({"convolution-theorem", "integral Y_lm(s) h(s.n) ds = sqrt(4 pi / (2l+1)) h_l Y_lm(n), h = t^k",
                    "multinomial expansion, integrated term by term", 10, 20,
                    "every power of s.n is expanded for every function",
                    [](int degree) { return prove_convolution(surds_to(degree, convolution_factor)); }});
  proofs.push_back({"turned-zonal", "sum_m sqrt(4 pi / (2l+1)) Y_lm(d) Y_lm(s) = Y_l0(d.s)",
                    "identity of polynomials in (d, s)", 10, 20, points,
                    [](int degree) { return prove_turned_zonal(turned_zonal(degree)); }});
  return proofs;
}

}  // namespace sh::symbolic
