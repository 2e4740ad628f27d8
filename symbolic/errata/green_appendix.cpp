// [Green03] Appendix 1, G-95 to G-98: the recursion of Ivanic and Ruedenberg in the paper's names.
//
// The page's equations are lost. The recursion is carried out on exact numbers for a rational rotation and compared
// with the quaternion form (symbolic/rotation/quaternion_rotation.hpp), which shares no code with it.
#include <array>
#include <cstdlib>

#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/rotation/quaternion_rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {
namespace {

using Number = RadicalSum;

constexpr int kBands = 5;

Number root(const cln::cl_RA& square) { return Number(Surd::square_root(square)); }
int delta(int a, int b) { return a == b ? 1 : 0; }

enum class TableV {
  kDerived,   // m < 0: P(1, m+1) (1 - d) + P(-1, -m-1) sqrt(1 + d), d = delta_(m, -1)
  kReported,  // m < 0: P(1, m+1) (1 + d) + P(-1, -m-1) sqrt(1 - d)
};

// One band from the band below: entries M_mn of l-1 and the permuted matrix R_mn.
class Band {
 public:
  Band(int l, TableV table, const Matrix<Number>& r, const Matrix<Number>& below)
      : l_(l), table_(table), r_(r), below_(below) {}

  [[nodiscard]] Matrix<Number> entries() const {
    Matrix<Number> result(2 * l_ + 1, 2 * l_ + 1);
    for (int m = -l_; m <= l_; ++m) {
      for (int n = -l_; n <= l_; ++n) result(l_ + m, l_ + n) = entry(m, n);
    }
    return result;
  }

 private:
  [[nodiscard]] Number entry(int m, int n) const {
    const int a = std::abs(m);
    const cln::cl_RA d = std::abs(n) == l_ ? 2 * l_ * (2 * l_ - 1) : (l_ + n) * (l_ - n);
    const Number u = root((l_ + m) * (l_ - m) / d);
    const Number v =
        Number(cln::cl_RA(1 - 2 * delta(m, 0)) / 2) * root((1 + delta(m, 0)) * (l_ + a - 1) * (l_ + a) / d);
    const Number w = Number(cln::cl_RA(delta(m, 0) - 1) / 2) * root((l_ - a - 1) * (l_ - a) / d);
    Number sum;
    if (!u.is_zero()) sum += u * p(0, m, n);
    if (!v.is_zero()) sum += v * v_function(m, n);
    if (!w.is_zero()) sum += w * w_function(m, n);
    return sum;
  }

  [[nodiscard]] Number v_function(int m, int n) const {
    if (m == 0) return p(1, 1, n) + p(-1, -1, n);
    if (m > 0) return optional(1 + delta(m, 1), 1, m - 1, n) - whole(1 - delta(m, 1), -1, -m + 1, n);
    const int d = delta(m, -1);
    return table_ == TableV::kDerived ? whole(1 - d, 1, m + 1, n) + optional(1 + d, -1, -m - 1, n)
                                      : whole(1 + d, 1, m + 1, n) + optional(1 - d, -1, -m - 1, n);
  }

  [[nodiscard]] Number w_function(int m, int n) const {
    return m > 0 ? p(1, m + 1, n) + p(-1, -m - 1, n) : p(1, m - 1, n) - p(-1, -m + 1, n);
  }

  // factor P, or sqrt(factor) P, without asking for an entry when the factor is zero.
  [[nodiscard]] Number whole(int factor, int i, int m, int n) const {
    return factor == 0 ? Number() : Number(cln::cl_RA(factor)) * p(i, m, n);
  }
  [[nodiscard]] Number optional(int square, int i, int m, int n) const {
    return square == 0 ? Number() : root(square) * p(i, m, n);
  }

  [[nodiscard]] Number p(int i, int m, int n) const {
    if (n == l_) return r(i, 1) * m_below(m, l_ - 1) - r(i, -1) * m_below(m, 1 - l_);
    if (n == -l_) return r(i, 1) * m_below(m, 1 - l_) + r(i, -1) * m_below(m, l_ - 1);
    return r(i, 0) * m_below(m, n);
  }

  [[nodiscard]] const Number& r(int i, int j) const { return r_(i + 1, j + 1); }
  [[nodiscard]] const Number& m_below(int m, int n) const { return below_(l_ - 1 + m, l_ - 1 + n); }

  int l_;
  TableV table_;
  const Matrix<Number>& r_;
  const Matrix<Number>& below_;
};

// R_mn, m and n in the order of the axes y, z, x.
template <class T>
Matrix<T> permuted(const Matrix<T>& r) {
  constexpr std::array<int, 3> kAxes{1, 2, 0};
  Matrix<T> result(3, 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = r(kAxes[to_size(i)], kAxes[to_size(j)]);
  }
  return result;
}

// For the matrix of every quaternion at once.
bool first_band_is_permuted_matrix() {
  const auto part = [](int i) { return Polynomial::variable(3 + i); };
  const Matrix<Polynomial> r = matrix_from_quaternion<Polynomial>({part(0), part(1), part(2), part(3)});
  return band_by_integration(1, r) == permuted(r);
}

Matrix<Number> as_numbers(const Matrix<Surd>& matrix) {
  Matrix<Number> result(matrix.rows(), matrix.columns());
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j) result(i, j) = Number(matrix(i, j));
  }
  return result;
}

Matrix<Number> exact_band(int l) {
  return as_numbers(surd_entries(l, evaluate(quaternion_rotation(l), rational_quaternion())));
}

template <TableV table>
bool recursion_gives_every_band() {
  const Matrix<cln::cl_RA> rational = permuted(matrix_from_quaternion<cln::cl_RA>(rational_quaternion()));
  const Matrix<Number> r = as_numbers(surd_entries(1, rational));  // band 1 has one factor: rational entries
  Matrix<Number> band = r;
  for (int l = 2; l <= kBands; ++l) {
    band = Band(l, table, r, band).entries();
    if (!(band == exact_band(l))) return false;
  }
  return true;
}

// In band 2 the reported table spoils row -1 and nothing else.
bool reported_table_spoils_only_row_minus_one() {
  const Matrix<cln::cl_RA> rational = permuted(matrix_from_quaternion<cln::cl_RA>(rational_quaternion()));
  const Matrix<Number> r = as_numbers(surd_entries(1, rational));
  const Matrix<Number> reported = Band(2, TableV::kReported, r, r).entries();
  const Matrix<Number> exact = exact_band(2);
  for (int m = -2; m <= 2; ++m) {
    bool equal = true;
    for (int n = -2; n <= 2; ++n) equal = equal && reported(2 + m, 2 + n) == exact(2 + m, 2 + n);
    if (equal != (m != -1)) return false;
  }
  return true;
}

bool derived_table_mends_row_minus_one() {
  return recursion_gives_every_band<TableV::kDerived>() && reported_table_spoils_only_row_minus_one();
}

}  // namespace

std::vector<Entry> green_appendix() {
  return {
      {"G-95",
       "Appendix 1, permuted R",
       Kind::kEquation,
       Print::kLost,
       "the 3x3 matrix in another order, renamed R_mn, m and n from -1 to 1",
       Verdict::kDerived,
       {},
       "rows and columns -1, 0, 1 are y, z, x: R_-1,-1 = R_YY, R_-1,0 = R_YZ, R_-1,1 = R_YX, R_0,-1 = R_ZY, "
       "R_00 = R_ZZ, R_01 = R_ZX, R_1,-1 = R_XY, R_10 = R_XZ, R_11 = R_XX",
       first_band_is_permuted_matrix,
       "R on column vectors; its transpose gives the inverse rotation. With the Condon-Shortley signs of the paper's "
       "code entries with one index 0 change sign."},
      {"G-96",
       "Appendix 1, recursion",
       Kind::kEquation,
       Print::kLost,
       "matrix M of band l, arguments m and n from -l to l, from u, v, w and U, V, W",
       Verdict::kDerived,
       {},
       "M_mn = u U + v V + w W",
       recursion_gives_every_band<TableV::kDerived>,
       "Carried out to band 5; the source's own entries are IR."},
      {"G-97",
       "Appendix 1, tables of u, v, w and U, V, W, P",
       Kind::kTable,
       Print::kReport,
       "V for m < 0 (d = delta_(m,-1)): P(1,m+1) (1+d) + P(-1,-m-1) sqrt(1-d); the rest is lost",
       Verdict::kWrong,
       {{"as reported, the other entries as derived", recursion_gives_every_band<TableV::kReported>}},
       "V for m < 0: P(1,m+1) (1-d) + P(-1,-m-1) sqrt(1+d)",
       derived_table_mends_row_minus_one,
       "Known from a remark in google/spherical-harmonics, whose authors read the page. In band 2 row -1 is wrong and "
       "no other; the error spreads from there. Tables: u^2 = (l+m)(l-m)/d', v = (1-2 delta_m0)/2 "
       "sqrt((1+delta_m0)(l+|m|-1)(l+|m|)/d'), w = -(1-delta_m0)/2 sqrt((l-|m|-1)(l-|m|)/d'), d' = (l+n)(l-n) or "
       "2l(2l-1) for |n| = l; U = P(0,m)."},
      {"G-98",
       "Appendix note",
       Kind::kText,
       Print::kRead,
       "m' of the original is n here, R^l is M_l",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "A change of names."},
  };
}

}  // namespace sh::symbolic::errata
