#include "symbolic/basis/basis_derivatives.hpp"

#include <cstdlib>

namespace sh::symbolic {
namespace {

// x and y derivatives of the cosine (sign = 1) or sine function of order a >= 1. From (d/dx -+ i d/dy): one lowers the
// order with factor (l+a)(l+a-1), the other raises it with factor -1.
std::vector<LadderTerm> turn_order(int degree, int order, int axis) {
  const int a = std::abs(order);
  const cln::cl_RA down = cln::cl_RA((degree + a) * (degree + a - 1)) / 2;
  const cln::cl_RA up = cln::cl_RA(1) / 2;
  const bool cosine = order > 0;
  if (axis == 0) {
    const int kind = cosine ? 1 : -1;
    return {{kind * (a - 1), down}, {kind * (a + 1), -up}};
  }
  const int kind = cosine ? -1 : 1;  // d/dy changes cosine and sine
  return {{kind * (a - 1), cosine ? -down : down}, {kind * (a + 1), cosine ? -up : up}};
}

bool vanishes(int degree, int order, int axis, const LadderTerm& term) {
  if (std::abs(term.order) > degree - 1) return true;
  const bool is_sine = axis == 0 ? order < 0 : order > 0;
  return term.order == 0 && is_sine && axis != 2;  // the sine function of order 0 is zero
}

}  // namespace

Polynomial form_polynomial(const BasisFunction& f, BasisForm form) {
  return form == BasisForm::kReduced ? f.axial * f.azimuthal : f.homogeneous;
}

Gradient gradient(const BasisFunction& f, BasisForm form) {
  const Polynomial p = form_polynomial(f, form);
  return {p.derivative(0), p.derivative(1), p.derivative(2)};
}

Hessian hessian(const BasisFunction& f, BasisForm form) {
  const Gradient g = gradient(f, form);
  return {g[0].derivative(0), g[0].derivative(1), g[0].derivative(2),
          g[1].derivative(1), g[1].derivative(2), g[2].derivative(2)};
}

std::vector<LadderTerm> gradient_ladder(int degree, int order, int axis) {
  require_basis_index(degree, order);
  std::vector<LadderTerm> terms;
  if (axis == 2) {
    terms = {{order, cln::cl_RA(degree + std::abs(order))}};
  } else if (order == 0) {
    terms = {{axis == 0 ? 1 : -1, cln::cl_RA(-1)}};
  } else {
    terms = turn_order(degree, order, axis);
  }
  std::erase_if(terms, [&](const LadderTerm& term) { return vanishes(degree, order, axis, term); });
  return terms;
}

}  // namespace sh::symbolic
