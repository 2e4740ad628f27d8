// Tables of rotation matrices. A coefficient vector turns as c' = D c; entries of D with |row| > l or |column| > l are
// left out, and so are the zeros of sparse matrices.
//
// In another convention D' = C D C^-1 with the band matrices C of symbolic/convention/convention_map.hpp. The formula holds in the
// convention's own coordinates, so its axes do not enter.
#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "symbolic/typeset/typeset.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::symbolic {
namespace {

// Entry (row, column) of C D C^-1, D_pq = (k_p / k_q) T_pq.
std::vector<FormulaTerm> entry_terms(const ConventionMap& map, int l, const Matrix<Polynomial>& rational, int row,
                                     int column, const std::vector<std::string>& names) {
  const Matrix<RadicalSum>& forward = map.forward[l];
  const Matrix<RadicalSum>& backward = map.backward[l];
  PolynomialSum sum;
  for (int p = 0; p <= 2 * l; ++p) {
    if (forward(row, p).is_zero()) continue;
    for (int q = 0; q <= 2 * l; ++q) {
      if (backward(q, column).is_zero() || rational(p, q).is_zero()) continue;
      sum.add(forward(row, p) * RadicalSum(factor_ratio(l, p - l, q - l)) * backward(q, column), rational(p, q));
    }
  }
  return sum.terms(names);
}

std::string entry_symbol(int l, int m, int n) { return "D^{" + std::to_string(l) + "}" + tex_indices(m, n); }

// A row for each entry of the bands 0..degree that is not zero; band(l) = rational part of band l.
template <class Band>
FormulaTable table_of_bands(const std::string& note, const std::vector<std::string>& names, int degree,
                            Convention convention, const Band& band) {
  convention.folded = Folded::kNothing;  // one factor a band: it commutes with every rotation
  const ConventionMap map = map_to(convention, degree);
  FormulaTable table{{}, {note}, {}};
  for (int l = 0; l <= degree; ++l) {
    const Matrix<Polynomial>& rational = band(l);
    for (int row = 0; row <= 2 * l; ++row) {
      for (int column = 0; column <= 2 * l; ++column) {
        std::vector<FormulaTerm> terms = entry_terms(map, l, rational, row, column, names);
        if (!terms.empty()) table.rows.push_back({entry_symbol(l, row - l, column - l), std::move(terms)});
      }
    }
  }
  return table;
}

FormulaTable matrix_table(int degree, const Convention& convention) {
  std::vector<std::string> names;
  Matrix<Polynomial> r(3, 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      r(i, j) = Polynomial::variable(3 * i + j);
      names.push_back("r_{" + std::to_string(i) + std::to_string(j) + "}");
    }
  }
  const std::vector<Matrix<Polynomial>> bands = rotation_bands(degree, r, Polynomial(1));
  return table_of_bands(
      "Entry (m, n) of band l, for the rotation matrix with entries r_ij, rows and columns 0, 1, 2 = x, y, z. The form "
      "is not unique: rows and columns of the matrix are orthonormal.",
      names, degree, convention, [&](int l) -> const Matrix<Polynomial>& { return bands[l]; });
}

FormulaTable quaternion_table(int degree, const Convention& convention) {
  return table_of_bands("Entry (m, n) of band l, for the unit quaternion (w, x, y, z).", {"w", "x", "y", "z"}, degree,
                        convention, [](int l) { return quaternion_rotation(l).entries; });
}

FormulaTable about_z_table(int degree, const Convention& convention) {
  return table_of_bands(
      "Entry (m, n) of band l, for the turn about z with cosine c and sine s. Entries that are not listed are zero.",
      {"c", "s"}, degree, convention, rotation_about_z);
}

FormulaTable about_y_table(int degree, const Convention& convention) {
  return table_of_bands(
      "Entry (m, n) of band l, for the turn about y; c and s are cosine and sine of half the angle. Entries that are "
      "not listed are zero.",
      {"c", "s"}, degree, convention, rotation_about_y);
}

FormulaTable x90_table(int degree, const Convention& convention) {
  return table_of_bands(
      "Entry (m, n) of band l, for the turn by +90 degrees about x, y to z; the transpose turns back. Entries that are "
      "not listed are zero.",
      {}, degree, convention,
      [](int l) { return rotation_x90(l).mapped([](const cln::cl_RA& entry) { return Polynomial(entry); }); });
}

FormulaTable wigner_table(int degree, const Convention& convention) {
  if (!(convention == Convention{})) {
    throw std::invalid_argument(
        "wigner-d: defined for complex harmonics with the Condon-Shortley phase; leave --convention out");
  }
  FormulaTable table{{},
                     {"Entry (m', m) of Wigner's small d matrix of band l, for complex harmonics with the "
                      "Condon-Shortley phase; c and s are cosine and sine of half the angle beta."},
                     {}};
  for (int l = 0; l <= degree; ++l) {
    for (int row = -l; row <= l; ++row) {
      for (int column = -l; column <= l; ++column) {
        const WignerEntry entry = wigner_d(l, row, column);
        table.rows.push_back({"d^{" + std::to_string(l) + "}" + tex_indices(row, column),
                              {{entry.factor, false, {{entry.polynomial, {"c", "s"}}}}}});
      }
    }
  }
  return table;
}

}  // namespace

std::vector<TypesetFamily> rotation_tables() {
  return {{"rotation", "Rotation matrices", kMaxExpandedDegree, "expanded entries have over 7,000 terms there",
           matrix_table},
          {"rotation-quaternion", "Rotation matrices of a quaternion", kMaxQuaternionDegree,
           "entries are homogeneous of twice the degree in four variables", quaternion_table},
          {"rotation-z", "Turns about z", kMaxAxisDegree, "band matrices are kept to there", about_z_table},
          {"rotation-y", "Turns about y", kMaxAxisDegree, "band matrices are kept to there", about_y_table},
          {"rotation-x90", "The quarter turn about x", kMaxAxisDegree, "band matrices are kept to there", x90_table},
          {"wigner-d", "Wigner d matrices", kMaxAxisDegree, "band matrices are kept to there", wigner_table}};
}

}  // namespace sh::symbolic
