// [Green03] ZYZ Euler angles, G-63 to G-70: z-x90-z products, the matrix of two bands in sines and cosines, and the way
// back.
//
// Everything is an identity of polynomials in the cosines and sines of three angles.
#include <array>

#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/rotation/quaternion_rotation.hpp"
#include "symbolic/rotation/rotation_axis.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic::errata {
namespace {

using Angle = CosSin<Polynomial>;

Polynomial one() { return Polynomial(1); }
Angle angle(int index) { return {Polynomial::variable(3 + 2 * index), Polynomial::variable(4 + 2 * index)}; }
Angle alpha() { return angle(0); }
Angle beta() { return angle(1); }
Angle gamma() { return angle(2); }

Matrix<Polynomial> zyz(const Angle& first, const Angle& second, const Angle& third) {
  return matrix_from_euler<Polynomial>("zyz", EulerFrame::kIntrinsic, {first, second, third}, one());
}

Matrix<Polynomial> about_axis(int axis, const Angle& turn) { return matrix_about_axis<Polynomial>(axis, turn, one()); }

// G-63
Matrix<Polynomial> quarter_turn_about_x(int sign) {
  return matrix_about_axis<Polynomial>(0, {Polynomial(), Polynomial(sign)}, one());
}

template <EulerFrame frame>
bool y_rotation_from_quarter_turns() {
  const Matrix<Polynomial> first = quarter_turn_about_x(1);
  const Matrix<Polynomial> last = quarter_turn_about_x(-1);
  const Matrix<Polynomial> product =
      frame == EulerFrame::kExtrinsic ? last * about_axis(2, beta()) * first : first * about_axis(2, beta()) * last;
  return product == about_axis(1, beta());
}

// Rz Ry has a zero at (z, y) for all angles, Ry Rz at (y, z); a rotation without zeros is out of their reach.
bool two_rotations_reach_every_orientation() {
  const Matrix<Polynomial> about_z = about_axis(2, alpha());
  const Matrix<Polynomial> about_y = about_axis(1, beta());
  const Matrix<Polynomial> wanted = rational_rotation();
  const auto may_be = [&wanted](const Matrix<Polynomial>& product) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (product(i, j).is_zero() && !wanted(i, j).is_zero()) return false;
      }
    }
    return true;
  };
  return may_be(about_z * about_y) || may_be(about_y * about_z);
}

// G-64
Matrix<Surd> x90_by_integration(int degree, int sign) {
  return surd_entries(degree, constants(band_by_integration(degree, quarter_turn_about_x(sign))));
}

bool x90_matrices() {
  const Surd none;
  const Surd plus(1);
  const Surd half(cln::cl_RA(1) / 2);
  const Surd root = half * Surd::square_root(3);
  const Matrix<Surd> first(3, 3, {none, -plus, none, plus, none, none, none, none, plus});
  const Matrix<Surd> second(5, 5, {none, none,  none,  -plus, none,   //
                                   none, -plus, none,  none,  none,   //
                                   none, none,  -half, none,  -root,  //
                                   plus, none,  none,  none,  none,   //
                                   none, none,  -root, none,  half});
  return x90_by_integration(0, 1) == Matrix<Surd>(1, 1, {plus}) && x90_by_integration(1, 1) == first &&
         x90_by_integration(2, 1) == second && x90_by_integration(1, -1) == first.transposed() &&
         x90_by_integration(2, -1) == second.transposed();
}

// G-65
using RationalAngle = CosSin<cln::cl_RA>;

RationalAngle pythagorean(int cosine, int sine, int hypotenuse) {
  return {cln::cl_RA(cosine) / hypotenuse, cln::cl_RA(sine) / hypotenuse};
}
// alpha, beta, gamma
std::array<RationalAngle, 3> rational_angles() {
  return {pythagorean(3, 4, 5), pythagorean(5, 12, 13), pythagorean(-8, 15, 17)};
}

Matrix<cln::cl_RA> z_band(int degree, const RationalAngle& turn) {
  const Matrix<Polynomial> symbolic = rotation_about_z(degree);
  Matrix<cln::cl_RA> result(symbolic.rows(), symbolic.columns());
  for (int i = 0; i < result.rows(); ++i) {
    for (int j = 0; j < result.columns(); ++j) {
      result(i, j) = symbolic(i, j).evaluate(std::array{turn.cosine, turn.sine});
    }
  }
  return result;
}

enum class Vectors { kColumns, kRows };

// The printed product acts on column vectors, or on row vectors (then the last factor comes first and each factor is
// the transpose, which reverses the order for columns). frame and the order of the angles say what it should be.
template <Vectors vectors, EulerFrame frame>
bool product_is_zyz_rotation() {
  const auto [alpha_turn, beta_turn, gamma_turn] = rational_angles();
  const Matrix<cln::cl_RA> r = matrix_from_euler<cln::cl_RA>("zyz", frame, rational_angles(), 1);
  for (int l = 0; l <= 3; ++l) {
    const std::array<Matrix<cln::cl_RA>, 5> printed{z_band(l, gamma_turn), rotation_x90(l, false), z_band(l, beta_turn),
                                                    rotation_x90(l, true), z_band(l, alpha_turn)};
    const auto& [a, b, c, d, e] = printed;
    const Matrix<cln::cl_RA> product = vectors == Vectors::kColumns ? a * b * c * d * e : e * d * c * b * a;
    if (!(product == constants(band_by_integration(l, as_polynomials(r))))) return false;
  }
  return true;
}

// G-66: an entry knows whether it is zero and how many multiplications went into it.
struct Work {
  bool zero = true;
  long multiplications = 0;
  friend Work operator*(const Work& a, const Work& b) { return {a.zero || b.zero, a.zero || b.zero ? 0 : 1}; }
  friend Work operator+(const Work& a, const Work& b) {
    return {a.zero && b.zero, a.multiplications + b.multiplications};
  }
};

bool four_dense_products_of_size_nine() {
  constexpr int kSize = 9;
  const Matrix<Work> dense(kSize, kSize, std::vector<Work>(to_size(kSize * kSize), Work{false, 0}));
  const Matrix<Work> product = dense * dense;
  long count = 0;
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j < kSize; ++j) count += product(i, j).multiplications;
  }
  return 4 * count == 2916;
}

// Applying Z X Z X Z to a vector: entries other than 0, and in Z other than the constant 1.
long sparse_multiplications(int degree) {
  long count = 0;
  for (int l = 0; l <= degree; ++l) {
    const Matrix<Polynomial> z = rotation_about_z(l);
    const Matrix<cln::cl_RA> x = rotation_x90(l);
    for (int i = 0; i <= 2 * l; ++i) {
      for (int j = 0; j <= 2 * l; ++j) {
        if (z(i, j).degree() > 0) count += 3;
        if (!cln::zerop(x(i, j))) count += 2;
      }
    }
  }
  return count;
}

template <int degree>
bool sparse_product_costs_about_340() {
  const long count = sparse_multiplications(degree);
  return count >= 323 && count <= 357;  // within 5 %
}

// G-67: rows and columns (y, z, x) after the constant.
bool first_two_bands() {
  const auto& [ca, sa] = alpha();
  const auto& [cb, sb] = beta();
  const auto& [cg, sg] = gamma();
  const Matrix<Polynomial> printed(3, 3,
                                   {ca * cg - sa * cb * sg, sa * sb, sa * cb * cg + ca * sg,  //
                                    sb * sg, cb, -1 * sb * cg,                                //
                                    -1 * ca * cb * sg - sa * cg, ca * sb, ca * cb * cg - sa * sg});
  const Matrix<Polynomial> r = zyz(alpha(), beta(), gamma());
  return band_by_integration(0, r) == Matrix<Polynomial>(1, 1, {one()}) && band_by_integration(1, r) == printed;
}

// G-68: the identities times sin beta, on the form of R that they are for.
bool angles_from_matrix() {
  const Matrix<Polynomial> r = zyz(alpha(), beta(), gamma());
  const auto& [cb, sb] = beta();
  const Polynomial sine_squared = reduce_circle(sb * sb, 5, 6);
  return cb == r(2, 2) && sine_squared == one() - r(2, 2) * r(2, 2) && alpha().cosine * sb == r(0, 2) &&
         alpha().sine * sb == r(1, 2) && gamma().cosine * sb == Polynomial() - r(2, 0) && gamma().sine * sb == r(2, 1);
}

// G-69: R with sin beta = 0 and cos beta = +-1, its total turn put into alpha by the printed identities. R maps columns
// or rows; its angles stand in the order alpha beta gamma or gamma beta alpha from left to right.
enum class Form { kColumns, kRows };
enum class Order { kAlphaLeft, kGammaLeft };

template <Form form, Order order>
Matrix<Polynomial> in_form(const Angle& a, const Angle& b, const Angle& g) {
  const Matrix<Polynomial> product = order == Order::kAlphaLeft ? zyz(a, b, g) : zyz(g, b, a);
  return form == Form::kColumns ? product : product.transposed();
}

template <Form form, Order order, int cos_beta>
bool special_case_gives_the_matrix_back() {
  const Angle flat{Polynomial(cos_beta), Polynomial()};
  const Matrix<Polynomial> r = in_form<form, order>(alpha(), flat, gamma());
  const Angle found{r(1, 1), Polynomial() - r(1, 0)};  // cos alpha = R_YY, sin alpha = -R_YX
  return in_form<form, order>(found, flat, {one(), Polynomial()}) == r;
}

// One formula for both, the row form of Rz(alpha) Ry(beta) Rz(gamma).
bool rows_with_alpha_left_always() {
  return special_case_gives_the_matrix_back<Form::kRows, Order::kAlphaLeft, 1>() &&
         special_case_gives_the_matrix_back<Form::kRows, Order::kAlphaLeft, -1>();
}

// G-70: bands up to 3 from the band below and R alone.
bool each_band_follows_from_the_last() {
  const Matrix<cln::cl_RA> r = constants(rational_rotation());
  const std::vector<Matrix<cln::cl_RA>> bands = rotation_bands<cln::cl_RA>(3, r, 1);
  for (int l = 1; l <= 3; ++l) {
    if (!(bands[to_size(l)] == constants(band_by_integration(l, rational_rotation())))) return false;
  }
  return true;
}

bool counts_of_products() {
  return four_dense_products_of_size_nine() && sparse_multiplications(4) == 210 && sparse_multiplications(5) == 332;
}

}  // namespace

std::vector<Entry> green_euler_angles() {
  constexpr auto kColumns = Form::kColumns;
  constexpr auto kRows = Form::kRows;
  constexpr auto kAlphaLeft = Order::kAlphaLeft;
  constexpr auto kGammaLeft = Order::kGammaLeft;
  return {
      {"G-63",
       "ZYZ text",
       Kind::kText,
       Print::kRead,
       "ZYZ needs only two rotations; about y: 90 degrees about x, then about z, then -90 about x",
       Verdict::kUnderReading,
       {{"two kinds of rotation; each about fixed axes, Ry(b) = Rx(-90) Rz(b) Rx(90)",
         y_rotation_from_quarter_turns<EulerFrame::kExtrinsic>},
        {"each about the turned axes, Ry(b) = Rx(90) Rz(b) Rx(-90)",
         y_rotation_from_quarter_turns<EulerFrame::kIntrinsic>},
        {"two rotations, about z and y, reach every orientation", two_rotations_reach_every_orientation}},
       "Ry(b) = Rx(-90) Rz(b) Rx(90)",
       y_rotation_from_quarter_turns<EulerFrame::kExtrinsic>,
       "Two rotations do for functions that are symmetric about z. Rx(90) Rz(b) Rx(-90) is Ry(-b)."},
      {"G-64",
       "Constant matrices of the rotations by +-90 degrees about x",
       Kind::kTable,
       Print::kLost,
       "arrays of constants for three bands",
       Verdict::kDerived,
       {},
       "X(90): 1; [[0,-1,0],[1,0,0],[0,0,1]]; rows (0,0,0,-1,0), (0,-1,0,0,0), (0,0,-1/2,0,-sqrt3/2), (1,0,0,0,0), "
       "(0,0,-sqrt3/2,0,1/2); X(-90) is the transpose",
       x90_matrices,
       "With Condon-Shortley signs entry (m,n) takes the factor (-1)^(m+n)."},
      {"G-65",
       "Product of five matrices",
       Kind::kEquation,
       Print::kRead,
       "R_SH(alpha,beta,gamma) = Z_gamma X_-90 Z_beta X_+90 Z_alpha",
       Verdict::kUnderReading,
       {{"columns; ZYZ about fixed axes, alpha first",
         product_is_zyz_rotation<Vectors::kColumns, EulerFrame::kExtrinsic>},
        {"columns; ZYZ about turned axes, alpha first",
         product_is_zyz_rotation<Vectors::kColumns, EulerFrame::kIntrinsic>},
        {"rows; ZYZ about turned axes, alpha first", product_is_zyz_rotation<Vectors::kRows, EulerFrame::kIntrinsic>},
        {"rows; ZYZ about fixed axes, alpha first", product_is_zyz_rotation<Vectors::kRows, EulerFrame::kExtrinsic>}},
       "D(Rz(gamma) Ry(beta) Rz(alpha)) on columns",
       product_is_zyz_rotation<Vectors::kColumns, EulerFrame::kExtrinsic>,
       "For row vectors the angle beta changes sign. The identities for the angles (G-69) use another order than this "
       "product."},
      {"G-66",
       "Cost text",
       Kind::kText,
       Print::kRead,
       "four products of 9x9 matrices, 2916 multiply-adds; with sparsity around 340 for a 5th order rotation",
       Verdict::kUnderReading,
       {{"four dense products: 2916", four_dense_products_of_size_nine},
        {"340 within 5 %, degree 5 (36 coefficients), applied to a vector", sparse_product_costs_about_340<5>},
        {"340 within 5 %, five bands (25 coefficients), applied to a vector", sparse_product_costs_about_340<4>}},
       "Z X Z X Z on a vector: 12 l + 2 (l^2+l+1) products in band l",
       counts_of_products,
       "What is counted is not said. Applied to a vector: 210 for five bands, 332 for degree 5."},
      {"G-67",
       "Eq. 11",
       Kind::kTable,
       Print::kLost,
       "matrix of the first two bands in ZYZ angles",
       Verdict::kDerived,
       {},
       "1; rows y, z, x: [ca cg - sa cb sg, sa sb, sa cb cg + ca sg], [sb sg, cb, -sb cg], "
       "[-ca cb sg - sa cg, ca sb, ca cb cg - sa sg] for Rz(a) Ry(b) Rz(g)",
       first_two_bands,
       "It is the 3x3 matrix with rows and columns in the order y, z, x. The order Rz(g) Ry(b) Rz(a) swaps a and g; "
       "row vectors take the transpose; with Condon-Shortley signs entries with one index 0 change sign."},
      {"G-68",
       "ZYZ angles from a 3x3 matrix",
       Kind::kEquation,
       Print::kLost,
       "identities for the cosines and sines of alpha, beta, gamma",
       Verdict::kDerived,
       {},
       "cos b = R_ZZ, sin b = sqrt(1 - R_ZZ^2), cos a = R_XZ/sin b, sin a = R_YZ/sin b, cos g = -R_ZX/sin b, "
       "sin g = R_ZY/sin b for R = Rz(a) Ry(b) Rz(g) on columns",
       angles_from_matrix,
       "Row vectors take the transpose of R. sqrt(1 - R_ZZ^2) loses half the digits near b = 0 and pi: use "
       "sqrt(R_XZ^2 + R_YZ^2). Nothing is left at sin b = 0, as the paper says."},
      {"G-69",
       "Special case sin beta = 0",
       Kind::kEquation,
       Print::kRead,
       "cos alpha = R_YY, sin alpha = -R_YX, cos gamma = 1, sin gamma = 0 (gamma printed as lambda)",
       Verdict::kUnderReading,
       {{"rows, Rz(a) Ry(b) Rz(g), beta = 0", special_case_gives_the_matrix_back<kRows, kAlphaLeft, 1>},
        {"rows, Rz(a) Ry(b) Rz(g), beta = pi", special_case_gives_the_matrix_back<kRows, kAlphaLeft, -1>},
        {"columns, Rz(a) Ry(b) Rz(g), beta = 0", special_case_gives_the_matrix_back<kColumns, kAlphaLeft, 1>},
        {"columns, Rz(a) Ry(b) Rz(g), beta = pi", special_case_gives_the_matrix_back<kColumns, kAlphaLeft, -1>},
        {"rows, Rz(g) Ry(b) Rz(a), beta = 0", special_case_gives_the_matrix_back<kRows, kGammaLeft, 1>},
        {"rows, Rz(g) Ry(b) Rz(a), beta = pi", special_case_gives_the_matrix_back<kRows, kGammaLeft, -1>},
        {"columns, Rz(g) Ry(b) Rz(a), beta = 0", special_case_gives_the_matrix_back<kColumns, kGammaLeft, 1>},
        {"columns, Rz(g) Ry(b) Rz(a), beta = pi", special_case_gives_the_matrix_back<kColumns, kGammaLeft, -1>}},
       "cos a = R_YY, sin a = -R_YX, gamma = 0 where R maps row vectors, R = (Rz(a) Ry(b) Rz(g))^T",
       rows_with_alpha_left_always,
       "Only one matrix is shown for sin beta = 0, though cos beta may be 1 or -1."},
      {"G-70",
       "Recurrence text",
       Kind::kText,
       Print::kRead,
       "the matrix of band l+1 follows from that of band l by a recurrence; three papers",
       Verdict::kCorrect,
       {{"band l from band l-1 and R alone, l = 1, 2, 3", each_band_follows_from_the_last}},
       "",
       nullptr,
       "The recurrences of the papers are entries of their own (IR, CH, BL)."},
  };
}

}  // namespace sh::symbolic::errata
