#include "symbolic/proofs/basis_proofs.hpp"

#include <stdexcept>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial_calculus.hpp"

namespace sh::symbolic {
namespace {

template <class Function>
Basis derive(int degree, Function function) {
  require_basis_index(degree, 0);
  Basis basis;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) basis.push_back(function(l, m));
  }
  return basis;
}

std::string count_of(std::size_t functions) { return std::to_string(functions) + " functions"; }

std::array<Polynomial, 3> cross_with_direction(const Gradient& g) {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  return {y * g[2] - z * g[1], z * g[0] - x * g[2], x * g[1] - y * g[0]};
}

// "" when every identity holds for one function.
std::string gradient_error(const Basis& basis, const BasisFunction& f, const BasisDerivatives& d) {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  const auto& [gx, gy, gz] = d.gradient;
  const auto& [xx, xy, xz, yy, yz, zz] = d.hessian;
  if (!(x * gx + y * gy + z * gz == cln::cl_RA(f.degree) * f.homogeneous)) return "s.grad S is not l S";
  const cln::cl_RA less = f.degree - 1;
  if (!(x * xx + y * xy + z * xz == less * gx) || !(x * xy + y * yy + z * yz == less * gy) ||
      !(x * xz + y * yz + z * zz == less * gz)) {
    return "H s is not (l-1) grad S";
  }
  if (!(xx + yy + zz).is_zero()) return "the trace of the Hessian is not 0";
  for (int axis = 0; axis < 3; ++axis) {
    Polynomial ladder;
    for (const LadderTerm& term : gradient_ladder(f.degree, f.order, axis)) {
      ladder += term.coefficient * basis[coefficient_index(f.degree - 1, term.order)].homogeneous;
    }
    if (!(ladder == d.gradient[axis])) return "the gradient differs from its ladder";
  }
  return "";
}

}  // namespace

Basis derive_basis(int degree) { return derive(degree, basis_function); }
Basis derive_basis_by_recurrence(int degree) { return derive(degree, basis_function_by_recurrence); }
Basis derive_reduced_basis(int degree) { return derive(degree, reduced_basis_function); }

Polynomial moved(const Polynomial& p, int first) {
  const std::array<Polynomial, 3> point{Polynomial::variable(first), Polynomial::variable(first + 1),
                                        Polynomial::variable(first + 2)};
  return substitute(p, point);
}

Polynomial dot_product(int first, int second) {
  Polynomial sum;
  for (int i = 0; i < 3; ++i) sum += Polynomial::variable(first + i) * Polynomial::variable(second + i);
  return sum;
}

// (l+1) P_(l+1) = (2l+1) (u.v) P_l - l |u|^2 |v|^2 P_(l-1) [Bonnet]
std::vector<Polynomial> two_point_legendre(int degree) {
  const Polynomial cosine = dot_product(0, 3);
  const Polynomial squares = dot_product(0, 0) * dot_product(3, 3);
  std::vector<Polynomial> p{Polynomial(1), cosine};
  for (int l = 1; l < degree; ++l) {
    const auto at = static_cast<std::size_t>(l);
    p.push_back(cln::cl_RA(1) / (l + 1) *
                (cln::cl_RA(2 * l + 1) * (cosine * p[at]) - cln::cl_RA(l) * (squares * p[at - 1])));
  }
  return p;
}

std::string name_of(const BasisFunction& f) {
  return "l=" + std::to_string(f.degree) + " m=" + std::to_string(f.order);
}

ProofResult prove_harmonicity(const Basis& basis) {
  for (const BasisFunction& f : basis) {
    const Polynomial& p = f.homogeneous;
    if (!p.is_homogeneous() || p.degree() != f.degree) return refuted(name_of(f) + ": not homogeneous of degree l");
    Polynomial laplacian;
    for (int axis = 0; axis < 3; ++axis) laplacian += p.derivative(axis).derivative(axis);
    if (!laplacian.is_zero()) return refuted(name_of(f) + ": the Laplacian is not 0");
  }
  return proved(count_of(basis.size()));
}

ProofResult prove_addition_theorem(const Basis& basis) {
  const int degree = basis.back().degree;
  const std::vector<Polynomial> legendre = two_point_legendre(degree);
  std::vector<Polynomial> sums(static_cast<std::size_t>(degree) + 1);
  for (const BasisFunction& f : basis) {
    const Surd square = f.factor * f.factor;  // rational / pi
    if (square.pi_half_power() != -2 || square.radicand() != 1)
      return refuted(name_of(f) + ": factor^2 pi is irrational");
    sums[f.degree] += square.rational() * (f.homogeneous * moved(f.homogeneous, 3));
  }
  for (int l = 0; l <= degree; ++l) {
    const auto at = static_cast<std::size_t>(l);
    if (!(sums[at] == cln::cl_RA(2 * l + 1) / 4 * legendre[at])) return refuted("band " + std::to_string(l));
  }
  return proved(std::to_string(degree + 1) + " bands");
}

ProofResult prove_forms_agree(const Basis& basis) {
  for (const BasisFunction& f : basis) {
    if (!reduce_on_sphere(f.homogeneous - f.axial * f.azimuthal).is_zero()) {
      return refuted(name_of(f) + ": the two forms differ on the unit sphere");
    }
  }
  return proved(count_of(basis.size()));
}

ProofResult prove_derivations_agree(const Basis& one, const Basis& other) {
  if (one.size() != other.size()) return refuted("the derivations have different numbers of functions");
  for (std::size_t i = 0; i < one.size(); ++i) {
    const BasisFunction& a = one[i];
    const BasisFunction& b = other[i];
    const bool same = a.degree == b.degree && a.order == b.order && a.factor == b.factor && a.axial == b.axial &&
                      a.azimuthal == b.azimuthal && a.homogeneous == b.homogeneous;
    if (!same) return refuted(name_of(a) + ": the derivations differ");
  }
  return proved(count_of(one.size()));
}

std::vector<BasisDerivatives> derive_derivatives(const Basis& basis, BasisForm form) {
  std::vector<BasisDerivatives> result;
  for (const BasisFunction& f : basis) result.push_back({gradient(f, form), hessian(f, form)});
  return result;
}

ProofResult prove_gradients(const Basis& basis, const std::vector<BasisDerivatives>& homogeneous) {
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const std::string error = gradient_error(basis, basis[i], homogeneous.at(i));
    if (!error.empty()) return refuted(name_of(basis[i]) + ": " + error);
  }
  return proved(count_of(basis.size()));
}

ProofResult prove_tangential_gradients(const std::vector<BasisDerivatives>& reduced,
                                       const std::vector<BasisDerivatives>& homogeneous) {
  for (std::size_t i = 0; i < reduced.size(); ++i) {
    Gradient difference = homogeneous.at(i).gradient;
    for (std::size_t axis = 0; axis < 3; ++axis) difference[axis] -= reduced[i].gradient[axis];
    for (const Polynomial& component : cross_with_direction(difference)) {
      if (!reduce_on_sphere(component).is_zero()) {
        return refuted("function " + std::to_string(i) + ": the tangential gradients differ on the sphere");
      }
    }
  }
  return proved(count_of(reduced.size()));
}

std::vector<Proof> basis_proofs() {
  const std::string slow = "exact integrals and expansions beyond take minutes";
  const std::string basis_limit = "the basis is derived to degree 50";
  return {
      {"basis-derivations",
       "GiNaC's definition of Y_lm (Rodrigues' formula) = recurrence over CLN rationals, factors included",
       "two derivations compared term by term", 20, kMaxBasisDegree, basis_limit,
       [](int degree) { return prove_derivations_agree(derive_basis(degree), derive_basis_by_recurrence(degree)); }},
      {"orthonormality", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "exact integration of every pair, monomial by monomial", 20, 20, slow,
       [](int degree) { return prove_orthonormality(derive_basis(degree)); }},
      {"orthonormality-1d", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "reduced forms: orthogonal azimuthal parts, exact integrals in z", kMaxBasisDegree, kMaxBasisDegree, basis_limit,
       [](int degree) { return prove_orthonormality_by_reduction(derive_reduced_basis(degree)); }},
      {"harmonicity", "the homogeneous form has degree l and Laplacian 0", "exact differentiation", 10, kMaxBasisDegree,
       basis_limit, [](int degree) { return prove_harmonicity(derive_basis(degree)); }},
      {"addition-theorem", "sum_m Y_lm(u) Y_lm(v) = (2l+1)/(4 pi) |u|^l |v|^l P_l(u.v/|u||v|)",
       "polynomial identity in u and v", 10, 20, slow,
       [](int degree) { return prove_addition_theorem(derive_basis(degree)); }},
      {"forms-agree", "reduced form = homogeneous form on the unit sphere", "normal form modulo x^2+y^2+z^2 = 1", 10,
       kMaxBasisDegree, basis_limit, [](int degree) { return prove_forms_agree(derive_basis(degree)); }},
      {"gradients", "s.grad S = l S, H s = (l-1) grad S, trace H = 0, grad S = its ladder to band l-1",
       "polynomial identities", 10, kMaxBasisDegree, basis_limit,
       [](int degree) {
         const Basis basis = derive_basis(degree);
         return prove_gradients(basis, derive_derivatives(basis, BasisForm::kHomogeneous));
       }},
      {"tangential-gradients", "s x grad(reduced) = s x grad(homogeneous) on the unit sphere",
       "normal form modulo x^2+y^2+z^2 = 1", 10, 20, slow,
       [](int degree) {
         const Basis basis = derive_basis(degree);
         return prove_tangential_gradients(derive_derivatives(basis, BasisForm::kReduced),
                                           derive_derivatives(basis, BasisForm::kHomogeneous));
       }},
  };
}

}  // namespace sh::symbolic
