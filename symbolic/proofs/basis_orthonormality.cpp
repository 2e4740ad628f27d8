// Orthonormality of the basis, by integration of every pair and by the one-dimensional reduction.
#include <cln/integer.h>

#include <cstdlib>
#include <map>
#include <set>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

// The mean of f * monomial for every monomial that occurs in the basis: afterwards a pair costs one dot product.
std::map<Monomial, cln::cl_RA> means_with(const Polynomial& f, const std::set<Monomial>& monomials) {
  std::map<Monomial, cln::cl_RA> result;
  for (const Monomial& left : monomials) {
    cln::cl_RA sum = 0;
    for (const auto& [right, coefficient] : f.terms()) {
      const cln::cl_RA& mean = sphere_mean(left * right);
      if (!cln::zerop(mean)) sum = sum + coefficient * mean;
    }
    if (!cln::zerop(sum)) result.emplace(left, sum);
  }
  return result;
}

cln::cl_RA dot(const Polynomial& f, const std::map<Monomial, cln::cl_RA>& means) {
  cln::cl_RA sum = 0;
  for (const auto& [monomial, coefficient] : f.terms()) {
    const auto position = means.find(monomial);
    if (position != means.end()) sum = sum + coefficient * position->second;
  }
  return sum;
}

// The integral of a b, which is factor_a factor_b over_pi pi, has to be 1 for one and the same function and 0
// otherwise.
void require_integral(const BasisFunction& a, const BasisFunction& b, const cln::cl_RA& over_pi, bool same) {
  const bool holds = same ? a.factor * b.factor * Surd(over_pi) == Surd::square_root(1, -2) : cln::zerop(over_pi);
  if (holds) return;
  throw Refuted("the integral of (" + a.name() + ") times (" + b.name() + ") is not " + (same ? "1" : "0"));
}

// cos m phi and sin m phi as homogeneous polynomials in x, y: T_(m+1) = 2 x T_m - (x^2+y^2) T_(m-1).
Polynomial expected_azimuthal(int order) {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial rho2 = x * x + y * y;
  Polynomial below = order < 0 ? Polynomial() : Polynomial(1);
  Polynomial current = order < 0 ? y : x;
  if (order == 0) return below;
  for (int m = 1; m < std::abs(order); ++m) {
    Polynomial above = cln::cl_RA(2) * (x * current) - rho2 * below;
    below = std::move(current);
    current = std::move(above);
  }
  return current;
}

// integral of z^p (1-z^2)^m over [-1, 1] for even p: 2 m! 2^m (p-1)!! / (p+2m+1)!!
cln::cl_RA axial_moment(int p, int m) {
  if (p % 2 != 0) return 0;
  const auto double_factorial = [](int n) { return cln::doublefactorial(static_cast<unsigned>(n)); };
  const cln::cl_I above = p == 0 ? cln::cl_I(1) : double_factorial(p - 1);
  return 2 * cln::ash(cln::factorial(static_cast<unsigned>(m)), m) * above /
         cln::cl_RA(double_factorial(p + 2 * m + 1));
}

// The functions of one order: every pair, with the moments against each power of z made once per function.
void prove_order(const std::vector<const BasisFunction*>& functions, int m, int highest) {
  std::vector<cln::cl_RA> moment;
  for (int p = 0; p <= 2 * highest; ++p) moment.push_back(axial_moment(p, m));
  for (const BasisFunction* a : functions) {
    std::vector<cln::cl_RA> with(highest + 1, 0);
    for (const auto& [monomial, coefficient] : a->axial.terms()) {
      for (int k = 0; k <= highest; ++k) with[k] = with[k] + coefficient * moment[monomial.exponent(2) + k];
    }
    for (const BasisFunction* b : functions) {
      if (b->degree > a->degree) continue;
      cln::cl_RA sum = 0;
      for (const auto& [monomial, coefficient] : b->axial.terms()) {
        sum = sum + coefficient * with[monomial.exponent(2)];
      }
      require_integral(*a, *b, sum * (m == 0 ? 2 : 1), a == b);  // the azimuthal integral of a square is pi or 2 pi
    }
  }
}

}  // namespace

int prove_orthonormality(const Basis& basis) {
  std::set<Monomial> monomials;
  for (const BasisFunction& f : basis) {
    for (const auto& [monomial, coefficient] : f.homogeneous.terms()) monomials.insert(monomial);
  }
  int pairs = 0;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const auto means = means_with(basis[i].homogeneous, monomials);
    for (std::size_t j = 0; j <= i; ++j, ++pairs) {
      require_integral(basis[i], basis[j], 4 * dot(basis[j].homogeneous, means), i == j);
    }
  }
  return pairs;
}

int prove_orthonormality_by_reduction(const Basis& basis) {
  std::map<int, std::vector<const BasisFunction*>> by_order;
  int highest = 0;
  for (const BasisFunction& f : basis) {
    for (const auto& [monomial, coefficient] : f.axial.terms()) {
      const int power = monomial.exponent(2);
      if (power == monomial.degree() && power <= f.degree) continue;
      throw Refuted(f.name() + ": the axial part is no polynomial in z of degree at most l");
    }
    by_order[f.order].push_back(&f);
    highest = std::max(highest, f.degree);
  }
  for (const auto& [order, functions] : by_order) {
    const Polynomial azimuthal = expected_azimuthal(order);
    for (const BasisFunction* f : functions) {
      if (!(f->azimuthal == azimuthal)) throw Refuted(f->name() + ": the azimuthal part is not cos or sin of m phi");
    }
    prove_order(functions, std::abs(order), highest);
  }
  return static_cast<int>(basis.size());
}

}  // namespace sh::symbolic
