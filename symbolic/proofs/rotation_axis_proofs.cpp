// Proofs about turns about the axes: about z and y, quarter turns about x, and their products.
#include <map>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/rotation_compare.hpp"

namespace sh::symbolic {
namespace {

using RationalMatrix = Matrix<cln::cl_RA>;

// A polynomial in cos, sin of an angle as a homogeneous one of degree 2l in those of the half angle (variables 0, 1).
Polynomial at_half_angle(const Polynomial& p, int degree) {
  const Polynomial c = Polynomial::variable(0);
  const Polynomial s = Polynomial::variable(1);
  const std::array<Polynomial, 2> doubled{c * c - s * s, cln::cl_RA(2) * (c * s)};
  std::map<int, Polynomial> by_degree;
  for (const auto& [monomial, coefficient] : p.terms()) by_degree[monomial.degree()].add_term(monomial, coefficient);
  Polynomial result;
  for (const auto& [part_degree, part] : by_degree) {
    result += (c * c + s * s).power(degree - part_degree) * substitute(part, doubled);
  }
  return result;
}

Matrix<Polynomial> about_axis(const QuaternionRotation& band, int axis) {
  std::array<Polynomial, 4> q{Polynomial::variable(0), Polynomial(), Polynomial(), Polynomial()};
  q[axis + 1] = Polynomial::variable(1);
  return band.entries.mapped([&](const Polynomial& p) { return substitute(p, q); });
}

}  // namespace

// Rows m and -m share q(z) with the columns that they meet, but the sum takes every column.
int prove_about_z(const std::vector<Matrix<Polynomial>>& bands) {
  const std::array<Polynomial, 5> v{Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2),
                                    Polynomial::variable(3), Polynomial::variable(4)};  // x, y, z, c, s
  const std::array<Polynomial, 2> turned{v[3] * v[0] - v[4] * v[1], v[4] * v[0] + v[3] * v[1]};
  const std::array<Polynomial, 2> circle{v[3], v[4]};
  std::map<int, Polynomial> turned_azimuthal;
  for (int l = 0; l < static_cast<int>(bands.size()); ++l) {
    for (int m = -l; m <= l; ++m) {
      const BasisFunction row = reduced_basis_function(l, m);
      Polynomial difference =
          row.axial * remembered(turned_azimuthal, m, [&] { return substitute(row.azimuthal, turned); });
      for (int n = -l; n <= l; ++n) {
        const Polynomial& entry = bands[l](l + m, l + n);
        if (entry.is_zero()) continue;
        const BasisFunction column = reduced_basis_function(l, n);
        difference -= substitute(entry, circle) * (column.axial * column.azimuthal);
      }
      if (!difference.is_zero()) throw Refuted("about z: " + row.name());
    }
  }
  return static_cast<int>(bands.size());
}

int prove_about_y(const QuaternionRotation& band, const Matrix<Polynomial>& y) {
  return require_same(band.degree, about_axis(band, 1), y, "the turn about y differs from the quaternion form");
}

int prove_wigner_form(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& by_wigner) {
  return require_same(degree, y, by_wigner, "Wigner's formula differs from the definition");
}

int prove_x90(const QuaternionRotation& band, const RationalMatrix& plus, const RationalMatrix& minus) {
  const cln::cl_RA norm = cln::expt(cln::cl_RA(2), band.degree);
  const RationalMatrix scaled =
      evaluate(band, {1, 1, 0, 0}).mapped([&](const cln::cl_RA& entry) -> cln::cl_RA { return entry / norm; });
  const auto one = RationalMatrix::identity(plus.rows(), 1);
  require_same(band.degree, plus, scaled, "differs from the quaternion form at (1,1,0,0)");
  require_same(band.degree, plus * minus, one, "+90 and -90 degrees are not inverse");
  return require_same(band.degree, plus * plus * plus * plus, one, "four quarter turns are not the identity");
}

int prove_z_x90_z(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& z, const RationalMatrix& plus,
                  const RationalMatrix& minus) {
  const auto constant = [](const cln::cl_RA& entry) { return Polynomial(entry); };
  const auto middle = z.mapped([&](const Polynomial& p) { return at_half_angle(p, degree); });
  return require_same(degree, y, minus.mapped(constant) * middle * plus.mapped(constant),
                      "Ry(beta) differs from Rx(-90) Rz(beta) Rx(90)");
}

}  // namespace sh::symbolic
