#include "codegen/recipes/basis/parity_columns.hpp"

#include <stdexcept>
#include <utility>

namespace sh::codegen::recipes {
namespace {

using cln::cl_RA;
using symbolic::Surd;
using Powers = std::vector<cl_RA>;

cl_RA power_at(const Powers& powers, std::size_t i) { return i < powers.size() ? powers[i] : cl_RA(0); }

// z^2 p
Powers raised(const Powers& p) {
  Powers result{0};
  result.insert(result.end(), p.begin(), p.end());
  return result;
}

// The numbers r, s with target = r u + s v. The two lowest powers give them; all other powers check them.
std::pair<cl_RA, cl_RA> solve(const Powers& target, const Powers& u, const Powers& v) {
  const auto at = power_at;
  const cl_RA determinant = at(u, 0) * at(v, 1) - at(u, 1) * at(v, 0);
  const cl_RA r = (at(target, 0) * at(v, 1) - at(target, 1) * at(v, 0)) / determinant;
  const cl_RA s = (at(u, 0) * at(target, 1) - at(u, 1) * at(target, 0)) / determinant;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (at(target, i) != r * at(u, i) + s * at(v, i)) throw std::logic_error("parity: columns are not related so");
  }
  return {r, s};
}

}  // namespace

ParityChoices accurate_choices(int degree) {
  // The error of A_3 without the split square is too large for degree 3, but not for higher degrees.
  if (degree <= 3) return {true, 0, 0, 0};
  return {false, 2, 2, 3};
}

Squares unit_squares(Builder& build, NodeId z) {
  const NodeId one = build.constant(Surd(1), "one");
  const NodeId z2 = build.mul(z, z, "z2");
  return {z2, build.sub(one, z2, "xy2")};
}

Squares append_squares(Builder& build, const Direction& d) {
  const NodeId x2 = build.mul(d.x, d.x, "x2");
  const NodeId y2 = build.mul(d.y, d.y, "y2");
  const NodeId z2 = build.mul(d.z, d.z, "z2");
  const NodeId across = build.add(x2, y2, "xy2");
  return {z2, across, build.add(across, z2, "r2"), x2, y2};
}

ParityColumns::ParityColumns(SignedBuilder& build, NodeId z, const Squares& squares, int degree,
                             const ParityChoices& choices)
    : build_(build), z_(z), squares_(squares), degree_(degree), choices_(choices), terms_(degree + 1) {
  for (int m = degree; m >= 0; --m) {
    for (int n = 0; m + n <= degree; ++n) terms_[m].push_back(make(m, n));
  }
}

ParityColumns::Term ParityColumns::make(int m, int n) {
  const int l = m + n;
  const AxialForm form = axial_form(l, m);
  Term result{-1, form.scale, form.powers};
  if (n == 0) {
    if (m == 0) result.node = build_.constant(form.scale, indexed("k", 0, 0));
  } else if (n == 1) {
    const NodeId k = build_.constant(form.scale * Surd(form.powers[0]), indexed("k", l, m));
    result.node = build_.mul(k, z_, indexed("t", l, m));
  } else {
    if (form.odd) result.scale = form.scale / (term(m, 1).scale * Surd(term(m, 1).powers[0]));
    result.node = polynomial(result, m, n);
  }
  return result;
}

NodeId ParityColumns::polynomial(const Term& target, int m, int n) {
  const int l = m + n;
  if (n <= 3) return linear(target, l, m);
  if (n == 4) return square(target, term(m + 1, 3), l, m);
  const int source = m < choices_.rows ? m : m + 1;
  if (n % 2 != 0) return combine(target, term(source, n - 1), term(source, n - 2), l, m, false);
  if (source > m && l < degree_) return combine(target, term(source, n), term(source, n - 2), l, m, false);
  return combine(target, term(source, n - 1), term(source, n - 2), l, m, true);
}

// A constant, times x^2+y^2+z^2 off the unit sphere.
Value ParityColumns::constant_part(const Surd& value, const std::string& name) {
  const Value k = build_.fixed(value, name);
  return squares_.r2 < 0 ? k : Value{build_.mul(k.node, squares_.r2), k.negative};
}

// c1 z^2 + c0, or (c1+c0) - c1 (1-z^2); off the unit sphere (c1+c0) z^2 + c0 (x^2+y^2)
NodeId ParityColumns::linear(const Term& target, int l, int m) {
  const Surd slope = target.scale * Surd(target.powers[1]);
  const Surd start = target.scale * Surd(target.powers[0]);
  const Surd end = target.scale * Surd(target.powers[0] + target.powers[1]);
  const bool off_sphere = squares_.r2 >= 0;
  const bool across = !off_sphere && m < ((l - m) % 2 == 0 ? choices_.even_across : choices_.odd_across);
  if (across) {
    const NodeId product = build_.mul(build_.constant(slope, indexed("a", l, m)), squares_.across);
    return build_.sub(build_.constant(end, indexed("b", l, m)), product, indexed("p", l, m));
  }
  const NodeId product = build_.mul(build_.constant(off_sphere ? end : slope, indexed("a", l, m)), squares_.z2);
  Value rest = build_.fixed(start, indexed("b", l, m));
  if (off_sphere) rest = build_.times(rest, {squares_.across});
  return build_.named(build_.plus({product}, rest), indexed("p", l, m)).node;
}

// alpha e^2 + beta
NodeId ParityColumns::square(const Term& target, const Term& e, int l, int m) {
  const cl_RA ratio = target.powers[2] / (e.powers[1] * e.powers[1]);
  const Surd alpha = Surd(ratio) * target.scale / (e.scale * e.scale);
  const NodeId squared = build_.mul(build_.mul(build_.constant(alpha, indexed("a", l, m)), e.node), e.node);
  const Surd beta = target.scale * Surd(target.powers[0] - ratio * e.powers[0] * e.powers[0]);
  Value b = constant_part(beta, indexed("b", l, m));
  if (squares_.r2 >= 0) b = build_.times(b, {squares_.r2});
  return build_.named(build_.plus({squared}, b), indexed("p", l, m)).node;
}

// r u + s v, or with `lift` r z^2 u + s v
NodeId ParityColumns::combine(const Term& target, const Term& u, const Term& v, int l, int m, bool lift) {
  const auto [r, s] = solve(target.powers, lift ? raised(u.powers) : u.powers, v.powers);
  NodeId first = build_.constant(Surd(r) * target.scale / u.scale, indexed("a", l, m));
  if (lift) first = build_.mul(first, squares_.z2);
  first = build_.mul(first, u.node);
  const Value k = constant_part(Surd(s) * target.scale / v.scale, indexed("b", l, m));
  const Value second = build_.times(k, {v.node});
  return build_.named(build_.plus({first}, second), indexed("p", l, m)).node;
}

}  // namespace sh::codegen::recipes
