// The definition of the rotation matrices, by GiNaC: D_l(R) from Y_l(R v) = D_l(R) Y_l(v) on the null cone v.v = 0.
//
// Input: degree, quaternion or axis. Output: rational parts T_mn of rotation.hpp. On the null cone r^2 drops out of
// S_lm, only the leading term of q(z) stays, and the S_lm of one degree are still independent there: a harmonic
// polynomial that vanishes on it is divisible by r^2, so zero. The null vector of the spinor (s, t) is
//     x - iy = s^2,   x + iy = -t^2,   z = s t,   so   S_lm + i S_l,-m = lambda_lm (-1)^m s^(l-m) t^(l+m)   (m >= 0),
// and M(q) turns it into the null vector of the spinor that the Cayley-Klein parameters of q make of (s, t)
//     (c s + d t, a t + b s),   a = w + iz, b = ix - y, c = w - iz, d = ix + y         [Wigner59] ch. 15, [Hobson31].
// Everything here sets t = 1.
#include "symbolic/rotation/rotation.hpp"

#include <cstdlib>
#include <map>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/number/from_ginac.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

// The leading coefficient of d^a P_l / dz^a.
const GiNaC::numeric& leading(int l, int a) {
  static std::map<std::pair<int, int>, GiNaC::numeric> known;
  return remembered(known, {l, a}, [&] {
    return GiNaC::numeric(reduced_basis_function(l, a).axial.coefficient({0, 0, l - a}));
  });
}

ex sign(int power) { return power % 2 == 0 ? 1 : -1; }

// S_lm on the null cone.
ex solid_harmonic(int l, int m, const symbol& s) {
  const int a = std::abs(m);
  const ex pair = m < 0 ? (sign(a) - GiNaC::pow(s, 2 * a)) / (2 * GiNaC::I) : (sign(a) + GiNaC::pow(s, 2 * a)) / 2;
  return leading(l, a) * GiNaC::pow(s, l - a) * pair;
}

// The numbers T_-l .. T_l with sum T_n S_ln = p on the null cone: p holds lambda/2 (T_n + i T_-n) s^(l+n) and
// (-1)^n lambda/2 (T_n - i T_-n) s^(l-n).
std::vector<ex> along_band(int l, const ex& p, const symbol& s) {
  std::vector<ex> t(2 * l + 1);
  const ex expanded = p.expand();
  t[l] = expanded.coeff(s, l) / leading(l, 0);
  for (int n = 1; n <= l; ++n) {
    const ex up = expanded.coeff(s, l + n) / leading(l, n);
    const ex down = sign(n) * expanded.coeff(s, l - n) / leading(l, n);
    t[l + n] = up + down;
    t[l - n] = GiNaC::I * (down - up);
  }
  return t;
}

// T of M(q), the entries polynomials in `variables`.
Matrix<Polynomial> turned_band(int l, const Quaternion<ex>& q, const std::vector<symbol>& variables) {
  const symbol s("s");
  const symbol a("a");
  const symbol b("b");
  const symbol c("c");
  const symbol d("d");
  const GiNaC::exmap parameters{{a, q[0] + GiNaC::I * q[3]},
                                {b, GiNaC::I * q[1] - q[2]},
                                {c, q[0] - GiNaC::I * q[3]},
                                {d, GiNaC::I * q[1] + q[2]}};
  Matrix<Polynomial> t(2 * l + 1, 2 * l + 1);
  for (int m = 0; m <= l; ++m) {
    const ex row = leading(l, m) * sign(m) * GiNaC::pow(c * s + d, l - m) * GiNaC::pow(a + b * s, l + m);
    const std::vector<ex> entries = along_band(l, row, s);
    for (int n = 0; n <= 2 * l; ++n) {
      ComplexPolynomial entry = complex_from_ginac(entries[n].subs(parameters), variables);
      t(l + m, n) = std::move(entry.re);
      if (m > 0) t(l - m, n) = std::move(entry.im);
    }
  }
  return t;
}

const char* const kGrowth = "exact entries grow with the degree";

}  // namespace

const QuaternionRotation& quaternion_rotation(int degree) {
  require_degree("quaternion rotation", degree, kMaxQuaternionDegree, kGrowth);
  static std::map<int, QuaternionRotation> known;
  return remembered(known, degree, [degree] {
    const std::vector<symbol> q{symbol("w"), symbol("x"), symbol("y"), symbol("z")};
    return QuaternionRotation{degree, turned_band(degree, {q[0], q[1], q[2], q[3]}, q)};
  });
}

Matrix<Polynomial> rotation_about_z(int degree) {
  require_degree("axis rotation", degree, kMaxAxisDegree, kGrowth);
  Matrix<Polynomial> d(2 * degree + 1, 2 * degree + 1);
  for (int m = -degree; m <= degree; ++m) {  // Re and Im of (c + is)^|m|, c and s in place of x and y
    d(degree + m, degree + m) = reduced_basis_function(degree, std::abs(m)).azimuthal;
    if (m == 0) continue;
    const Polynomial sine = reduced_basis_function(degree, -std::abs(m)).azimuthal;
    d(degree + m, degree - m) = cln::cl_RA(m > 0 ? -1 : 1) * sine;
  }
  return d;
}

const Matrix<Polynomial>& rotation_about_y(int degree) {
  require_degree("axis rotation", degree, kMaxAxisDegree, kGrowth);
  static std::map<int, Matrix<Polynomial>> known;
  return remembered(known, degree, [degree] {
    const std::vector<symbol> half{symbol("c"), symbol("s")};
    return turned_band(degree, {half[0], 0, half[1], 0}, half);
  });
}

const Matrix<cln::cl_RA>& rotation_x90(int degree, bool positive) {
  require_degree("axis rotation", degree, kMaxAxisDegree, kGrowth);
  static std::map<std::pair<int, bool>, Matrix<cln::cl_RA>> known;
  return remembered(known, {degree, positive}, [&] {
    const cln::cl_I size = cln::ash(cln::cl_I(1), degree);  // |q|^(2l)
    return turned_band(degree, {1, positive ? 1 : -1, 0, 0}, {}).mapped([&](const Polynomial& entry) -> cln::cl_RA {
      return entry.coefficient({}) / size;
    });
  });
}

const std::vector<std::vector<Coupling>>& band_couplings(int degree) {
  static std::map<int, std::vector<std::vector<Coupling>>> known;
  return remembered(known, degree, [degree] {
    std::vector<std::vector<Coupling>> result(2 * degree + 1);
    const symbol s("s");
    const std::array<ex, 3> v{(GiNaC::pow(s, 2) - 1) / 2, GiNaC::I * (GiNaC::pow(s, 2) + 1) / 2, s};
    for (int c = 0; c < degree; ++c) {
      for (int axis = 0; axis < 3; ++axis) {
        for (int below = c; below >= -c; below -= std::max(2 * c, 1)) {  // the cosine, then the sine function
          const ex product = v[axis] * solid_harmonic(degree - 1, below, s);
          const std::vector<ex> g = along_band(degree, product, s);
          for (int above = -degree; above <= degree; ++above) {
            const cln::cl_RA weight = rational_from_ginac(g[degree + above]) * squared_factor(degree - 1, below) /
                                      squared_factor(degree, above);
            if (!cln::zerop(weight)) result[degree + above].push_back({axis, below, weight});
          }
        }
      }
    }
    return result;
  });
}

cln::cl_RA column_scale(int degree, int column) {
  const int a = std::abs(column);
  const cln::cl_RA inverse_g = a == degree ? cln::cl_RA(2 * degree - 1) : cln::cl_RA(2 * degree - 1) / (degree - a);
  return squared_factor(degree, a) / squared_factor(degree - 1, a == degree ? a - 1 : a) * inverse_g;
}

Matrix<Polynomial> quaternion_matrix() {
  return matrix_from_quaternion<Polynomial>(
      {Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2), Polynomial::variable(3)});
}

Matrix<cln::cl_RA> evaluate(const QuaternionRotation& rotation, const std::array<cln::cl_RA, 4>& q) {
  return rotation.entries.mapped([&](const Polynomial& entry) { return entry.evaluate(q); });
}

Matrix<Surd> surd_entries(int degree, const Matrix<cln::cl_RA>& rational) {
  Matrix<Surd> result(rational.rows(), rational.columns());
  for (int i = 0; i < rational.rows(); ++i) {
    for (int j = 0; j < rational.columns(); ++j) {
      result(i, j) = factor_ratio(degree, i - degree, j - degree) * Surd(rational(i, j));
    }
  }
  return result;
}

}  // namespace sh::symbolic
