// Gradients and Hessians of both forms of the basis.
#include <cstdlib>
#include <map>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"

namespace sh::symbolic {
namespace {

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
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
