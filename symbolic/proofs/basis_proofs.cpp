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

Polynomial ladder(const Basis& basis, const BasisFunction& f, int axis) {
  Polynomial sum;
  for (const LadderTerm& term : gradient_ladder(f.degree, f.order, axis)) {
    sum += term.coefficient * basis[coefficient_index(f.degree - 1, term.order)].homogeneous;
  }
  return sum;
}

void require_gradient(const Basis& basis, const BasisFunction& f, const BasisDerivatives& d) {
  const Vector s = point(0);
  const cln::cl_RA l = f.degree;
  const auto& [xx, xy, xz, yy, yz, zz] = d.hessian;
  const std::array<Vector, 3> rows{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  require(f, dot(s, d.gradient) == l * f.homogeneous, "s.grad S is not l S");
  require(f, (xx + yy + zz).is_zero(), "the trace of the Hessian is not 0");
  for (int axis = 0; axis < 3; ++axis) {
    require(f, dot(s, rows[axis]) == (l - 1) * d.gradient[axis], "H s is not (l-1) grad S");
    require(f, ladder(basis, f, axis) == d.gradient[axis], "the gradient differs from its ladder");
  }
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

int prove_gradients(const Basis& basis, const std::vector<BasisDerivatives>& homogeneous) {
  for (std::size_t i = 0; i < basis.size(); ++i) require_gradient(basis, basis[i], homogeneous.at(i));
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
