#include "codegen/recipes/basis/sphere.hpp"

#include <cln/integer.h>

#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

Surd sectoral_factor(int m) {
  const cln::cl_I odd = m == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(2 * m - 1));
  const cln::cl_RA square =
      cln::cl_RA((m == 0 ? 1 : 2) * (2 * m + 1)) / (4 * cln::factorial(static_cast<unsigned>(2 * m)));
  return Surd(odd) * Surd::square_root(square, -1);
}

Surd upper_factor(int l, int m) { return Surd::square_root(cln::cl_RA(4 * l * l - 1) / (l * l - m * m)); }

Surd lower_factor(int l, int m) { return upper_factor(l, m) / upper_factor(l - 1, m); }

AxialForm whole_axial_form(int l, int m) {
  const symbolic::BasisFunction f = symbolic::reduced_basis_function(l, m);
  AxialForm form{f.factor, {}, (l - m) % 2 != 0};
  form.powers.assign((l - m) / 2 + 1, 0);
  for (const auto& [monomial, coefficient] : f.axial.terms()) {
    form.powers.at(monomial.exponent(2) / 2) = coefficient;
  }
  return form;
}

AxialForm axial_form(int l, int m) {
  AxialForm form = whole_axial_form(l, m);
  if (m > 0) form.scale = form.scale / sectoral_factor(m);
  return form;
}

std::vector<cln::cl_RA> composed(const std::vector<cln::cl_RA>& p, const cln::cl_RA& constant,
                                 const cln::cl_RA& slope) {
  std::vector<cln::cl_RA> result;
  for (auto coefficient = p.rbegin(); coefficient != p.rend(); ++coefficient) {
    std::vector<cln::cl_RA> next(result.size() + 1, 0);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i] = next[i] + constant * result[i];
      next[i + 1] = slope * result[i];
    }
    next[0] = next[0] + *coefficient;
    result = std::move(next);
  }
  while (result.size() > 1 && cln::zerop(result.back())) result.pop_back();
  return result;
}

std::vector<cln::cl_RA> centred(const std::vector<cln::cl_RA>& p) {
  return composed(p, cln::cl_RA(1) / 2, cln::cl_RA(1) / 2);
}

std::vector<NodeId> append_column(Builder& build, const Recurrence& recurrence, NodeId z, NodeId start, int degree,
                                  int m, NodeId r2) {
  std::vector<NodeId> p{start};
  for (int l = m + 1; l <= degree; ++l) {
    const NodeId raised = build.mul(build.mul(build.constant(recurrence.a(l, m), indexed("a", l, m)), z), p.back());
    if (l == m + 1) {
      p.push_back(raised);
    } else {
      NodeId b = build.constant(recurrence.b(l, m), indexed("b", l, m));
      if (r2 >= 0) b = build.mul(b, r2);
      p.push_back(build.sub(raised, build.mul(b, p[l - m - 2])));
    }
    build.name(p.back(), indexed("p", l, m));
  }
  return p;
}

Pair next_power(Builder& build, NodeId x, NodeId y, const Pair& last, int m) {
  // Each statement has only one call, because the order of nodes must not depend on the compiler.
  const NodeId xc = build.mul(x, last.cosine);
  const NodeId ys = build.mul(y, last.sine);
  const NodeId cosine = build.sub(xc, ys, numbered("c", m));
  const NodeId xs = build.mul(x, last.sine);
  const NodeId yc = build.mul(y, last.cosine);
  return {cosine, build.add(xs, yc, numbered("s", m))};
}

NodeId plus_scaled(Builder& build, NodeId sum, const Surd& k, NodeId a, const std::string& name) {
  const bool minus = sum >= 0 && k.is_negative();
  const NodeId term = build.mul(build.constant(minus ? -k : k, name), a);
  if (sum < 0) return term;
  return minus ? build.sub(sum, term) : build.add(sum, term);
}

void describe_basis(Kernel& kernel, int degree) {
  kernel.title = degree == 0
                     ? "The real spherical harmonic of degree 0"
                     : "Real spherical harmonics of degree 0 to " + std::to_string(degree) + " in one direction";
  kernel.domain = "|d| = 1 for d = (x, y, z); z is the polar axis";
  kernel.result = "Y_lm(d) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = with_direction({});
  kernel.results = {array(Role::kBasisValues, "out", degree)};
  label_coefficients(kernel, degree);
}

}  // namespace sh::codegen::recipes
