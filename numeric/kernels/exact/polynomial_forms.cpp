// See polynomial_forms.hpp.
#include "numeric/kernels/exact/polynomial_forms.hpp"

#include <Eigen/LU>

#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

ExactMatrix solve(const ExactMatrix& a, const ExactMatrix& b) { return a.partialPivLu().solve(b); }

// Coefficients (terms, bands^2) of the part without z (k = 0) or with z (k = 1): its value at (x, y) is the even part
// of f in z, or the odd part divided by z. Interpolated on a triangle of points within the unit disk.
ExactMatrix part(int degree, int k) {
  const int largest = degree - k;
  const int count = coefficient_count(degree);
  std::vector<PreparedTerm> terms = prepared_terms(degree);
  std::erase_if(terms, [k](const PreparedTerm& term) { return term.k != k; });
  ExactMatrix powers(terms.size(), terms.size());
  ExactMatrix values(terms.size(), count);
  Eigen::Index row = 0;
  for (int p = 0; p <= largest; ++p) {
    for (int q = 0; p + q <= largest; ++q, ++row) {
      const Mpfr50 x = (Mpfr50(p) + Mpfr50(0.5)) / (2 * largest + 2) - Mpfr50(0.25);
      const Mpfr50 y = (Mpfr50(q) + Mpfr50(0.5)) / (2 * largest + 2) - Mpfr50(0.2);
      const Mpfr50 z = sqrt(Mpfr50(1 - x * x - y * y));
      for (std::size_t i = 0; i < terms.size(); ++i) powers(row, i) = pow(x, terms[i].i) * pow(y, terms[i].j);
      const auto above = basis(degree, x, y, z);
      const auto below = basis(degree, x, y, Mpfr50(-z));
      for (int i = 0; i < count; ++i) {
        values(row, i) = k == 0 ? Mpfr50((above[i] + below[i]) / 2) : Mpfr50((above[i] - below[i]) / (2 * z));
      }
    }
  }
  return terms.empty() ? values : solve(powers, values);
}

// Coefficients of Q_lm(z), by l (rows) and powers of z, for l = m..degree.
ExactMatrix axial_polynomials(int degree, int m) {
  const int n = degree - m + 1;
  ExactMatrix powers(n, n);
  ExactMatrix values(n, n);
  std::vector<Mpfr50> row(coefficient_count(degree));
  for (int node = 0; node < n; ++node) {
    const Mpfr50 z = (Mpfr50(node) + Mpfr50(0.5)) / n;
    basis_z_form(degree, Mpfr50(1), Mpfr50(0), z, row.data());  // Re (1 + 0i)^m = 1
    for (int i = 0; i < n; ++i) {
      powers(node, i) = pow(z, i);
      values(node, i) = row[coefficient_index(m + i, m)];
    }
  }
  return solve(powers, values).transpose();
}

}  // namespace

std::vector<PreparedTerm> prepared_terms(int degree) {
  std::vector<PreparedTerm> terms;
  for (const int k : {0, 1}) {
    for (int i = degree - k; i >= 0; --i) {
      for (int j = degree - k - i; j >= 0; --j) terms.push_back({i, j, k});
    }
  }
  return terms;
}

const ExactMatrix& prepare_matrix(int degree) {
  static std::map<int, ExactMatrix> matrices;
  ExactMatrix& matrix = matrices[degree];
  if (matrix.size() > 0) return matrix;
  const ExactMatrix without_z = part(degree, 0);
  matrix.resize(coefficient_count(degree), coefficient_count(degree));
  matrix << without_z, part(degree, 1);
  return matrix;
}

const ExactMatrix& finish_matrix(int degree) {
  static std::map<int, ExactMatrix> matrices;
  ExactMatrix& matrix = matrices[degree];
  if (matrix.size() > 0) return matrix;
  matrix = ExactMatrix::Zero(coefficient_count(degree), coefficient_count(degree));
  for (int m = 0; m <= degree; ++m) {
    const ExactMatrix q = axial_polynomials(degree, m);
    for (int l = m; l <= degree; ++l) {
      for (int power = m; power <= degree; ++power) {
        for (const int order : {m, -m}) {
          matrix(coefficient_index(l, order), coefficient_index(power, order)) = q(l - m, power - m);
        }
      }
    }
  }
  return matrix;
}

}  // namespace sh::numeric
