// Ivanic and Ruedenberg 1996 with the corrections of 1998: the recursion for real rotation matrices.
//
// Decided in two ways: the whole recursion on exact rotations, and the coefficient of every _iP_{mu} on its own, which
// must be the integral of Y_lm (y, z or x) Y_(l-1,mu) over the one for the column.
#include <map>
#include <utility>

#include "symbolic/basis/normalisation.hpp"
#include "symbolic/errata/errata.hpp"
#include "symbolic/errata/ivanic_ruedenberg_tables.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kCouplingBand = 8;

// Coordinates in the order of i = -1, 0, 1: y, z, x.
Polynomial coordinate(int i) { return Polynomial::variable((i + 2) % 3); }

Matrix<RadicalSum> first_band(const Matrix<cln::cl_RA>& r) {
  Matrix<RadicalSum> band(3, 3);
  for (int m = -1; m <= 1; ++m) {
    for (int n = -1; n <= 1; ++n) band(1 + m, 1 + n) = RadicalSum(r((m + 2) % 3, (n + 2) % 3));
  }
  return band;
}

bool first_band_of_columns() {
  for (const ExactRotation& rotation : sample_rotations()) {
    if (!(first_band(rotation.matrix) == rotation.real[1])) return false;
  }
  return true;
}

bool first_band_of_rows() {
  for (const ExactRotation& rotation : sample_rotations()) {
    if (!(first_band(rotation.matrix.transposed()) == rotation.real[1])) return false;
  }
  return true;
}

bool recursion_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    const Matrix<RadicalSum> first = first_band(rotation.matrix);
    Matrix<RadicalSum> band = first;
    for (int l = 2; l <= kHighestBand; ++l) {
      band = ivanic_ruedenberg_band(first, band, LowerV::kDerived);
      if (!(band == rotation.real[to_size(l)])) return false;
    }
  }
  return true;
}

// One step from an exact band: what is wrong in a row stays in that row.
bool step_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 2; l <= kHighestBand; ++l) {
      const auto& below = rotation.real[to_size(l - 1)];
      const auto band = ivanic_ruedenberg_band(rotation.real[1], below, LowerV::kDerived);
      if (!(band == rotation.real[to_size(l)])) return false;
    }
  }
  return true;
}

// A linear form in the _iP_{mu}: (i, mu) -> coefficient, none of them zero.
class Form {
 public:
  Form() = default;
  Form(int i, int mu) { terms_[{i, mu}] = RadicalSum(cln::cl_RA(1)); }
  void add(int i, int mu, const RadicalSum& coefficient) {
    RadicalSum& sum = terms_[{i, mu}];
    sum += coefficient;
    if (sum.is_zero()) terms_.erase({i, mu});
  }
  friend Form operator+(Form a, const Form& b) {
    for (const auto& [at, coefficient] : b.terms_) a.add(at.first, at.second, coefficient);
    return a;
  }
  friend Form operator*(const RadicalSum& factor, const Form& a) {
    Form result;
    for (const auto& [at, coefficient] : a.terms_) result.add(at.first, at.second, factor * coefficient);
    return result;
  }
  friend bool operator==(const Form& a, const Form& b) { return a.terms_ == b.terms_; }

 private:
  std::map<std::pair<int, int>, RadicalSum> terms_;
};

// INT Y_lm w_i Y_(l-1,mu), w = (y, z, x), by exact integration.
RadicalSum coupling(int l, int m, int i, int mu) {
  const BasisFunction above = reduced_basis_function(l, m);
  const BasisFunction below = reduced_basis_function(l - 1, mu);
  const Polynomial product = above.axial * below.axial * coordinate(i) * (above.azimuthal * below.azimuthal);
  const Surd sphere(4 * sphere_mean(product));
  return RadicalSum(sphere * Surd::square_root(1, 2) * above.factor * below.factor);
}

struct Coefficient {
  int i;
  int mu;
  RadicalSum integral;
};

// Row m of band l: every i and mu.
std::vector<Coefficient> couplings_of_row(int l, int m) {
  std::vector<Coefficient> row;
  for (int i = -1; i <= 1; ++i) {
    for (int mu = 1 - l; mu < l; ++mu) row.push_back({i, mu, coupling(l, m, i, mu)});
  }
  return row;
}

const std::vector<Coefficient>& cached_row(int l, int m) {
  static std::map<std::pair<int, int>, std::vector<Coefficient>> rows;
  auto& row = rows[{l, m}];
  if (row.empty()) row = couplings_of_row(l, m);
  return row;
}

enum class Part { kU, kV, kW };

// U keeps mu = m, V goes to the smaller |mu| (from m = 0 to 1), W to the larger.
Part part_of(int m, int i, int mu) {
  if (i == 0) return Part::kU;
  return m == 0 || std::abs(mu) < std::abs(m) ? Part::kV : Part::kW;
}

Form expected(int l, int m, int n, Part part) {
  const RadicalSum inverse = root(ratio((2 * l + 1) * (2 * l - 1), table_one_denominator(l, n)));
  Form form;
  for (const Coefficient& c : cached_row(l, m)) {
    if (part_of(m, c.i, c.mu) == part) form.add(c.i, c.mu, inverse * c.integral);
  }
  return form;
}

Form printed(int l, int m, int n, Part part, LowerV lower) {
  const auto p = [](int i, int mu) { return Form(i, mu); };
  const TableOne t = table_one(l, m, n);
  switch (part) {
    case Part::kU:
      return t.u * table_two_u<Form>(m, p);
    case Part::kV:
      return t.v * table_two_v<Form>(m, p, lower);
    default:
      return t.w * table_two_w<Form>(m, p);
  }
}

template <class Rows>
bool part_holds(Part part, LowerV lower, const Rows& rows) {
  for (int l = 2; l <= kCouplingBand; ++l) {
    for (int m = -l; m <= l; ++m) {
      if (!rows(m)) continue;
      for (const int n : {-l, 1 - l, 0, l}) {
        if (!(printed(l, m, n, part, lower) == expected(l, m, n, part))) return false;
      }
    }
  }
  return true;
}

bool every_row(int /*m*/) { return true; }

bool table_one_holds() {
  return part_holds(Part::kU, LowerV::kDerived, every_row) && part_holds(Part::kV, LowerV::kDerived, every_row) &&
         part_holds(Part::kW, LowerV::kDerived, every_row);
}

bool u_holds() { return part_holds(Part::kU, LowerV::kDerived, every_row); }
bool upper_v_holds() {
  return part_holds(Part::kV, LowerV::kDerived, [](int m) { return m >= 0; });
}
bool lower_v_holds(LowerV lower) {
  return part_holds(Part::kV, lower, [](int m) { return m < 0; });
}
bool lower_v_of_1998() { return lower_v_holds(LowerV::kPrint98); }
bool lower_v_of_1996() { return lower_v_holds(LowerV::kPrint96); }
bool lower_v_derived() { return lower_v_holds(LowerV::kDerived); }
bool w_holds() { return part_holds(Part::kW, LowerV::kDerived, every_row); }

// p on the sphere, as a multiple of the unit of Y_lm: factor(l,m) / unit.
Polynomial in_units(const RadicalSum& coefficient, int l, int m, const Surd& unit) {
  if (std::abs(m) > l) return {};
  const BasisFunction y = reduced_basis_function(l, m);
  const Surd quotient = coefficient.surd() * y.factor / unit;
  return (quotient * Surd::square_root(1)).rational() * (y.axial * y.azimuthal);
}

RadicalSum axial_coefficient(int l, int m) { return root(ratio(l * l - m * m, 4 * l * l - 1)); }

bool product_with_z_holds(int l, int m) {
  const BasisFunction y = reduced_basis_function(l - 1, m);
  const Polynomial left = coordinate(0) * y.axial * y.azimuthal;
  const Polynomial right =
      in_units(axial_coefficient(l, m), l, m, y.factor) + in_units(axial_coefficient(l - 1, m), l - 2, m, y.factor);
  return reduce_on_sphere(left - right).is_zero();
}

// x Y_(l-1,l-1) - y Y_(l-1,1-l) and x Y_(l-1,1-l) + y Y_(l-1,l-1).
bool edge_products_hold(int l) {
  const BasisFunction cosine = reduced_basis_function(l - 1, l - 1);
  const BasisFunction sine = reduced_basis_function(l - 1, 1 - l);
  const Polynomial c = cosine.axial * cosine.azimuthal;
  const Polynomial s = sine.axial * sine.azimuthal;
  const Polynomial& x = coordinate(1);
  const Polynomial& y = coordinate(-1);
  const RadicalSum edge = root(ratio(2 * l, 2 * l + 1));
  return reduce_on_sphere(x * c - y * s - in_units(edge, l, l, cosine.factor)).is_zero() &&
         reduce_on_sphere(x * s + y * c - in_units(edge, l, -l, cosine.factor)).is_zero();
}

bool coordinate_products_hold() {
  for (int l = 2; l <= 10; ++l) {
    for (int m = 1 - l; m < l; ++m) {
      if (!product_with_z_holds(l, m)) return false;
    }
    if (!edge_products_hold(l)) return false;
  }
  return true;
}

// sum over i and mu of (INT Y_lm w_i Y_(l-1,mu)) R^1_{i0} R^(l-1)_{mu,n}
RadicalSum projected(const ExactRotation& rotation, int l, int m, int n) {
  RadicalSum sum;
  for (const Coefficient& c : cached_row(l, m)) {
    sum += c.integral * entry_or_zero(rotation.real[1], c.i, 0) * entry_or_zero(rotation.real[to_size(l - 1)], c.mu, n);
  }
  return sum;
}

bool projection_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 2; l <= 3; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (int n = 1 - l; n < l; ++n) {
          const RadicalSum left = axial_coefficient(l, n) * entry_or_zero(rotation.real[to_size(l)], m, n);
          if (!(left == projected(rotation, l, m, n))) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> ivanic_ruedenberg() {
  return {
      {"IR-01",
       "Eq. 5.8 / start",
       Kind::kEquation,
       Print::kReport,
       "R^1 = [[Ryy,Ryz,Ryx],[Rzy,Rzz,Rzx],[Rxy,Rxz,Rxx]], order m = -1, 0, 1 as (y,z,x)",
       Verdict::kUnderReading,
       {{"R turns columns, s' = R s: R^l is D(R) with c' = D(R) c", first_band_of_columns},
        {"R turns rows, s' = s R: R^l is D(R) with c' = D(R) c", first_band_of_rows}},
       "R^1_{mn} = R_{axis(m),axis(n)}, axis(-1,0,1) = y,z,x, R acting on columns",
       first_band_of_columns,
       "With the transposed R the recursion gives the matrix of the inverse rotation."},
      {"IR-02",
       "Eqs. 6.x",
       Kind::kEquation,
       Print::kReport,
       "products of x, y, z with Y_{l-1,m} in terms of bands l and l-2 (wording not known)",
       Verdict::kUndecided,
       {},
       "z Y_{l-1,m} = A_{l,m} Y_{l,m} + A_{l-1,m} Y_{l-2,m}, A_{l,m} = sqrt((l^2-m^2)/(4l^2-1)); "
       "x Y_{l-1,l-1} - y Y_{l-1,1-l} = sqrt(2l/(2l+1)) Y_{l,l}; "
       "x Y_{l-1,1-l} + y Y_{l-1,l-1} = sqrt(2l/(2l+1)) Y_{l,-l}, l >= 2",
       coordinate_products_hold,
       "The printed text is not known to us; what the recursion needs is proved to l = 10."},
      {"IR-03",
       "Eqs. 7.x",
       Kind::kEquation,
       Print::kReport,
       "rotated products compared, band l kept: the recursion (wording not known)",
       Verdict::kUndecided,
       {},
       "sqrt((l^2-n^2)/(4l^2-1)) R^l_{mn} = sum_{i,mu} (INT Y_lm w_i Y_{l-1,mu}) R_{i0} R^{l-1}_{mu,n}, |n| < l, "
       "w = (y,z,x)",
       projection_holds,
       "The printed text is not known to us; the step is checked on exact rotations."},
      {"IR-04",
       "Eq. 8.1",
       Kind::kEquation,
       Print::kReport,
       "R^l_{mn} = u U + v V + w W",
       Verdict::kCorrect,
       {{"with Tables 1 and 2, V for m < 0 as in IR-09", recursion_holds}},
       "",
       nullptr,
       "The recursion from R^1 equals the quaternion form of D in every entry to l = 6, at two exact rotations."},
      {"IR-05",
       "Table 1 (corrected form)",
       Kind::kTable,
       Print::kReport,
       "u = sqrt((l+m)(l-m)/d), v = 1/2 sqrt((1+d0)(l+|m|-1)(l+|m|)/d)(1-2 d0), "
       "w = -1/2 sqrt((l-|m|-1)(l-|m|)/d)(1-d0); d = (l+n)(l-n) for |n| < l, 2l(2l-1) for |n| = l; d0 = delta_{m0}",
       Verdict::kCorrect,
       {{"with U, V, W of Table 2, V for m < 0 as in IR-09", table_one_holds}},
       "",
       nullptr,
       "Every coefficient is the exact integral of Y_lm (y,z,x) Y_{l-1,mu} over that of the column, l = 2..8."},
      {"IR-06",
       "Table 2, P",
       Kind::kTable,
       Print::kReport,
       "_iP_{mu,n} = R_{i,0} R^{l-1}_{mu,n} (|n| < l); R_{i,1} R^{l-1}_{mu,l-1} - R_{i,-1} R^{l-1}_{mu,-l+1} (n = l); "
       "R_{i,1} R^{l-1}_{mu,-l+1} + R_{i,-1} R^{l-1}_{mu,l-1} (n = -l)",
       Verdict::kCorrect,
       {{"one step from the exact band l-1, l = 2..6", step_holds}},
       "",
       nullptr,
       "Terms whose mu leaves -l+1..l-1 always meet a coefficient zero."},
      {"IR-07",
       "Table 2, U",
       Kind::kTable,
       Print::kReport,
       "U = _0P_{m,n} for m = 0, m > 0, m < 0",
       Verdict::kCorrect,
       {{"u U carries what R_{0.} contributes", u_holds}},
       "",
       nullptr,
       "The three printed cases are one."},
      {"IR-08",
       "Table 2, V, m >= 0",
       Kind::kTable,
       Print::kReport,
       "m = 0: _1P_1 + _{-1}P_{-1}; m > 0: _1P_{m-1} sqrt(1+d) - _{-1}P_{-m+1} (1-d), d = delta_{m1}",
       Verdict::kCorrect,
       {{"v V carries what x and y contribute at the smaller |mu|", upper_v_holds}},
       "",
       nullptr,
       ""},
      {"IR-09",
       "Table 2, V, m < 0",
       Kind::kTable,
       Print::kReport,
       "1998: _1P_{m+1} (1-d) + _{-1}P_{-m-1} sqrt(1-d); 1996: _1P_{m+1} (1+d) + _{-1}P_{-m-1} sqrt(1-d); "
       "d = delta_{m,-1}",
       Verdict::kWrong,
       {{"as corrected in 1998: (1-d), sqrt(1-d)", lower_v_of_1998},
        {"as in 1996 and in Green's appendix: (1+d), sqrt(1-d)", lower_v_of_1996}},
       "V = (1-d) _1P_{m+1} + sqrt(1+d) _{-1}P_{-m-1}, d = delta_{m,-1}",
       lower_v_derived,
       "Both go wrong in the row m = -1 only: its single term is sqrt(2) _{-1}P_0. The printed text is second-hand, "
       "from the errata noted in google/spherical-harmonics."},
      {"IR-10",
       "Table 2, W",
       Kind::kTable,
       Print::kReport,
       "m > 0: _1P_{m+1} + _{-1}P_{-m-1}; m < 0: _1P_{m-1} - _{-1}P_{-m+1}; m = 0: not needed",
       Verdict::kCorrect,
       {{"w W carries what x and y contribute at the larger |mu|", w_holds}},
       "",
       nullptr,
       "w = 0 for m = 0."},
  };
}

}  // namespace sh::symbolic::errata
