#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"

namespace sh::symbolic {
namespace {

void require_factor(const BasisFunction& f, const Surd& k) {
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  const cln::cl_RA mean = sphere_mean((f.axial * f.axial) * (f.azimuthal * f.azimuthal));
  require(f, !k.is_zero() && !k.is_negative(), "the factor is not positive");
  require(f, k * k * sphere_area * Surd(mean) == Surd(1), "the factor does not make the integral of the square 1");
}

// k_m / k_n of one band, and a matrix with every entry different times them.
void require_entries(int l, const Factors& factors) {
  const int size = 2 * l + 1;
  Matrix<cln::cl_RA> counting(size, size);
  for (int i = 0; i < size * size; ++i) counting(i / size, i % size) = i + 1;
  const Matrix<Surd> entries = factors.entries(l, counting);
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      const Surd ratio = factors.ratio(l, m, n);
      const bool is_quotient = ratio * factors.factor(l, n) == factors.factor(l, m);
      if (is_quotient && entries(l + m, l + n) == Surd(counting(l + m, l + n)) * ratio) continue;
      throw Refuted("l=" + std::to_string(l) + " entry (" + std::to_string(m) + ", " + std::to_string(n) +
                    ") has another factor");
    }
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

int prove_factors(const Basis& basis, const Factors& factors) {
  for (const BasisFunction& f : basis) require_factor(f, factors.factor(f.degree, f.order));
  for (int l = 0; l <= basis.back().degree; ++l) require_entries(l, factors);
  return static_cast<int>(basis.size());
}

}  // namespace sh::symbolic
