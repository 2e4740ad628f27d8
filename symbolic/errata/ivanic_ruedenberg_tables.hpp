// The recursion of Ivanic and Ruedenberg as its tables print it, over any ring: exact numbers, or linear forms in P.
//
// Input: R^1 and R^(l-1) of real spherical harmonics, order (y, z, x) in band 1. Output: R^l. The places where printed
// versions differ are arguments, so that each can be decided against rotations found by other routes.
// [IvanicRuedenberg96+98] Tables 1 and 2.
#pragma once

#include <cstdlib>

#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {

/// The two factors of V for m < 0, before _1P_{m+1} and before _{-1}P_{-m-1}; d = delta_{m,-1}.
enum class LowerV {
  kDerived,  ///< 1-d, sqrt(1+d)
  kPrint98,  ///< 1-d, sqrt(1-d)
  kPrint96,  ///< 1+d, sqrt(1-d)
};

/// Table 1.
struct TableOne {
  RadicalSum u;
  RadicalSum v;
  RadicalSum w;
};

/// The denominator under the roots of Table 1.
inline int table_one_denominator(int l, int n) { return std::abs(n) == l ? 2 * l * (2 * l - 1) : (l + n) * (l - n); }

inline TableOne table_one(int l, int m, int n) {
  const int a = std::abs(m);
  const int d = table_one_denominator(l, n);
  const int d0 = m == 0 ? 1 : 0;
  return {root(ratio((l + m) * (l - m), d)),
          scaled(ratio(1 - 2 * d0, 2), root(ratio((1 + d0) * (l + a - 1) * (l + a), d))),
          scaled(ratio(d0 - 1, 2), root(ratio((l - a - 1) * (l - a), d)))};
}

/// Table 2. p(i, mu) is _iP_{mu}, i = -1, 0, 1.
template <class T, class P>
T table_two_u(int m, const P& p) {
  return p(0, m);
}

template <class T, class P>
T table_two_v(int m, const P& p, LowerV lower) {
  if (m == 0) return p(1, 1) + p(-1, -1);
  if (m > 0) {
    const int d = m == 1 ? 1 : 0;
    return root(1 + d) * p(1, m - 1) + RadicalSum(cln::cl_RA(d - 1)) * p(-1, -m + 1);
  }
  const int d = m == -1 ? 1 : 0;
  const RadicalSum first(cln::cl_RA(lower == LowerV::kPrint96 ? 1 + d : 1 - d));
  const RadicalSum second = root(lower == LowerV::kDerived ? 1 + d : 1 - d);
  return first * p(1, m + 1) + second * p(-1, -m - 1);
}

template <class T, class P>
T table_two_w(int m, const P& p) {
  if (m == 0) return T();
  if (m > 0) return p(1, m + 1) + p(-1, -m - 1);
  return p(1, m - 1) + RadicalSum(cln::cl_RA(-1)) * p(-1, -m + 1);
}

/// _iP_{mu} of column n. Terms whose mu lies outside the lower band meet a coefficient zero.
template <class T>
T table_two_p(int i, int mu, int n, const Matrix<T>& first, const Matrix<T>& below) {
  const int l = below.rows() / 2 + 1;
  const auto r = [&](int j) { return entry_or_zero(first, i, j); };
  const auto b = [&](int nu) { return entry_or_zero(below, mu, nu); };
  if (n == l) return r(1) * b(l - 1) - r(-1) * b(-l + 1);
  if (n == -l) return r(1) * b(-l + 1) + r(-1) * b(l - 1);
  return r(0) * b(n);
}

/// R^l from R^1 and R^(l-1): u U + v V + w W.
template <class T>
Matrix<T> ivanic_ruedenberg_band(const Matrix<T>& first, const Matrix<T>& below, LowerV lower) {
  const int l = below.rows() / 2 + 1;
  Matrix<T> band(2 * l + 1, 2 * l + 1);
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      const auto p = [&](int i, int mu) { return table_two_p(i, mu, n, first, below); };
      const TableOne t = table_one(l, m, n);
      band(l + m, l + n) = t.u * table_two_u<T>(m, p) + t.v * table_two_v<T>(m, p, lower) + t.w * table_two_w<T>(m, p);
    }
  }
  return band;
}

}  // namespace sh::symbolic::errata
