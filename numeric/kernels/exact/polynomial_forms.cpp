// See polynomial_forms.hpp.
#include "numeric/kernels/exact/polynomial_forms.hpp"

#include <utility>

#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

using Vector = std::vector<Mpfr50>;

// x with a x = b for every column of b (n, columns) by Gaussian elimination with row exchanges; a (n, n), row-major.
Vector solve(std::size_t n, Vector a, Vector b) {
  const std::size_t columns = b.size() / n;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t row = k + 1; row < n; ++row) {
      if (abs(a[row * n + k]) > abs(a[pivot * n + k])) pivot = row;
    }
    for (std::size_t i = 0; i < n; ++i) std::swap(a[k * n + i], a[pivot * n + i]);
    for (std::size_t i = 0; i < columns; ++i) std::swap(b[k * columns + i], b[pivot * columns + i]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == k) continue;
      const Mpfr50 factor = a[row * n + k] / a[k * n + k];
      for (std::size_t i = k; i < n; ++i) a[row * n + i] -= factor * a[k * n + i];
      for (std::size_t i = 0; i < columns; ++i) b[row * columns + i] -= factor * b[k * columns + i];
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t i = 0; i < columns; ++i) b[row * columns + i] /= a[row * n + row];
  }
  return b;
}

Mpfr50 power(const Mpfr50& base, int exponent) {
  Mpfr50 result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

// Coefficients (terms, bands^2) of the part without z (k = 0) or with z (k = 1): its value at (x, y) is the even part
// of f in z, or the odd part divided by z. Interpolated on a triangle of points within the unit disk.
Vector part(int degree, int k) {
  const int largest = degree - k;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<PreparedTerm> terms;
  for (const auto& term : prepared_terms(degree)) {
    if (term.k == k) terms.push_back(term);
  }
  Vector powers;
  Vector values;
  for (int p = 0; p <= largest; ++p) {
    for (int q = 0; p + q <= largest; ++q) {
      const Mpfr50 x = (Mpfr50(p) + Mpfr50(0.5)) / (2 * largest + 2) - Mpfr50(0.25);
      const Mpfr50 y = (Mpfr50(q) + Mpfr50(0.5)) / (2 * largest + 2) - Mpfr50(0.2);
      const Mpfr50 z = sqrt(Mpfr50(1 - x * x - y * y));
      for (const auto& term : terms) powers.push_back(power(x, term.i) * power(y, term.j));
      const auto above = basis(degree, x, y, z);
      const auto below = basis(degree, x, y, Mpfr50(-z));
      for (std::size_t i = 0; i < count; ++i) {
        values.push_back(k == 0 ? Mpfr50((above[i] + below[i]) / 2) : Mpfr50((above[i] - below[i]) / (2 * z)));
      }
    }
  }
  return terms.empty() ? Vector() : solve(terms.size(), powers, values);
}

// Coefficients of Q_lm(z), by powers of z, for l = m..degree: (degree - m + 1, degree - m + 1), row-major by l.
Vector axial_polynomials(int degree, int m) {
  const auto n = static_cast<std::size_t>(degree - m + 1);
  Vector powers;
  Vector values(n * n);
  for (std::size_t node = 0; node < n; ++node) {
    const Mpfr50 z = (Mpfr50(static_cast<double>(node)) + Mpfr50(0.5)) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) powers.push_back(power(z, static_cast<int>(i)));
    Vector row(coefficient_count(degree));
    basis_z_form(degree, Mpfr50(1), Mpfr50(0), z, row.data());  // Re (1 + 0i)^m = 1
    for (std::size_t l = 0; l < n; ++l) {
      values[node * n + l] = row[coefficient_index(static_cast<int>(l) + m, m)];
    }
  }
  const Vector by_power = solve(n, powers, values);
  Vector by_degree(n * n);
  for (std::size_t l = 0; l < n; ++l) {
    for (std::size_t i = 0; i < n; ++i) by_degree[l * n + i] = by_power[i * n + l];
  }
  return by_degree;
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

const std::vector<Mpfr50>& prepare_matrix(int degree) {
  static std::map<int, Vector> matrices;
  Vector& matrix = matrices[degree];
  if (matrix.empty()) {
    matrix = part(degree, 0);
    const Vector with_z = part(degree, 1);
    matrix.insert(matrix.end(), with_z.begin(), with_z.end());
  }
  return matrix;
}

const std::vector<Mpfr50>& finish_matrix(int degree) {
  static std::map<int, Vector> matrices;
  Vector& matrix = matrices[degree];
  if (!matrix.empty()) return matrix;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  matrix.resize(count * count);
  for (int m = 0; m <= degree; ++m) {
    const Vector q = axial_polynomials(degree, m);
    const int n = degree - m + 1;
    for (int l = 0; l < n * n; ++l) {
      for (const int sign : {1, -1}) {
        const int row = coefficient_index(m + l / n, sign * m);
        const int column = coefficient_index(m + l % n, sign * m);
        matrix[static_cast<std::size_t>(row) * count + static_cast<std::size_t>(column)] = q[l];
      }
    }
  }
  return matrix;
}

}  // namespace sh::numeric
