#include "codegen/recipes/basis/chebyshev_columns.hpp"

#include <algorithm>

namespace sh::codegen::recipes {

using symbolic::Surd;
using Powers = std::vector<cln::cl_RA>;

Squares chebyshev_squares(Builder& build, const Direction& d) {
  const NodeId x2 = build.mul(d.x, d.x, "x2");
  const NodeId y2 = build.mul(d.y, d.y, "y2");
  const NodeId across = build.add(x2, y2, "xy2");
  return {build.mul(d.z, d.z, "z2"), across, -1, x2, y2};
}

ChebyshevColumns::ChebyshevColumns(SignedBuilder& build, NodeId z, const Squares& squares, int degree)
    : build_(build), one_(build.constant(Surd(1), "one")), terms_(degree + 1) {
  polar_ = variable(build_.sub(squares.z2, squares.across, "u"));
  general_ = variable(build_.sub(build_.add(squares.z2, squares.z2), one_, "t"));
  for (int m = degree; m >= 0; --m) {
    for (int n = 0; m + n <= degree; ++n) terms_[m].push_back(make(m, n, z));
  }
}

ChebyshevColumns::Variable ChebyshevColumns::variable(NodeId t) {
  const NodeId square = build_.mul(build_.add(t, t), t);
  return {t, build_.sub(square, one_)};
}

NodeId ChebyshevColumns::make(int m, int n, NodeId z) {
  const int l = m + n;
  const AxialForm form = axial_form(l, m);
  if (n == 0) return m == 0 ? build_.constant(form.scale, indexed("k", 0, 0)) : -1;
  if (!form.odd) return polynomial(form.powers, form.scale, l, m);
  const AxialForm first = axial_form(m + 1, m);
  const Surd k = first.scale * Surd(first.powers[0]);
  if (n == 1) return build_.mul(build_.constant(k, indexed("k", l, m)), z, indexed("t", l, m));
  return polynomial(form.powers, form.scale / k, l, m);
}

// scale * powers[i]
Value ChebyshevColumns::constant(const Surd& scale, const Powers& powers, std::size_t i, const std::string& name) {
  if (i >= powers.size() || cln::zerop(powers[i])) return {};
  return build_.fixed(scale * Surd(powers[i]), name);
}

// scale * p(z^2), by Horner's rule in T_2.
NodeId ChebyshevColumns::polynomial(const Powers& p, const Surd& scale, int l, int m) {
  const Variable& variable = m == 0 ? polar_ : general_;
  Powers parts[2];  // of t: even and odd, in powers of t^2
  const Powers in_t = centred(p);
  for (std::size_t i = 0; i < in_t.size(); ++i) parts[i % 2].push_back(in_t[i]);
  const Powers even = centred(parts[0]);
  const Powers odd = centred(parts[1]);
  Value sum;
  for (std::size_t i = std::max(even.size(), odd.size()); i-- > 0;) {
    const std::string name = std::to_string(i);
    sum = build_.times(sum, {variable.t2});
    const Value slope = constant(scale, odd, i, indexed("a", l, m) + name);
    const Value start = constant(scale, even, i, indexed("b", l, m) + name);
    sum = build_.plus(sum, build_.plus(build_.times(slope, {variable.t}), start));
  }
  return build_.named(sum, indexed("p", l, m)).node;
}

}  // namespace sh::codegen::recipes
