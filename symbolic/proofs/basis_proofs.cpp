#include <cstdlib>
#include <map>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

using Vector = std::array<Polynomial, 3>;

Vector point(int first) {
  return {Polynomial::variable(first), Polynomial::variable(first + 1), Polynomial::variable(first + 2)};
}

Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// "l=2 m=-1: ..."
void require(const BasisFunction& f, bool holds, const char* otherwise) {
  if (!holds) throw Refuted(f.name() + ": " + otherwise);
}

// The derivative along an axis of a sum of S_(degree, order), as such a sum of the band below.
std::map<int, cln::cl_RA> derivative(const Ladder& ladder, int degree, const std::map<int, cln::cl_RA>& sum, int axis) {
  std::map<int, cln::cl_RA> result;
  for (const auto& [order, coefficient] : sum) {
    for (const LadderTerm& term : ladder(degree, order, axis)) {
      cln::cl_RA& total = result.try_emplace(term.order, 0).first->second;
      total = total + coefficient * term.coefficient;
    }
  }
  return result;
}

Polynomial sum_of_band(const Basis& basis, int degree, const std::map<int, cln::cl_RA>& sum) {
  Polynomial result;
  for (const auto& [order, coefficient] : sum) {
    result += coefficient * basis.at(coefficient_index(degree, order)).homogeneous;
  }
  return result;
}

// xx, xy, xz, yy, yz, zz
constexpr std::array<std::array<int, 2>, 6> kHessianAxes{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

void require_gradient(const Basis& basis, const BasisFunction& f, const BasisDerivatives& d, const Ladder& ladder) {
  require(f, dot(point(0), d.gradient) == cln::cl_RA(f.degree) * f.homogeneous, "s.grad S is not l S");
  require(f, (d.hessian[0] + d.hessian[3] + d.hessian[5]).is_zero(), "the trace of the Hessian is not 0");
  std::array<std::map<int, cln::cl_RA>, 3> by_ladder;
  for (int axis = 0; axis < 3; ++axis) {
    by_ladder[axis] = derivative(ladder, f.degree, {{f.order, 1}}, axis);
    require(f, sum_of_band(basis, f.degree - 1, by_ladder[axis]) == d.gradient[axis],
            "the gradient differs from its ladder");
  }
  for (std::size_t i = 0; i < kHessianAxes.size(); ++i) {
    const auto [first, second] = kHessianAxes[i];
    const auto twice = derivative(ladder, f.degree - 1, by_ladder[first], second);
    require(f, sum_of_band(basis, f.degree - 2, twice) == d.hessian[i], "the Hessian differs from its ladder");
  }
}

// coefficient * (cosine or sine function of order a) * (axial part of order `axial`): a derivative of a reduced form.
struct ReducedTerm {
  cln::cl_RA coefficient;
  bool cosine = true;
  int a = 0;
  int axial = 0;
};

ReducedTerm derivative(const ReducedTerm& term, int axis) {
  if (axis == 2) return {term.coefficient, term.cosine, term.a, term.axial + 1};
  const bool turns = axis == 1;  // by y: C_a becomes -a S_(a-1), S_a becomes a C_(a-1)
  const int sign = turns && term.cosine ? -1 : 1;
  return {sign * term.a * term.coefficient, term.cosine != turns, term.a - 1, term.axial};
}

Polynomial value(const Basis& basis, int degree, const ReducedTerm& term) {
  if (cln::zerop(term.coefficient) || term.axial > degree || (term.a == 0 && !term.cosine)) return {};
  const int order = term.cosine ? term.a : -term.a;
  return term.coefficient *
         (basis.at(coefficient_index(degree, term.axial)).axial * basis.at(coefficient_index(degree, order)).azimuthal);
}

}  // namespace

Polynomial moved(const Polynomial& p, int first) { return substitute(p, point(first)); }

Polynomial dot_product(int first, int second) { return dot(point(first), point(second)); }

// (l+1) P_(l+1) = (2l+1) (u.v) P_l - l |u|^2 |v|^2 P_(l-1) [Bonnet]
std::vector<Polynomial> two_point_legendre(int degree) {
  const Polynomial cosine = dot_product(0, 3);
  const Polynomial squares = dot_product(0, 0) * dot_product(3, 3);
  std::vector<Polynomial> p{Polynomial(1), cosine};
  for (int l = 1; l < degree; ++l) {
    p.push_back(cln::cl_RA(1) / (l + 1) *
                (cln::cl_RA(2 * l + 1) * (cosine * p[l]) - cln::cl_RA(l) * (squares * p[l - 1])));
  }
  return p;
}

int prove_derivations_agree(const Basis& one, const Basis& other) {
  if (one.size() != other.size()) throw Refuted("the derivations have different numbers of functions");
  for (std::size_t i = 0; i < one.size(); ++i) require(one[i], one[i] == other[i], "the derivations differ");
  return static_cast<int>(one.size());
}

int prove_harmonicity(const Basis& basis) {
  for (const BasisFunction& f : basis) {
    const Polynomial& p = f.homogeneous;
    require(f, p.is_homogeneous() && p.degree() == f.degree, "not homogeneous of degree l");
    Polynomial laplacian;
    for (int axis = 0; axis < 3; ++axis) laplacian += p.derivative(axis).derivative(axis);
    require(f, laplacian.is_zero(), "the Laplacian is not 0");
  }
  return static_cast<int>(basis.size());
}

int prove_addition_theorem(const Basis& basis) {
  const int degree = basis.back().degree;
  const std::vector<Polynomial> legendre = two_point_legendre(degree);
  std::vector<Polynomial> sums(degree + 1);
  for (const BasisFunction& f : basis) {
    const Surd square = f.factor * f.factor * Surd::square_root(1, 2);
    require(f, square.is_rational(), "factor^2 pi is irrational");
    sums[f.degree] += square.rational() * (f.homogeneous * moved(f.homogeneous, 3));
  }
  for (int l = 0; l <= degree; ++l) {
    if (!(sums[l] == cln::cl_RA(2 * l + 1) / 4 * legendre[l])) throw Refuted("band " + std::to_string(l));
  }
  return degree + 1;
}

int prove_forms_agree(const Basis& basis) {
  for (const BasisFunction& f : basis) {
    const Polynomial difference = f.homogeneous - f.axial * f.azimuthal;
    require(f, reduce_on_sphere(difference).is_zero(), "the two forms differ on the unit sphere");
  }
  return static_cast<int>(basis.size());
}

std::vector<BasisDerivatives> derive_derivatives(const Basis& basis, BasisForm form) {
  std::vector<BasisDerivatives> result;
  for (const BasisFunction& f : basis) result.push_back({gradient(f, form), hessian(f, form)});
  return result;
}

int prove_gradients(const Basis& basis, const std::vector<BasisDerivatives>& homogeneous, const Ladder& ladder) {
  for (std::size_t i = 0; i < basis.size(); ++i) require_gradient(basis, basis[i], homogeneous.at(i), ladder);
  return static_cast<int>(basis.size());
}

int prove_reduced_gradients(const Basis& basis, const std::vector<BasisDerivatives>& reduced) {
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const BasisFunction& f = basis[i];
    const ReducedTerm whole{1, f.order >= 0, std::abs(f.order), std::abs(f.order)};
    for (int axis = 0; axis < 3; ++axis) {
      require(f, reduced.at(i).gradient[axis] == value(basis, f.degree, derivative(whole, axis)),
              "the gradient of the reduced form differs from the product rule");
    }
    for (std::size_t k = 0; k < kHessianAxes.size(); ++k) {
      const auto [first, second] = kHessianAxes[k];
      require(f, reduced[i].hessian[k] == value(basis, f.degree, derivative(derivative(whole, first), second)),
              "the Hessian of the reduced form differs from the product rule");
    }
  }
  return static_cast<int>(basis.size());
}

int prove_factors(const Basis& basis, const Factors& factors) {
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  for (const BasisFunction& f : basis) {
    const Surd k = factors.factor(f.degree, f.order);
    require(f, !k.is_zero() && !k.is_negative(), "the factor is not positive");
    const cln::cl_RA mean = sphere_mean((f.axial * f.axial) * (f.azimuthal * f.azimuthal));
    require(f, k * k * sphere_area * Surd(mean) == Surd(1), "the factor does not make the integral of the square 1");
    const int l = f.degree;
    Matrix<cln::cl_RA> counting(2 * l + 1, 2 * l + 1);
    for (int n = -l; n <= l; ++n) counting(l + f.order, l + n) = 2 * l + 2 + n;
    const Matrix<Surd> entries = factors.entries(l, counting);
    for (int n = -l; n <= l; ++n) {
      const Surd ratio = k / factors.factor(l, n);
      require(f, factors.ratio(l, f.order, n) == ratio, "the ratio of two factors");
      require(f, entries(l + f.order, l + n) == Surd(2 * l + 2 + n) * ratio, "an entry of a rotation");
    }
  }
  return static_cast<int>(basis.size());
}

int prove_tangential_gradients(const std::vector<BasisDerivatives>& reduced,
                               const std::vector<BasisDerivatives>& homogeneous) {
  for (std::size_t i = 0; i < reduced.size(); ++i) {
    Gradient difference = homogeneous.at(i).gradient;
    for (int axis = 0; axis < 3; ++axis) difference[axis] -= reduced[i].gradient[axis];
    for (const Polynomial& component : cross(point(0), difference)) {
      if (reduce_on_sphere(component).is_zero()) continue;
      throw Refuted("function " + std::to_string(i) + ": the tangential gradients differ on the sphere");
    }
  }
  return static_cast<int>(reduced.size());
}

}  // namespace sh::symbolic
