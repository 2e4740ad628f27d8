// Blanco, Florez, Bermejo 1997: real rotation matrices from Wigner's d, and recurrences for d.
//
// d^l_{m'm}(b) is compared with Wigner's sum (rotation_axis.hpp): as identities of polynomials in c, s = cos, sin of
// b/2 where the formula is one, else at exact angles. The recurrences as a whole are in blanco_recurrence.hpp.
#include "symbolic/convention/complex_basis.hpp"
#include "symbolic/errata/blanco_recurrence.hpp"
#include "symbolic/errata/errata.hpp"
#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"
#include "symbolic/rotation/rotation_axis.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kIdentityDegree = 8;

Polynomial cosine_half() { return Polynomial::variable(0); }
Polynomial sine_half() { return Polynomial::variable(1); }
Polynomial one() { return cosine_half().power(2) + sine_half().power(2); }    // makes terms homogeneous
Polynomial cos_b() { return cosine_half().power(2) - sine_half().power(2); }  // d^1_00

// factor * p * d^l_{m'm}
SurdTerm term(const Surd& factor, const Polynomial& p, int l, int row, int column) {
  const WignerEntry d = wigner_d(l, row, column);
  return {factor * d.factor, p * d.polynomial};
}

SurdTerm term(int factor, const Polynomial& p, int l, int row, int column) {
  return term(Surd(cln::cl_RA(factor)), p, l, row, column);
}

Surd surd_root(const cln::cl_RA& square) { return Surd::square_root(square); }

bool azimuthal_functions_hold() {
  std::vector<SurdTerm> functions{{Surd(cln::cl_RA(1)), Polynomial(1)}};
  for (int m = 1; m <= kIdentityDegree; ++m) {
    functions.push_back({surd_root(2), cosine_of_multiple(m)});
    functions.push_back({surd_root(2), sine_of_multiple(m)});
  }
  return orthogonal_over_circle(functions);
}

// D = W^T R conj(W) from the real matrix of the same rotation.
bool zyz_form_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 0; l <= kHighestBand; ++l) {
      const auto w = real_from_complex(l, true);
      const auto expected = w.transposed() * rotation.real[to_size(l)] * conjugate(w);
      if (!(expected == rotation.complex[to_size(l)])) return false;
    }
  }
  return true;
}

// condition(l, m', m) for every entry of the bands from `lowest`.
template <class Condition>
bool every_entry(int lowest, const Condition& condition) {
  for (int l = lowest; l <= kIdentityDegree; ++l) {
    for (int row = -l; row <= l; ++row) {
      for (int column = -l; column <= l; ++column) {
        if (!condition(l, row, column)) return false;
      }
    }
  }
  return true;
}

bool symmetries_hold() {
  return every_entry(0, [](int l, int m1, int m) {
    const int sign = m1 - m;
    const SurdTerm minus = term(-1, Polynomial(1), l, m1, m);
    return vanishes({minus, term(parity(sign), Polynomial(1), l, m, m1)}) &&
           vanishes({minus, term(1, Polynomial(1), l, -m, -m1)}) &&
           vanishes({minus, term(parity(sign), Polynomial(1), l, -m1, -m)});
  });
}

RadicalSum azimuthal(int m, const CosSin<cln::cl_RA>& half_angle) {
  if (m == 0) return RadicalSum(cln::cl_RA(1));
  const RadicalSum turn = unit_power(half_angle, 2 * std::abs(m));
  const RadicalSum cosine = scaled(ratio(1, 2), turn + turn.conjugate());
  const RadicalSum sine = scaled(ratio(1, 2), RadicalSum::imaginary_unit()) * (turn.conjugate() - turn);
  return root(2) * (m > 0 ? cosine : sine);
}

int sign_or_one(int m) { return m < 0 ? -1 : 1; }

// The printed entry R_{mm'}; `swapped` exchanges the two indices of each d.
RadicalSum real_entry(const ExactRotation& rotation, int l, int m, int m1, bool swapped) {
  const int a = std::abs(m);
  const int a1 = std::abs(m1);
  const auto& half = rotation.half_angles;
  const RadicalSum d1 = swapped ? wigner_value(l, a, a1, half[1]) : wigner_value(l, a1, a, half[1]);
  const RadicalSum d2 = swapped ? wigner_value(l, a1, -a, half[1]) : wigner_value(l, a, -a1, half[1]);
  const RadicalSum mirrored = scaled(cln::cl_RA(parity(m)), d2);
  return scaled(ratio(sign_or_one(m1), 2), azimuthal(m, half[0]) * azimuthal(m1, half[2]) * (d1 + mirrored)) +
         scaled(ratio(-sign_or_one(m), 2), azimuthal(-m, half[0]) * azimuthal(-m1, half[2]) * (d1 - mirrored));
}

bool real_form_holds(bool swapped, bool transposed) {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 0; l <= 4; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (int m1 = -l; m1 <= l; ++m1) {
          const auto& d = rotation.real[to_size(l)];
          const RadicalSum& expected = transposed ? d(l + m1, l + m) : d(l + m, l + m1);
          if (!(real_entry(rotation, l, m, m1, swapped) == expected)) return false;
        }
      }
    }
  }
  return true;
}

bool real_form_row_first() { return real_form_holds(false, false); }
bool real_form_column_first() { return real_form_holds(false, true); }
bool real_form_swapped() { return real_form_holds(true, false) || real_form_holds(true, true); }

bool start_values_hold() {
  const Polynomial c = cosine_half();
  const Polynomial s = sine_half();
  const Surd unit(cln::cl_RA(1));
  const auto equals = [](int l, int row, int column, const Surd& factor, const Polynomial& p) {
    return vanishes({term(-1, Polynomial(1), l, row, column), {factor, p}});
  };
  return equals(0, 0, 0, unit, Polynomial(1)) && equals(1, 0, 0, unit, cos_b()) && equals(1, 1, -1, unit, s * s) &&
         equals(1, 1, 0, -surd_root(ratio(1, 2)), 2 * (s * c)) && equals(1, 1, 1, unit, c * c);
}

bool eq_64_holds() {
  return every_entry(2, [](int l, int m1, int m) {
    if (std::abs(m1) == l || std::abs(m) == l) return true;  // outside its range: the root below vanishes
    const Surd outer = Surd(cln::cl_RA(l * (2 * l - 1))) / surd_root((l * l - m * m) * (l * l - m1 * m1));
    std::vector<SurdTerm> sum{term(-1, Polynomial(1), l, m1, m),
                              term(outer, cos_b() - ratio(m * m1, l * (l - 1)) * one(), l - 1, m1, m)};
    if (std::abs(m1) < l - 1 && std::abs(m) < l - 1) {
      const int k = (l - 1) * (l - 1);
      const Surd inner = surd_root((k - m * m) * (k - m1 * m1)) / Surd(cln::cl_RA((l - 1) * (2 * l - 1)));
      sum.push_back(term(-(outer * inner), one().power(2), l - 2, m1, m));
    }
    return vanishes(sum);
  });
}

bool eq_65_holds() {
  for (int l = 1; l <= kIdentityDegree; ++l) {
    const Polynomial d_11 = cosine_half().power(2);
    if (!vanishes({term(-1, Polynomial(1), l, l, l), term(1, d_11, l - 1, l - 1, l - 1)})) return false;
  }
  return true;
}

bool eq_66_holds() {
  for (int l = 1; l <= kIdentityDegree; ++l) {
    const Polynomial factor = cln::cl_RA(l) * cos_b() - cln::cl_RA(l - 1) * one();
    if (!vanishes({term(-1, Polynomial(1), l, l - 1, l - 1), term(1, factor, l - 1, l - 1, l - 1)})) return false;
  }
  return true;
}

// Eqs. 67 and 68 with sqrt(d^1_{1,-1} / d^1_11) = tan(b/2), multiplied out.
bool row_identities_hold() {
  for (int l = 1; l <= kIdentityDegree; ++l) {
    for (int m = 1 - l; m <= l; ++m) {
      const Surd down = -surd_root(ratio(l + m, l - m + 1));
      const Surd minus(cln::cl_RA(-1));
      if (!vanishes({term(minus, cosine_half(), l, l, m - 1), term(down, sine_half(), l, l, m)})) return false;
      if (m == l || m == 1 - l) continue;
      const Polynomial here = cln::cl_RA(l) * cos_b() - cln::cl_RA(m) * one();
      const Polynomial next = here + one();
      if (!vanishes(
              {term(minus, here * cosine_half(), l, l - 1, m - 1), term(down, next * sine_half(), l, l - 1, m)})) {
        return false;
      }
    }
  }
  return true;
}

// (-1)^(l-m-1) sqrt((2l-1)! / ((l+m)! (l-m)!)) (l cos b - m) c^(l+m-1) s^(l-m-1), |m| < l
bool closed_form_of_eq_68_holds() {
  for (int l = 1; l <= kIdentityDegree; ++l) {
    for (int m = 1 - l; m < l; ++m) {
      const auto factorial = [](int n) { return cln::factorial(static_cast<unsigned>(n)); };
      const Surd size = surd_root(cln::cl_RA(factorial(2 * l - 1)) / (factorial(l + m) * factorial(l - m)));
      const Polynomial p = (cln::cl_RA(l) * cos_b() - cln::cl_RA(m) * one()) * cosine_half().power(l + m - 1) *
                           sine_half().power(l - m - 1);
      if (!vanishes({term(-1, Polynomial(1), l, l - 1, m), {parity(l - m - 1) > 0 ? size : -size, p}})) return false;
    }
  }
  return true;
}

using HalfAngle = CosSin<cln::cl_RA>;

// Half angles with rational cosine and sine, b inside (0, pi), none with cos b = m/l for l <= kHighestBand.
std::vector<HalfAngle> inner_angles() {
  return {{ratio(12, 13), ratio(5, 13)}, {ratio(3, 5), ratio(4, 5)}, {ratio(8, 17), ratio(15, 17)}};
}

// Whether the recurrence is defined at b and gives the row of d^l.
template <class Row>
bool row_holds_at(const HalfAngle& half, const Row& row_by_recurrence, int row_below_top) {
  for (int l = 1 + row_below_top; l <= kHighestBand; ++l) {
    const int row = l - row_below_top;
    const auto values = row_by_recurrence(l, doubled(half).cosine, wigner_value(l, row, row, half));
    if (!values) return false;
    for (int m = -row; m <= row; ++m) {
      if (!((*values)[to_size(row + m)] == wigner_value(l, row, m, half))) return false;
    }
  }
  return true;
}

bool eq_67_at(const HalfAngle& half) { return row_holds_at(half, blanco_top_row, 0); }
bool eq_68_at(const HalfAngle& half) { return row_holds_at(half, blanco_second_row, 1); }

bool eq_67_inside() {
  for (const HalfAngle& half : inner_angles()) {
    if (!eq_67_at(half)) return false;
  }
  return row_identities_hold();
}
bool eq_67_at_pi() { return eq_67_at({0, 1}); }
bool eq_67_below_zero() { return eq_67_at({ratio(12, 13), ratio(-5, 13)}); }

bool eq_68_inside() {
  for (const HalfAngle& half : inner_angles()) {
    if (!eq_68_at(half)) return false;
  }
  return row_identities_hold();
}
// cos b = m/l = 0 is b = pi/2 with m = 0; cos b = 1/3 and 1/2 fail alike.
bool eq_68_at_right_angle() { return blanco_second_row(2, 0, RadicalSum(ratio(-1, 2))).has_value(); }
bool eq_68_at_pi() { return eq_68_at({0, 1}); }

bool recurrences_hold_at(const HalfAngle& half) {
  const auto bands = blanco_bands(kHighestBand, doubled(half));
  if (!bands) return false;
  for (int l = 0; l <= kHighestBand; ++l) {
    for (int m1 = -l; m1 <= l; ++m1) {
      for (int m = -l; m <= l; ++m) {
        if (!((*bands)[to_size(l)](l + m1, l + m) == wigner_value(l, m1, m, half))) return false;
      }
    }
  }
  return true;
}

bool recurrences_inside() {
  for (const HalfAngle& half : inner_angles()) {
    if (!recurrences_hold_at(half)) return false;
  }
  return true;
}
bool recurrences_at_right_angle() { return blanco_bands(2, {0, 1}).has_value(); }
bool recurrences_at_pi() { return recurrences_hold_at({0, 1}); }

}  // namespace

std::vector<Entry> blanco() {
  return {
      {"BL-01",
       "Eq. 8 Phi_m",
       Kind::kEquation,
       Print::kReport,
       "Phi_m = sqrt2 cos(m p) (m > 0), 1 (m = 0), sqrt2 sin(|m| p) (m < 0)",
       Verdict::kCorrect,
       {{"INT_0^2pi Phi_m Phi_n dp = 2 pi delta_mn, |m| <= 8", azimuthal_functions_hold}},
       "",
       nullptr,
       ""},
      {"BL-02",
       "D^l_{m'm}(a,b,g)",
       Kind::kEquation,
       Print::kReport,
       "D^l_{m'm}(a,b,g) = e^{-i m' a} d^l_{m'm}(b) e^{-i m g}",
       Verdict::kCorrect,
       {{"D_{m'm} = INT conj Y_m'(s) Y_m(R^-1 s) ds, R = Rz(a) Ry(b) Rz(g), Condon-Shortley", zyz_form_holds}},
       "",
       nullptr,
       "The real matrix of the same R, from quaternions, taken to the complex basis, agrees to l = 6."},
      {"BL-03",
       "Eq. 38 symmetries",
       Kind::kEquation,
       Print::kReport,
       "d_{m'm} = (-1)^{m'-m} d_{mm'} = d_{-m,-m'} = (-1)^{m'-m} d_{-m',-m}",
       Verdict::kCorrect,
       {{"identities in b, l <= 8", symmetries_hold}},
       "",
       nullptr,
       ""},
      {"BL-04",
       "Real rotation matrix from d",
       Kind::kEquation,
       Print::kReport,
       "R_{mm'} = sgn(m') Phi_m(a) Phi_m'(g) (d_{|m'||m|} + (-1)^m d_{|m|,-|m'|})/2 - sgn(m) Phi_{-m}(a) Phi_{-m'}(g) "
       "(d_{|m'||m|} - (-1)^m d_{|m|,-|m'|})/2, sgn(0) = 1",
       Verdict::kUnderReading,
       {{"m is the row, m' the column: D(Rz(a) Ry(b) Rz(g))", real_form_row_first},
        {"m' is the row, m the column", real_form_column_first},
        {"the indices of each d exchanged, either way round", real_form_swapped}},
       "as printed, row m and column m'",
       real_form_row_first,
       "The text is second-hand, from a public port."},
      {"BL-05",
       "Eqs. 48-52 start values",
       Kind::kEquation,
       Print::kReport,
       "d^0_00 = 1; d^1_00 = cos b; d^1_{1,-1} = sin^2(b/2); d^1_{1,0} = -sin(b)/sqrt2; d^1_11 = cos^2(b/2)",
       Verdict::kCorrect,
       {{"identities in b", start_values_hold}},
       "",
       nullptr,
       ""},
      {"BL-06",
       "Eq. 64",
       Kind::kEquation,
       Print::kReport,
       "d^l_{m'm} = l(2l-1)/sqrt((l^2-m^2)(l^2-m'^2)) { (d^1_00 - mm'/(l(l-1))) d^{l-1}_{m'm} - "
       "sqrt(((l-1)^2-m^2)((l-1)^2-m'^2))/((l-1)(2l-1)) d^{l-2}_{m'm} }",
       Verdict::kCorrect,
       {{"identity in b, |m|, |m'| < l, l = 2..8", eq_64_holds}},
       "",
       nullptr,
       "The paper uses it for |m|, |m'| <= l-2; where an order is l-1 the last term has the factor 0."},
      {"BL-07",
       "Eq. 65",
       Kind::kEquation,
       Print::kReport,
       "d^l_{ll} = d^1_11 d^{l-1}_{l-1,l-1}",
       Verdict::kCorrect,
       {{"identity in b, l <= 8", eq_65_holds}},
       "",
       nullptr,
       "That is cos^{2l}(b/2)."},
      {"BL-08",
       "Eq. 66",
       Kind::kEquation,
       Print::kReport,
       "d^l_{l-1,l-1} = (l d^1_00 - l + 1) d^{l-1}_{l-1,l-1}",
       Verdict::kCorrect,
       {{"identity in b, l <= 8", eq_66_holds}},
       "",
       nullptr,
       ""},
      {"BL-09",
       "Eq. 67",
       Kind::kEquation,
       Print::kReport,
       "d^l_{l,m-1} = -sqrt((l+m)/(l-m+1)) sqrt(d^1_{1,-1}/d^1_11) d^l_{l,m}",
       Verdict::kUnderReading,
       {{"0 <= b < pi", eq_67_inside}, {"b = pi", eq_67_at_pi}, {"-pi < b < 0", eq_67_below_zero}},
       "cos(b/2) d^l_{l,m-1} = -sqrt((l+m)/(l-m+1)) sin(b/2) d^l_{l,m}",
       row_identities_hold,
       "At b = pi it divides by zero, although Euler angles reach it; below 0 the root has the wrong sign."},
      {"BL-10",
       "Eq. 68",
       Kind::kEquation,
       Print::kReport,
       "d^l_{l-1,m-1} = -(l d^1_00 - m + 1)/(l d^1_00 - m) sqrt((l+m)/(l-m+1)) sqrt(d^1_{1,-1}/d^1_11) d^l_{l-1,m}",
       Verdict::kUnderReading,
       {{"0 <= b < pi, cos b other than m/l", eq_68_inside},
        {"cos b = m/l, as b = pi/2 with m = 0", eq_68_at_right_angle},
        {"b = pi", eq_68_at_pi}},
       "d^l_{l-1,m} = (-1)^{l-m-1} sqrt((2l-1)!/((l+m)!(l-m)!)) (l cos b - m) cos^{l+m-1}(b/2) sin^{l-m-1}(b/2), "
       "|m| < l",
       closed_form_of_eq_68_holds,
       "A 0/0 at the very angle that z-x90-z needs; the closed form has no hole."},
      {"BL-11",
       "Recurrences 65-68 as a whole",
       Kind::kText,
       Print::kReport,
       "64 for |m|, |m'| <= l-2, 65-68 for the rows l and l-1, the rest by the symmetries 38",
       Verdict::kUnderReading,
       {{"0 < b < pi, cos b no m/l: all of d to l = 6", recurrences_inside},
        {"b = pi/2", recurrences_at_right_angle},
        {"b = pi", recurrences_at_pi}},
       "rows l and l-1 by the closed forms of BL-09 and BL-10",
       closed_form_of_eq_68_holds,
       "A public port notes that something is wrong near row l-1; the holes of 67 and 68 would explain it (not proved "
       "to be its cause)."},
  };
}

}  // namespace sh::symbolic::errata
