// Rotation of real spherical harmonics by recursion over the bands in the nine entries of a 3x3 matrix.
//
// Same matrices and conventions as symbolic/rotation/rotation.hpp: Y_l(R s) = D_l(R) Y_l(s), D_mn = (k_m/k_n) T_mn.
// This is the recursion of Ivanic and Ruedenberg [IvanicRuedenberg96+98], derived again in rational form. For |n| < l,
// z S_(l-1,n) = g S_ln + (x^2+y^2+z^2)(...); the second part is orthogonal to band l, so
//     D^l_mn = integral of Y_lm(R v) Y_ln(v) = const_n * sum_ij R_iz D^(l-1)_jn (integral of Y_lm w_i Y_(l-1)j),
// and S_l,+-l come from x and y times S_(l-1),+-(l-1) in the same way. The integrals of three factors, one of them a
// coordinate, are rational, with at most two j for each i (band_couplings). No division by an entry of R, no
// special case for any rotation.
//
// T is any ring over the rationals: cln::cl_RA for exact points (to degree kMaxRecursionDegree), or Polynomial in nine
// variables for expanded entries (7,251 terms at degree 6, 39,312 at degree 8; the expansion is not unique, since
// R R^T = 1). Entries are homogeneous of degree l in R, so R may have any scale.
#pragma once

#include <cln/rational.h>

#include <stdexcept>
#include <vector>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::symbolic {

inline constexpr int kMaxRecursionDegree = 20;
inline constexpr int kMaxExpandedDegree = 6;

/// The part of S_(l, above) in coordinate `axis` (0, 1, 2) times S_(l-1, below). weight: the integral with the scale of
/// the recursion, g * k_(l-1,below)^2 / k_(l,above)^2.
struct Coupling {
  int axis = 0;
  int below = 0;
  cln::cl_RA weight = 0;
};

/// For each order m = -l..l of band l >= 1 (index l + m) its couplings to band l-1, by GiNaC
/// (rotation.cpp), derived once.
const std::vector<std::vector<Coupling>>& band_couplings(int degree);

/// The factor before the sum for column n: k_ln^2 / (k_(l-1)^2 g).
cln::cl_RA column_scale(int degree, int column);

namespace detail {

// sum over the couplings of row m of R(axis, coordinate) T_below(below, column)
template <class T>
T coupled_sum(const std::vector<Coupling>& couplings, const Matrix<T>& r, int coordinate, const Matrix<T>& below,
              int column, int degree) {
  T sum = T();
  for (const Coupling& c : couplings) {
    sum = sum + c.weight * (r(c.axis, coordinate) * below(degree - 1 + c.below, degree - 1 + column));
  }
  return sum;
}

template <class T>
Matrix<T> next_band(int l, const Matrix<T>& r, const Matrix<T>& below) {
  constexpr int x = 0;
  constexpr int y = 1;
  constexpr int z = 2;
  const auto& couplings = band_couplings(l);
  Matrix<T> t(2 * l + 1, 2 * l + 1);
  for (int row = 0; row <= 2 * l; ++row) {
    const auto& list = couplings[row];
    const auto sum = [&](int coordinate, int column) { return coupled_sum(list, r, coordinate, below, column, l); };
    for (int n = 1 - l; n < l; ++n) t(row, l + n) = column_scale(l, n) * sum(z, n);
    t(row, 2 * l) = column_scale(l, l) * (sum(x, l - 1) - sum(y, 1 - l));  // S_l = (2l-1)(x S_(l-1) - y S_-(l-1))
    t(row, 0) = column_scale(l, -l) * (sum(x, 1 - l) + sum(y, l - 1));     // S_-l = (2l-1)(x S_-(l-1) + y S_(l-1))
  }
  return t;
}

}  // namespace detail

/// T of bands 0..degree for the matrix r (3, 3), row-major, rows and columns in the order x, y, z. `one` is the one of
/// the ring. Throws std::invalid_argument unless 0 <= degree <= kMaxRecursionDegree and r is 3x3.
template <class T>
std::vector<Matrix<T>> rotation_bands(int degree, const Matrix<T>& r, const T& one) {
  require_degree("rotation recursion", degree, kMaxRecursionDegree, "exact entries grow with the degree");
  if (r.rows() != 3 || r.columns() != 3)
    throw std::invalid_argument("rotation recursion: expected a 3x3 matrix, got another shape");
  std::vector<Matrix<T>> bands{Matrix<T>::identity(1, one)};
  if (degree >= 1) {  // S_1 = (y, z, x)
    constexpr int order[3] = {1, 2, 0};
    Matrix<T> first(3, 3);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) first(i, j) = r(order[i], order[j]);
    }
    bands.push_back(std::move(first));
  }
  for (int l = 2; l <= degree; ++l) bands.push_back(detail::next_band(l, r, bands.back()));
  return bands;
}

}  // namespace sh::symbolic
