#include "codegen/recipes/zonal/columns.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

namespace {

// The exact coefficients of e_lm in powers of z^2, lowest power first.
std::vector<cln::cl_RA> coefficients(int l, int m) { return whole_axial_form(l, m).powers; }

}  // namespace

Pair Azimuth::power(int m) {
  const auto found = powers_.find(m);
  if (found != powers_.end()) return found->second;
  if (m % 2 != 0) return powers_[m] = next_power(build_, d_.x, d_.y, power(m - 1), m);
  const auto [c, s] = power(m / 2);
  const NodeId sum = build_.add(c, s);
  const NodeId difference = build_.sub(c, s);
  const NodeId twice = build_.add(c, c);
  const NodeId real = build_.mul(difference, sum, numbered("c", m));
  return powers_[m] = {real, build_.mul(twice, s, numbered("s", m))};
}

NodeId AxialPolynomials::at(int l, int m) {
  const auto found = made_.find({l, m});
  if (found != made_.end()) return found->second;
  const NodeId node = make(l, m);
  made_[{l, m}] = node;
  return node;
}

NodeId AxialPolynomials::square() {
  if (square_ < 0) square_ = build_.mul(z_, z_, "z2");
  return square_;
}

NodeId AxialPolynomials::doubled_angle() {
  if (doubled_angle_ < 0) {
    const NodeId one = build_.constant(Surd(1), "one");
    const NodeId twice = build_.add(square(), square());
    doubled_angle_ = build_.sub(twice, one, "t");
  }
  return doubled_angle_;
}

NodeId AxialPolynomials::make(int l, int m) {
  const int n = l - m;
  if (n <= 1) return build_.constant(scale_(l, m) * Surd(coefficients(l, m)[0]), indexed("k", l, m));
  if (n <= 3 || wanted_ == Wanted::kFew) return horner(l, m);
  return n == 4 ? completed_square(l, m) : recurrence(l, m);
}

NodeId AxialPolynomials::horner(int l, int m) {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  const std::vector<cln::cl_RA> powers = composed(coefficients(l, m), half, half);  // z^2 = (1 + t) / 2
  NodeId value = -1;
  for (int k = static_cast<int>(powers.size()) - 1; k >= 0; --k) {
    const Surd coefficient = scale_(l, m) * Surd(powers[k]);
    const std::string name = indexed(k == 0 ? "b" : "a", l, m);
    if (value < 0) {
      value = build_.constant(coefficient, name);
      continue;
    }
    const Value a = build_.fixed(coefficient, name);
    value = build_.mul(value, doubled_angle());
    if (!coefficient.is_zero()) value = build_.plus({value}, a).node;
  }
  build_.name(value, indexed("e", l, m));
  return value;
}

NodeId AxialPolynomials::completed_square(int l, int m) {
  const std::vector<cln::cl_RA> q = coefficients(l, m);
  const Surd inner = scale_(l, m + 1) * Surd(coefficients(l, m + 1)[1]);
  const NodeId a = build_.constant(scale_(l, m) * Surd(q[2]) / (inner * inner), indexed("a", l, m));
  const NodeId derivative = at(l, m + 1);
  const NodeId squared = build_.mul(build_.mul(a, derivative), derivative);
  const Surd least = scale_(l, m) * Surd(q[0] - q[1] * q[1] / (4 * q[2]));
  const Value b = build_.fixed(least, indexed("b", l, m));
  return build_.named(build_.plus({squared}, b), indexed("e", l, m)).node;
}

NodeId AxialPolynomials::recurrence(int l, int m) {
  const int n = l - m;
  const auto factor = [&](int p, int lower) { return Surd(cln::cl_RA(p) / n) * (scale_(l, m) / scale_(lower, m)); };
  NodeId last = at(l - 1, m);
  if (n % 2 == 0) last = build_.mul(square(), last);
  const NodeId before = at(l - 2, m);
  const NodeId a = build_.constant(factor(2 * l - 1, l - 1), indexed("a", l, m));
  const NodeId b = build_.constant(factor(l + m - 1, l - 2), indexed("b", l, m));
  const NodeId high = build_.mul(a, last);
  return build_.sub(high, build_.mul(b, before), indexed("e", l, m));
}

}  // namespace sh::codegen::recipes
