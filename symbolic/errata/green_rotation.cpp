// [Green03] Rotating Spherical Harmonics, G-58 to G-62: the matrix by integration, in general and about z.
//
// Every matrix is compared with integrals of rotated basis functions (exact_integrals.hpp). Bands 0 to 2 are the 9x9
// matrices of the paper.
#include <ginac/ginac.h>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/rotation/rotation_axis.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kPaperDegree = 2;  // three bands
constexpr int kCosine = 3;       // variables of an angle
constexpr int kSine = 4;

Polynomial one() { return Polynomial(1); }
Polynomial symbol(int index) { return Polynomial::variable(index); }

Matrix<Polynomial> about_z_symbolic() {
  return matrix_about_axis<Polynomial>(2, {symbol(kCosine), symbol(kSine)}, one());
}

// Band l of a rotation given by polynomials in variables 0, 1 = cos, sin, with the variables of this file.
Matrix<Polynomial> with_angle_variables(const Matrix<Polynomial>& band) {
  Matrix<Polynomial> result(band.rows(), band.columns());
  for (int i = 0; i < band.rows(); ++i) {
    for (int j = 0; j < band.columns(); ++j) {
      for (const auto& [monomial, coefficient] : band(i, j).terms()) {
        result(i, j).add_term({0, 0, 0, monomial.exponent(0), monomial.exponent(1)}, coefficient);
      }
    }
  }
  return result;
}

// G-58: integrals of Y_i(M(q) s) Y_j(s) over different bands, as polynomials in q.
bool bands_do_not_mix(int degree) {
  const Matrix<Polynomial> r = matrix_from_quaternion<Polynomial>({symbol(3), symbol(4), symbol(5), symbol(6)});
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Polynomial rotated = turned(solid_harmonic(l, m), r);
      for (int other = 0; other <= degree; ++other) {
        if (other == l) continue;
        for (int n = -other; n <= other; ++n) {
          if (!mean_over_sphere(rotated * solid_harmonic(other, n)).is_zero()) return false;
        }
      }
    }
  }
  return true;
}
bool four_bands_do_not_mix() { return bands_do_not_mix(3); }

// G-59: factor * polynomial / r^l, in the order of the index.
bool cartesian_table_is_the_basis() {
  struct Row {
    Surd factor;
    Polynomial numerator;
  };
  const Polynomial x = symbol(0);
  const Polynomial y = symbol(1);
  const Polynomial z = symbol(2);
  const auto factor = [](int part, int square) {
    return Surd(cln::cl_RA(1) / part) * Surd::square_root(square, -1);  // sqrt(square / pi) / part
  };
  const std::vector<Row> table{{factor(2, 1), one()},
                               {factor(2, 3), y},
                               {factor(2, 3), z},
                               {factor(2, 3), x},
                               {factor(2, 15), x * y},
                               {factor(2, 15), y * z},
                               {factor(4, 5), 2 * (z * z) - x * x - y * y},
                               {factor(2, 15), x * z},
                               {factor(4, 15), x * x - y * y}};
  std::size_t i = 0;
  for (int l = 0; l <= kPaperDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Row& row = table[i++];
      const BasisFunction exact = basis_function(l, m);
      const Surd ratio = exact.factor / row.factor;
      if (ratio.radicand() != 1 || ratio.pi_half_power() != 0) return false;
      if (!(row.numerator == ratio.rational() * exact.homogeneous)) return false;
    }
  }
  return true;
}

// G-60: what the matrix of integrals does to a function, by projecting the rotated function itself.
enum class Carrier { kFirst, kSecond };                  // which factor of the integrand is rotated
enum class Meaning { kInverseArgument, kSameArgument };  // the rotated f is f(R^-1 s) or f(R s)

template <Carrier carrier, Meaning meaning>
bool integral_matrix_rotates() {
  const Matrix<Polynomial> r = rational_rotation();
  const Matrix<Polynomial> argument = meaning == Meaning::kInverseArgument ? r.transposed() : r;
  for (int l = 0; l <= kPaperDegree; ++l) {
    for (int i = -l; i <= l; ++i) {
      for (int j = -l; j <= l; ++j) {
        const Polynomial first = solid_harmonic(l, i);
        const Polynomial second = solid_harmonic(l, j);
        const Polynomial printed = carrier == Carrier::kFirst ? turned(first, r) * second : first * turned(second, r);
        const Polynomial projected = turned(second, argument) * first;  // coefficient i of the rotated Y_j
        if (sphere_mean(printed) != sphere_mean(projected)) return false;
      }
    }
  }
  return true;
}

// G-61: the same about z, alpha a symbol.
template <Carrier carrier>
bool z_integral_is_rotation_by_alpha() {
  for (int l = 0; l <= kPaperDegree; ++l) {
    const Matrix<Polynomial> integral = band_by_integration(l, about_z_symbolic());
    // About z every entry joins orders of the same |m|, so k_n/k_m = 1 and the transpose is the other integral.
    const Matrix<Polynomial> printed = carrier == Carrier::kFirst ? integral : integral.transposed();
    const Matrix<Polynomial> expected = with_angle_variables(rotation_about_z(l));
    if (!(reduce_circle(printed, kCosine, kSine) == reduce_circle(expected, kCosine, kSine))) return false;
  }
  return true;
}

// Theta over a full turn and phi over half a turn: the entry of Y_00 should be 1.
bool exchanged_limits_keep_the_constant() {
  const GiNaC::ex theta = GiNaC::cos(GiNaC::ex(0)) - GiNaC::cos(2 * GiNaC::Pi);
  return (GiNaC::Pi * theta / (4 * GiNaC::Pi)).is_equal(1);
}

// G-62: bands 0 to 2 entry by entry; the rest of the 9x9 matrix is zero.
bool nine_by_nine_about_z() {
  struct Entry9 {
    int row;
    int column;
    Polynomial value;
  };
  const Polynomial c = symbol(kCosine);
  const Polynomial s = symbol(kSine);
  const Polynomial c2 = c * c - s * s;  // cosine and sine of twice the angle
  const Polynomial s2 = 2 * (c * s);
  const std::vector<Entry9> table{{0, 0, one()}, {1, 1, c},      {1, 3, s},  {2, 2, one()},   {3, 1, -1 * s},
                                  {3, 3, c},     {4, 4, c2},     {4, 8, s2}, {5, 5, c},       {5, 7, s},
                                  {6, 6, one()}, {7, 5, -1 * s}, {7, 7, c},  {8, 4, -1 * s2}, {8, 8, c2}};
  Matrix<Polynomial> printed(9, 9);
  for (const Entry9& entry : table) printed(entry.row, entry.column) = entry.value;
  Matrix<Polynomial> exact(9, 9);
  for (int l = 0; l <= kPaperDegree; ++l) {
    const Matrix<Polynomial> band = band_by_integration(l, about_z_symbolic());
    for (int i = 0; i <= 2 * l; ++i) {
      for (int j = 0; j <= 2 * l; ++j) exact(l * l + i, l * l + j) = band(i, j);
    }
  }
  return reduce_circle(printed, kCosine, kSine) == reduce_circle(exact, kCosine, kSine);
}

}  // namespace

std::vector<Entry> green_rotation() {
  constexpr auto kFirst = Carrier::kFirst;
  constexpr auto kSecond = Carrier::kSecond;
  constexpr auto kInverse = Meaning::kInverseArgument;
  constexpr auto kSame = Meaning::kSameArgument;
  return {
      {"G-58",
       "Rotating Spherical Harmonics, text",
       Kind::kText,
       Print::kRead,
       "rotation of coefficients: linear, n^2 x n^2, block diagonal by bands, 'from orthogonality'",
       Verdict::kCorrect,
       {{"INT Y_i(R s) Y_j(s) ds = 0 between different bands, for every quaternion", four_bands_do_not_mix}},
       "",
       nullptr,
       "The reason is that rotations keep harmonic polynomials of degree l; orthogonality alone would not give it."},
      {"G-59",
       "Eq. 10",
       Kind::kTable,
       Print::kLost,
       "table of the first functions in x, y, z and r = sqrt(x^2+y^2+z^2), normally 1",
       Verdict::kDerived,
       {},
       "1/2 sqrt(1/pi); 1/2 sqrt(3/pi) (y,z,x)/r; 1/2 sqrt(15/pi) (xy, yz, xz)/r^2 at m = -2,-1,1; "
       "1/4 sqrt(5/pi) (2z^2-x^2-y^2)/r^2; 1/4 sqrt(15/pi) (x^2-y^2)/r^2",
       cartesian_table_is_the_basis,
       "With the Condon-Shortley sign of the paper's code the functions of odd m change sign. The text calls the value "
       "of a function in a direction its coefficient."},
      {"G-60",
       "Rotation matrix by integration",
       Kind::kEquation,
       Print::kRead,
       "M_ij = INT_S y_i(R s) y_j(s) ds maps unrotated to rotated coefficients",
       Verdict::kUnderReading,
       {{"R on y_i; rotated f is f(R^-1 s)", integral_matrix_rotates<kFirst, kInverse>},
        {"R on y_i; rotated f is f(R s)", integral_matrix_rotates<kFirst, kSame>},
        {"R on y_j; rotated f is f(R^-1 s)", integral_matrix_rotates<kSecond, kInverse>},
        {"R on y_j; rotated f is f(R s)", integral_matrix_rotates<kSecond, kSame>}},
       "M_ij = INT y_i(R s) y_j(s) ds for (R f)(s) = f(R^-1 s)",
       integral_matrix_rotates<kFirst, kInverse>,
       "The place of R did not survive well and 'rotated' is not defined; the paper's rotational invariance uses f(R "
       "s), "
       "which takes the transpose."},
      {"G-61",
       "Rotation about z by integration",
       Kind::kEquation,
       Print::kRead,
       "M_ij = INT_0^pi INT_0^2pi y_i(theta, phi+alpha) y_j(theta, phi) sin(theta) dphi dtheta",
       Verdict::kUnderReading,
       {{"alpha in y_i: the rotation by +alpha", z_integral_is_rotation_by_alpha<kFirst>},
        {"alpha in y_j: the rotation by +alpha", z_integral_is_rotation_by_alpha<kSecond>},
        {"limits exchanged, theta to 2 pi and phi to pi: M_00 = 1", exchanged_limits_keep_the_constant}},
       "band 1 in the order y, z, x: [[c,0,s],[0,1,0],[-s,0,c]]",
       z_integral_is_rotation_by_alpha<kFirst>,
       "The extracted glyphs do not say which factor carries alpha, nor which limits belong to which angle."},
      {"G-62",
       "9x9 matrix about z",
       Kind::kTable,
       Print::kLost,
       "rotation about z of three bands; band N uses the sine and cosine of N alpha",
       Verdict::kDerived,
       {},
       "on orders (-m, m): [[cos m a, sin m a], [-sin m a, cos m a]]; 1 for m = 0",
       nine_by_nine_about_z,
       "Band N also uses all smaller multiples of alpha. The Condon-Shortley sign changes nothing here."},
  };
}

}  // namespace sh::symbolic::errata
