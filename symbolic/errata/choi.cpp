// Choi, Ivanic, Gordon, Ruedenberg 1999: complex rotation matrices D = F + i G by recursion, then real ones.
//
// D_mn = INT conj Y_m(s) Y_n(R^-1 s) ds with the Condon-Shortley phase, R acting on columns: Wigner's
// exp(-i m alpha) d_mn(beta) exp(-i n gamma), against which the recursions are run on exact numbers.
#include <functional>

#include "symbolic/convention/complex_basis.hpp"
#include "symbolic/errata/errata.hpp"
#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {
namespace {

using Band = Matrix<RadicalSum>;

// D^1 from the nine entries of R; columns n = -1, 0, then n = 1 by symmetry.
Band first_band(const Matrix<cln::cl_RA>& r) {
  constexpr int x = 0;
  constexpr int y = 1;
  constexpr int z = 2;
  const RadicalSum i = RadicalSum::imaginary_unit();
  const auto number = [&](const cln::cl_RA& re, const cln::cl_RA& im) { return RadicalSum(re) + scaled(im, i); };
  const RadicalSum half(ratio(1, 2));
  const RadicalSum root_half = root(ratio(1, 2));
  Band d(3, 3);
  d(0, 0) = half * number(r(y, y) + r(x, x), r(y, x) - r(x, y));
  d(1, 0) = root_half * number(r(z, x), -r(z, y));
  d(2, 0) = half * number(r(y, y) - r(x, x), r(y, x) + r(x, y));
  d(0, 1) = root_half * number(r(x, z), r(y, z));
  d(1, 1) = RadicalSum(r(z, z));
  d(2, 1) = root_half * number(-r(x, z), r(y, z));
  for (int m = -1; m <= 1; ++m) {  // D_{m,1} = (-1)^(m+1) conj D_{-m,-1}
    d(1 + m, 2) = scaled(cln::cl_RA(parity(m + 1)), d(1 - m, 0).conjugate());
  }
  return d;
}

bool first_band_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    if (!(first_band(rotation.matrix) == rotation.complex[1])) return false;
  }
  return true;
}

bool conjugate_symmetry_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (const Band& d : rotation.complex) {
      const int l = d.rows() / 2;
      for (int m = -l; m <= l; ++m) {
        for (int n = -l; n <= l; ++n) {
          if (!(d(l - m, l - n) == scaled(cln::cl_RA(parity(m + n)), d(l + m, l + n).conjugate()))) return false;
        }
      }
    }
  }
  return true;
}

// The coefficients; each vanishes where its term would leave the lower band.
RadicalSum a(int l, int m, int n) { return root(ratio((l + m) * (l - m), (l + n) * (l - n))); }
RadicalSum b(int l, int m, int n) { return root(ratio((l + m) * (l + m - 1), 2 * (l + n) * (l - n))); }
RadicalSum c(int l, int m, int n) { return root(ratio(2 * (l + m) * (l - m), (l + n) * (l + n - 1))); }
RadicalSum d(int l, int m, int n) { return root(ratio((l + m) * (l + m - 1), (l + n) * (l + n - 1))); }

// product(i, j, m, n) stands for D^1_ij D^(l-1)_mn: complex, or its real part H, or its imaginary part K.
using Product = std::function<RadicalSum(int i, int j, int m, int n)>;

RadicalSum inner_entry(int l, int m, int n, const Product& product) {  // |n| < l
  return a(l, m, n) * product(0, 0, m, n) + b(l, m, n) * product(1, 0, m - 1, n) +
         b(l, -m, n) * product(-1, 0, m + 1, n);
}

RadicalSum lower_entry(int l, int m, int n, const Product& product) {  // -l <= n <= l-2
  return c(l, m, -n) * product(0, -1, m, n + 1) + d(l, m, -n) * product(1, -1, m - 1, n + 1) +
         d(l, -m, -n) * product(-1, -1, m + 1, n + 1);
}

RadicalSum upper_entry(int l, int m, int n, const Product& product) {  // -l+2 <= n <= l
  return c(l, m, n) * product(0, 1, m, n - 1) + d(l, m, n) * product(1, 1, m - 1, n - 1) +
         d(l, -m, n) * product(-1, 1, m + 1, n - 1);
}

Product complex_product(const Band& first, const Band& below) {
  return [&](int i, int j, int m, int n) { return entry_or_zero(first, i, j) * entry_or_zero(below, m, n); };
}

// One step from the exact band l-1 for every column from `from(l)` to `to(l)`.
template <class Entry, class From, class To>
bool columns_hold(const Entry& entry, const From& from, const To& to) {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 2; l <= kHighestBand; ++l) {
      const Product product = complex_product(rotation.complex[1], rotation.complex[to_size(l - 1)]);
      for (int m = -l; m <= l; ++m) {
        for (int n = from(l); n <= to(l); ++n) {
          if (!(entry(l, m, n, product) == rotation.complex[to_size(l)](l + m, l + n))) return false;
        }
      }
    }
  }
  return true;
}

bool inner_columns_hold() {
  return columns_hold(
      inner_entry, [](int l) { return 1 - l; }, [](int l) { return l - 1; });
}

bool outer_columns_hold() {
  return columns_hold(
             lower_entry, [](int l) { return -l; }, [](int l) { return l - 2; }) &&
         columns_hold(
             upper_entry, [](int l) { return 2 - l; }, [](int l) { return l; });
}

// Real and imaginary part of one band.
struct Parts {
  Band f;
  Band g;
};

Parts next_parts(const Parts& first, const Parts& below) {
  const int l = below.f.rows() / 2 + 1;
  const auto at = [](const Band& band, int m, int n) { return entry_or_zero(band, m, n); };
  const Product h = [&](int i, int j, int m, int n) {
    return at(first.f, i, j) * at(below.f, m, n) - at(first.g, i, j) * at(below.g, m, n);
  };
  const Product k = [&](int i, int j, int m, int n) {
    return at(first.f, i, j) * at(below.g, m, n) + at(first.g, i, j) * at(below.f, m, n);
  };
  const auto entry = [l](int m, int n, const Product& product) {
    if (n == -l) return lower_entry(l, m, n, product);
    return n == l ? upper_entry(l, m, n, product) : inner_entry(l, m, n, product);
  };
  Parts parts{Band(2 * l + 1, 2 * l + 1), Band(2 * l + 1, 2 * l + 1)};
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      parts.f(l + m, l + n) = entry(m, n, h);
      parts.g(l + m, l + n) = entry(m, n, k);
    }
  }
  return parts;
}

// The whole recursion in real arithmetic, from R to band kHighestBand.
bool real_recursion_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    const Band start = first_band(rotation.matrix);
    const Parts first{real_part(start), imaginary_part(start)};
    Parts parts = first;
    for (int l = 2; l <= kHighestBand; ++l) {
      parts = next_parts(first, parts);
      const Band& exact = rotation.complex[to_size(l)];
      if (!(parts.f == real_part(exact)) || !(parts.g == imaginary_part(exact))) return false;
    }
  }
  return true;
}

// R = conj(W) D W^T for functions Y_real = W Y_complex.
bool general_form_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 0; l <= kHighestBand; ++l) {
      const Band w = real_from_complex(l, true);
      if (!(conjugate(w) * rotation.complex[to_size(l)] * w.transposed() == rotation.real[to_size(l)])) return false;
    }
  }
  return true;
}

// alpha_m = sqrt(1+delta_m0) (-1)^((|m|+m)/2), beta_m = sign(m) (1-delta_m0) alpha_m
RadicalSum alpha(int m) { return scaled(cln::cl_RA(m > 0 ? parity(m) : 1), root(m == 0 ? 2 : 1)); }
RadicalSum beta(int m) { return m == 0 ? RadicalSum() : scaled(cln::cl_RA(m > 0 ? 1 : -1), alpha(m)); }

enum class Quadrant { kBothUp, kBothDown, kRightDown, kLeftDown };  // eqs. 8.11, 8.12, 8.13, 8.14

bool in_quadrant(Quadrant quadrant, int m, int n) {
  switch (quadrant) {
    case Quadrant::kBothUp:
      return m >= 0 && n >= 0;
    case Quadrant::kBothDown:
      return m < 0 && n < 0;
    case Quadrant::kRightDown:
      return m >= 0 && n < 0;
    default:
      return m < 0 && n >= 0;
  }
}

// The right-hand side: same sign (F) or opposite sign (G) of the orders, second term added or taken away.
RadicalSum cosine_side(const Parts& d, int m, int n, int sign) {
  return alpha(m) * alpha(n) * entry_or_zero(d.f, m, n) +
         scaled(cln::cl_RA(sign), beta(m) * beta(-n) * entry_or_zero(d.f, m, -n));
}
RadicalSum sine_side(const Parts& d, int m, int n, int sign) {
  return alpha(m) * beta(n) * entry_or_zero(d.g, m, n) +
         scaled(cln::cl_RA(sign), beta(m) * alpha(-n) * entry_or_zero(d.g, m, -n));
}

// left(m, n) * R_mn = side(F, G, m, n) in the whole quadrant, l = 1..kHighestBand.
template <class Left, class Side>
bool quadrant_holds(Quadrant quadrant, const Left& left, const Side& side) {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 1; l <= kHighestBand; ++l) {
      const Band& exact = rotation.complex[to_size(l)];
      const Parts parts{real_part(exact), imaginary_part(exact)};
      for (int m = -l; m <= l; ++m) {
        for (int n = -l; n <= l; ++n) {
          if (!in_quadrant(quadrant, m, n)) continue;
          const RadicalSum expected = scaled(left(m, n), rotation.real[to_size(l)](l + m, l + n));
          if (!(expected == side(parts, m, n))) return false;
        }
      }
    }
  }
  return true;
}

template <int Factor>
cln::cl_RA times(int /*m*/, int /*n*/) {
  return Factor;
}

template <int Factor>
bool quadrant_8_11() {
  return quadrant_holds(Quadrant::kBothUp, times<Factor>,
                        [](const Parts& d, int m, int n) { return cosine_side(d, m, n, -1); });
}
bool quadrant_8_11_repaired() {
  return quadrant_holds(
      Quadrant::kBothUp, [](int m, int n) { return cln::cl_RA(m == 0 && n == 0 ? 2 : 1); },
      [](const Parts& d, int m, int n) { return cosine_side(d, m, n, -1); });
}
template <int Factor>
bool quadrant_8_12() {
  return quadrant_holds(Quadrant::kBothDown, times<Factor>,
                        [](const Parts& d, int m, int n) { return cosine_side(d, m, n, 1); });
}
template <int Factor>
bool quadrant_8_13() {
  return quadrant_holds(Quadrant::kRightDown, times<Factor>,
                        [](const Parts& d, int m, int n) { return sine_side(d, m, n, -1); });
}
bool quadrant_8_13_repaired() {
  return quadrant_holds(Quadrant::kRightDown, times<1>,
                        [](const Parts& d, int m, int n) { return sine_side(d, m, n, 1); });
}
template <int Factor>
bool quadrant_8_14() {
  return quadrant_holds(Quadrant::kLeftDown, times<Factor>,
                        [](const Parts& d, int m, int n) { return sine_side(d, m, n, -1); });
}

template <int Factor>
bool all_quadrants() {
  const auto repaired = [](const Parts& d, int m, int n) {
    if (m >= 0 && n >= 0) return scaled(ratio(1, m == 0 && n == 0 ? 2 : 1), cosine_side(d, m, n, -1));
    if (m < 0 && n < 0) return cosine_side(d, m, n, 1);
    return sine_side(d, m, n, m < 0 ? -1 : 1);
  };
  for (const Quadrant q : {Quadrant::kBothUp, Quadrant::kBothDown, Quadrant::kRightDown, Quadrant::kLeftDown}) {
    if (!quadrant_holds(q, times<Factor>, repaired)) return false;
  }
  return true;
}

}  // namespace

std::vector<Entry> choi() {
  return {
      {"CH-01",
       "Eqs. 5.4, 5.5: D^1 from R",
       Kind::kEquation,
       Print::kReport,
       "D_{-1,-1} = (Ryy+Rxx + i(Ryx-Rxy))/2; D_{0,-1} = (Rzx - i Rzy)/sqrt2; D_{1,-1} = (Ryy-Rxx + i(Ryx+Rxy))/2; "
       "D_{-1,0} = (Rxz + i Ryz)/sqrt2; D_{0,0} = Rzz; D_{1,0} = (-Rxz + i Ryz)/sqrt2; "
       "D_{m,1} = (-1)^{m+1} conj D_{-m,-1}",
       Verdict::kCorrect,
       {{"R acting on columns, Condon-Shortley phase, D_mn = INT conj Y_m(s) Y_n(R^-1 s) ds", first_band_holds}},
       "",
       nullptr,
       "With the transposed R it belongs to the inverse rotation. A public port sets G_{1,-1} = -G_{0,-1}; it is "
       "-G_{-1,1}."},
      {"CH-02",
       "Eq. 5.8 (symmetry)",
       Kind::kEquation,
       Print::kReport,
       "D_{-m,-n} = (-1)^{m+n} conj D_{m,n}",
       Verdict::kCorrect,
       {{"as printed, l <= 6", conjugate_symmetry_holds}},
       "",
       nullptr,
       ""},
      {"CH-03",
       "Eqs. 6.1-6.5 (|n| < l)",
       Kind::kEquation,
       Print::kReport,
       "D^l_{mn} = a D^1_{00} D^{l-1}_{mn} + b_m D^1_{10} D^{l-1}_{m-1,n} + b_{-m} D^1_{-1,0} D^{l-1}_{m+1,n}; "
       "a = sqrt((l+m)(l-m)/((l+n)(l-n))), b_m = sqrt((l+m)(l+m-1)/(2(l+n)(l-n)))",
       Verdict::kCorrect,
       {{"every column |n| < l, from the exact band l-1, l = 2..6", inner_columns_hold}},
       "",
       nullptr,
       "A coefficient vanishes wherever its term would leave band l-1."},
      {"CH-04",
       "Eqs. 6.6-6.13 (n near +-l)",
       Kind::kEquation,
       Print::kReport,
       "D^l_{mn} = c_n D^1_{01} D^{l-1}_{m,n-1} + d_{m,n} D^1_{11} D^{l-1}_{m-1,n-1} + d_{-m,n} D^1_{-1,1} "
       "D^{l-1}_{m+1,n-1}, -l+2 <= n <= l; c_n = sqrt(2(l+m)(l-m)/((l+n)(l+n-1))), "
       "d_{m,n} = sqrt((l+m)(l+m-1)/((l+n)(l+n-1))); the same with n+1, D^1_{.,-1} and -n for -l <= n <= l-2",
       Verdict::kCorrect,
       {{"every column of both ranges, from the exact band l-1, l = 2..6", outer_columns_hold}},
       "",
       nullptr,
       ""},
      {"CH-05",
       "Eqs. 7.1-7.8",
       Kind::kEquation,
       Print::kReport,
       "H = F^1_{ij} F^{l-1}_{mn} - G^1_{ij} G^{l-1}_{mn}, K = F^1_{ij} G^{l-1}_{mn} + G^1_{ij} F^{l-1}_{mn}; F^l from "
       "H "
       "and G^l from K with the coefficients of 6.x",
       Verdict::kCorrect,
       {{"the whole recursion from R in real arithmetic, to l = 6", real_recursion_holds}},
       "",
       nullptr,
       ""},
      {"CH-06",
       "Eqs. 8.8-8.9 (general complex-to-real form)",
       Kind::kEquation,
       Print::kReport,
       "2 R = ... in alpha, beta, F, G (wording not known)",
       Verdict::kUndecided,
       {},
       "R = conj(W) D W^T, Y_real = W Y_complex (B-18 written out)",
       general_form_holds,
       "The printed text is not known to us; what is needed there is proved on exact rotations to l = 6."},
      {"CH-07",
       "Eq. 8.10 alpha, beta",
       Kind::kEquation,
       Print::kReport,
       "alpha_m = sqrt(1+delta_{m0}) (-1)^{(|m|+m)/2} (as its author corrected it), "
       "beta_m = sign(m)(1-delta_{m0}) alpha_m",
       Verdict::kUnderReading,
       {{"in 8.11-8.14 with R on the left, repaired as in CH-08 and CH-10", all_quadrants<1>},
        {"in the same with 2R on the left, as its author also suggests", all_quadrants<2>}},
       "as printed, with R and not 2R",
       all_quadrants<1>,
       "The print of 8.10 is not known to us; the correction is second-hand, from a public port."},
      {"CH-08",
       "Eq. 8.11 (m >= 0, n >= 0)",
       Kind::kEquation,
       Print::kReport,
       "R_{mn} = alpha_m alpha_n F_{mn} - beta_m beta_{-n} F_{m,-n}",
       Verdict::kWrong,
       {{"R on the left", quadrant_8_11<1>}, {"2R on the left", quadrant_8_11<2>}},
       "(1 + delta_{m0} delta_{n0}) R_{mn} = alpha_m alpha_n F_{mn} - beta_m beta_{-n} F_{m,-n}; R_{00} = F_{00}",
       quadrant_8_11_repaired,
       "Only R_{00} comes out doubled with R, and only R_{00} is right with 2R."},
      {"CH-09",
       "Eq. 8.12 (m < 0, n < 0)",
       Kind::kEquation,
       Print::kReport,
       "R_{mn} = alpha_m alpha_n F_{mn} + beta_m beta_{-n} F_{m,-n}",
       Verdict::kUnderReading,
       {{"R on the left", quadrant_8_12<1>}, {"2R on the left, as its author suggests", quadrant_8_12<2>}},
       "R_{mn} = alpha_m alpha_n F_{mn} + beta_m beta_{-n} F_{m,-n}",
       quadrant_8_12<1>,
       ""},
      {"CH-10",
       "Eq. 8.13 (m >= 0, n < 0)",
       Kind::kEquation,
       Print::kReport,
       "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}",
       Verdict::kWrong,
       {{"R on the left", quadrant_8_13<1>}, {"2R on the left", quadrant_8_13<2>}},
       "R_{mn} = alpha_m beta_n G_{mn} + beta_m alpha_{-n} G_{m,-n}",
       quadrant_8_13_repaired,
       "The sign of the second term; with m = 0 it does not matter."},
      {"CH-11",
       "Eq. 8.14 (m < 0, n >= 0)",
       Kind::kEquation,
       Print::kReport,
       "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}",
       Verdict::kUnderReading,
       {{"R on the left", quadrant_8_14<1>}, {"2R on the left, as its author suggests", quadrant_8_14<2>}},
       "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}",
       quadrant_8_14<1>,
       ""},
  };
}

}  // namespace sh::symbolic::errata
