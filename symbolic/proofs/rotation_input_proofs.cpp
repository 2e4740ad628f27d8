// Proofs about the ways to give a rotation: Euler orders, axis and angle, and the ZYZ angles read from a matrix.
#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

using PolynomialMatrix = Matrix<Polynomial>;

// c_i, s_i of half angle i in variables 2i, 2i+1, and the norms c_i^2 + s_i^2, which are 1 on the circle.
CosSin<Polynomial> half(int i) { return {Polynomial::variable(2 * i), Polynomial::variable(2 * i + 1)}; }
Polynomial circle(const CosSin<Polynomial>& h) { return h.cosine * h.cosine + h.sine * h.sine; }
CosSin<Polynomial> doubled(const CosSin<Polynomial>& h) {
  return {h.cosine * h.cosine - h.sine * h.sine, cln::cl_RA(2) * (h.cosine * h.sine)};
}

// The turn about one axis by twice the half angle, times c^2 + s^2.
PolynomialMatrix full_turn(int axis, const CosSin<Polynomial>& h) {
  return matrix_about_axis(axis, doubled(h), circle(h));
}

void require_euler_order(std::string_view order, const EulerFormula& formula) {
  const std::array<CosSin<Polynomial>, 3> halves{half(0), half(1), half(2)};
  const auto axes = euler_axes(order);
  std::vector<PolynomialMatrix> turns;
  for (int i = 0; i < 3; ++i) turns.push_back(full_turn(axes[i], halves[i]));
  const auto intrinsic = matrix_from_quaternion(formula(order, EulerFrame::kIntrinsic, halves));
  const auto extrinsic = matrix_from_quaternion(formula(order, EulerFrame::kExtrinsic, halves));
  if (!(intrinsic == turns[0] * turns[1] * turns[2]) || !(extrinsic == turns[2] * turns[1] * turns[0])) {
    throw Refuted("Euler order " + std::string(order));
  }
}

// f (variable 4) squared is `square`: the normal form of p in which f has degree at most 1.
Polynomial reduce_root(const Polynomial& p, const Polynomial& square) {
  const std::vector<GiNaC::symbol> v(5);
  const std::vector<GiNaC::ex> values(v.begin(), v.end());
  return from_ginac(GiNaC::rem(to_ginac(p, values).expand(), v[4] * v[4] - to_ginac(square, values).expand(), v[4]), v);
}

// Rz(alpha) Ry(beta) Rz(gamma) with every factor scaled to stay polynomial: alpha by f, beta by n, gamma by f n.
PolynomialMatrix scaled_product(const ZyzAngles<Polynomial>& angles, const Polynomial& f, const Polynomial& n) {
  return matrix_about_axis(2, angles.alpha, f) * matrix_about_axis(1, angles.beta, n) *
         matrix_about_axis(2, angles.gamma, f * n);
}

// h != 0: with M = n R, n = |q|^2, f = n sqrt(h): the product of the scaled factors is f^2 n M.
bool generic_case(const ZyzFormula& formula, const PolynomialMatrix& m, const Polynomial& n) {
  const Polynomial f = Polynomial::variable(4);
  const Polynomial square = m(0, 2) * m(0, 2) + m(1, 2) * m(1, 2);
  const ZyzAngles<Polynomial> angles = formula(m, {m(0, 2), m(1, 2)}, f);
  const PolynomialMatrix product = scaled_product(angles, f, n);
  const auto reduced = product.mapped([&](const Polynomial& entry) { return reduce_root(entry, square); });
  if (!(reduced == m.mapped([&](const Polynomial& entry) { return n * square * entry; }))) return false;
  return circle(angles.gamma) == n * n * square;  // gamma is a point of the circle
}

// h = 0: q = (w, 0, 0, z) or (0, x, y, 0); alpha = (1, 0) and sin beta = 0, scaled by f = n: the product is n^3 M.
bool pole_case(const ZyzFormula& formula, const PolynomialMatrix& m, const Polynomial& n) {
  const ZyzAngles<Polynomial> angles = formula(m, {n, Polynomial()}, Polynomial());
  return scaled_product(angles, n, n) == m.mapped([&](const Polynomial& entry) { return n.power(3) * entry; });
}

}  // namespace

int prove_zyz_angles(const ZyzFormula& formula) {
  const PolynomialMatrix m = quaternion_matrix();
  Polynomial n;
  for (int i = 0; i < 4; ++i) n += Polynomial::variable(i).power(2);
  if (!generic_case(formula, m, n)) throw Refuted("the angles do not give R back where sin(beta) is not 0");
  const Polynomial u = Polynomial::variable(0);
  const Polynomial v = Polynomial::variable(1);
  const Polynomial none;
  const std::vector<std::array<Polynomial, 4>> poles{{u, none, none, v}, {none, u, v, none}};
  for (const auto& q : poles) {
    const auto at_pole = m.mapped([&](const Polynomial& entry) { return substitute(entry, q); });
    if (!pole_case(formula, at_pole, substitute(n, q))) throw Refuted("the angles do not give R back at a pole");
  }
  return 3;
}

int prove_euler_orders(const EulerFormula& formula) {
  for (const std::string_view order : kEulerOrders) require_euler_order(order, formula);
  return 2 * static_cast<int>(kEulerOrders.size());
}

// The quaternion (c, s u) has the matrix (c^2 - s^2 |u|^2) + 2 s^2 u u^T + 2 c s [u]; Rodrigues' formula at
// cosine = c^2 - s^2 |u|^2 and one = cosine + 2 s^2 (which is 1 where |u| = 1) must be the same polynomial.
int prove_axis_angle(const AxisAngleFormula& formula) {
  const std::array<Polynomial, 3> axis{Polynomial::variable(2), Polynomial::variable(3), Polynomial::variable(4)};
  const CosSin<Polynomial> h = half(0);
  const Polynomial length2 = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  const Polynomial cosine = h.cosine * h.cosine - length2 * h.sine * h.sine;
  const Polynomial one = cosine + cln::cl_RA(2) * (h.sine * h.sine);
  const auto rodrigues = formula(axis, {cosine, cln::cl_RA(2) * (h.cosine * h.sine)}, one);
  if (!(rodrigues == matrix_from_quaternion(quaternion_from_axis_angle(axis, h)))) {
    throw Refuted("Rodrigues' formula differs from the quaternion's matrix");
  }
  return 1;
}

}  // namespace sh::symbolic
