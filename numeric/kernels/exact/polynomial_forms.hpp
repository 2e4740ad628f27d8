// Functions on the sphere as polynomials of the direction, by interpolation of the oracle's values at 50 digits.
//
// Two linear maps: from coefficients to the polynomial p(x, y) + z q(x, y) that evaluate_prepare writes, and from the
// moments of project_moments to coefficients. Neither uses a formula for the polynomials: both solve for the ones that
// take the values of numeric's basis.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>
#include <map>
#include <vector>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

using ExactMatrix = Eigen::Matrix<Mpfr50, Eigen::Dynamic, Eigen::Dynamic>;

/// Exponents of x^i y^j z^k, k = 0 or 1, of the coefficient at `index` (bands^2 of them): those without z by falling i,
/// then falling j, i + j <= degree; then those with z likewise, i + j < degree.
struct PreparedTerm {
  int i = 0, j = 0, k = 0;
};
std::vector<PreparedTerm> prepared_terms(int degree);

/// (bands^2, bands^2): polynomial = matrix c.
const ExactMatrix& prepare_matrix(int degree);

/// (bands^2, bands^2): c = matrix moments; the moment of z^n Re (x+iy)^m stands at index l(l+1)+m, of Im at l(l+1)-m,
/// l = m+n.
const ExactMatrix& finish_matrix(int degree);

/// out = matrix in.
template <class Real>
void multiply(const ExactMatrix& matrix, const Real* in, Real* out) {
  static std::map<const ExactMatrix*, std::vector<Real>> converted;  // by the address of a matrix that lives as long
  auto& entries = converted[&matrix];
  if (entries.empty()) {
    for (const auto& entry : matrix.reshaped<Eigen::RowMajor>()) entries.push_back(static_cast<Real>(entry));
  }
  const auto n = matrix.rows();
  for (Eigen::Index row = 0; row < n; ++row) {
    out[row] = 0;
    for (Eigen::Index i = 0; i < n; ++i) out[row] += entries[row * n + i] * in[i];
  }
}

}  // namespace sh::numeric
