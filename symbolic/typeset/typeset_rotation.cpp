// Tables of rotation matrices. A coefficient vector turns as c' = D c; entries of D with |row| > l or |column| > l are
// left out, and so are the zeros of sparse matrices.
//
// In another convention D' = C D C^-1 with the band matrices C of convention_map.hpp. The formula holds in the
// convention's own coordinates, so its axes do not enter.
#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
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

// A row for each entry of the bands 0..degree that is not zero; bands_to(degree) = the rational parts of the bands.
template <class Bands>
auto fill_bands(const std::vector<std::string>& names, Bands bands_to) {
  return [names, bands_to](FormulaTable& table, int degree, Convention convention) {
    convention.folded = Folded::kNothing;  // one factor a band: it commutes with every rotation
    const ConventionMap map = map_to(convention, degree);
    const std::vector<Matrix<Polynomial>> bands = bands_to(degree);
    for (int l = 0; l <= degree; ++l) {
      for (int row = 0; row <= 2 * l; ++row) {
        for (int column = 0; column <= 2 * l; ++column) {
          std::vector<FormulaTerm> terms = entry_terms(map, l, bands[l], row, column, names);
          if (!terms.empty()) table.rows.push_back({entry_symbol(l, row - l, column - l), std::move(terms)});
        }
      }
    }
  };
}

// The same for a function that gives one band.
template <class Band>
auto fill_each_band(const std::vector<std::string>& names, Band band) {
  return fill_bands(names, [band](int degree) {
    std::vector<Matrix<Polynomial>> bands;
    for (int l = 0; l <= degree; ++l) bands.push_back(band(l));
    return bands;
  });
}

std::vector<Matrix<Polynomial>> bands_of_entries(int degree) {
  Matrix<Polynomial> r(3, 3);
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = Polynomial::variable(i);
  return rotation_bands(degree, r, Polynomial(1));
}

std::vector<std::string> entry_names() {
  std::vector<std::string> names;
  for (int i = 0; i < 9; ++i) names.push_back("r_{" + std::to_string(i / 3) + std::to_string(i % 3) + "}");
  return names;
}

Matrix<Polynomial> quarter_turn(int l) {
  return rotation_x90(l).mapped([](const cln::cl_RA& entry) { return Polynomial(entry); });
}

void fill_wigner(FormulaTable& table, int degree, const Convention& convention) {
  if (!(convention == Convention{})) {
    throw std::invalid_argument(
        "wigner-d: expected no --convention, because it is defined for complex harmonics with the Condon-Shortley "
        "phase");
  }
  for (int l = 0; l <= degree; ++l) {
    for (int row = -l; row <= l; ++row) {
      for (int column = -l; column <= l; ++column) {
        const WignerEntry entry = wigner_d(l, row, column);
        table.rows.push_back({"d^{" + std::to_string(l) + "}" + tex_indices(row, column),
                              {{entry.factor, false, {{entry.polynomial, {"c", "s"}}}}}});
      }
    }
  }
}

}  // namespace

std::vector<TypesetFamily> rotation_tables() {
  const std::string bands = "band matrices are kept to there";
  return {
      {"rotation",
       "Rotation matrices",
       kMaxExpandedDegree,
       "expanded entries have over 7,000 terms there",
       {"Entry (m, n) of band l, for the rotation matrix with entries r_ij, rows and columns 0, 1, 2 = x, y, z. The "
        "form "
        "is not unique: rows and columns of the matrix are orthonormal."},
       fill_bands(entry_names(), bands_of_entries)},
      {"rotation-quaternion",
       "Rotation matrices of a quaternion",
       kMaxQuaternionDegree,
       "entries are homogeneous of twice the degree in four variables",
       {"Entry (m, n) of band l, for the unit quaternion (w, x, y, z)."},
       fill_each_band({"w", "x", "y", "z"}, [](int l) { return quaternion_rotation(l).entries; })},
      {"rotation-z",
       "Turns about z",
       kMaxAxisDegree,
       bands,
       {"Entry (m, n) of band l, for the turn about z with cosine c and sine s. Entries that are not listed are zero."},
       fill_each_band({"c", "s"}, rotation_about_z)},
      {"rotation-y",
       "Turns about y",
       kMaxAxisDegree,
       bands,
       {"Entry (m, n) of band l, for the turn about y; c and s are cosine and sine of half the angle. Entries that are "
        "not listed are zero."},
       fill_each_band({"c", "s"}, rotation_about_y)},
      {"rotation-x90",
       "The quarter turn about x",
       kMaxAxisDegree,
       bands,
       {"Entry (m, n) of band l, for the turn by +90 degrees about x, y to z; the transpose turns back. Entries that "
        "are "
        "not listed are zero."},
       fill_each_band({}, quarter_turn)},
      {"wigner-d",
       "Wigner d matrices",
       kMaxAxisDegree,
       bands,
       {"Entry (m', m) of Wigner's small d matrix of band l, for complex harmonics with the Condon-Shortley phase; c "
        "and "
        "s are cosine and sine of half the angle beta."},
       fill_wigner}};
}

}  // namespace sh::symbolic
