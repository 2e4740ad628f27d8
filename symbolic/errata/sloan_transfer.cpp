// [SloanKautzSnyder02] section 4, transfer vectors and matrices: S-15 to S-23.
//
// Points have the normal N = z; what is visible is a zone of the sphere, so that every integral is exact.
#include <algorithm>

#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }
RadicalSum over_pi(const cl_RA& albedo) { return RadicalSum(Surd(albedo) * Surd::square_root(1, -2)); }

/// INT f max(N.s, 0) V ds, V = 1 for z > lowest.
RadicalSum cosine_integral(const SphereFunction& f, const cl_RA& lowest) {
  return sphere::zone_integral(f * SphereFunction::variable(2), lowest, 1);
}

// Coefficients of H V, degree <= 3.
std::vector<RadicalSum> transfer_vector(const cl_RA& lowest) {
  std::vector<RadicalSum> m;
  for (const SphereFunction& y : sphere::spherical_harmonics(3)) m.push_back(cosine_integral(y, lowest));
  return m;
}

RadicalSum dot(const std::vector<RadicalSum>& a, const std::vector<RadicalSum>& b) {
  RadicalSum sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

SphereFunction some_light() { return sphere::expansion(sphere::some_coefficients(3, 5)); }

bool transfer_vector_gives_the_integral() {
  return dot(transfer_vector(0), sphere::some_coefficients(3, 5)) == cosine_integral(some_light(), 0);
}

// The light turned and then multiplied: an operator whose matrix is not symmetric.
bool transfer_matrix_gives_the_coefficients() {
  const Matrix<cl_RA> r = sphere::some_rotation();
  const SphereFunction v(Surd(1), Polynomial(2) + Polynomial::variable(0) - Polynomial::variable(2).power(2));
  const std::vector<SphereFunction> y = sphere::spherical_harmonics(2);
  const std::vector<RadicalSum> light = sphere::some_coefficients(2, 7);
  const std::vector<RadicalSum> expected = sphere::projection(v * sphere::expansion(light).turned(r), 2);
  for (std::size_t i = 0; i < y.size(); ++i) {
    RadicalSum sum;
    for (std::size_t j = 0; j < y.size(); ++j) sum += sphere::sphere_integral(v * y[i] * y[j].turned(r)) * light[j];
    if (!(sum == expected[i])) return false;
  }
  return true;
}

// Exit radiance by (rho/pi) INT L H against a combination of the dot product; uniform light 1 must leave as rho.
bool unshadowed_exit_radiance(const RadicalSum& factor) {
  const cl_RA albedo = fraction(3, 10);
  const SphereFunction one(1);
  return over_pi(albedo) * cosine_integral(one, 0) == RadicalSum(albedo) &&
         factor * dot(transfer_vector(0), sphere::projection(one, 3)) == RadicalSum(albedo) &&
         factor * dot(transfer_vector(0), sphere::projection(some_light(), 3)) ==
             over_pi(albedo) * cosine_integral(some_light(), 0);
}
bool dot_product_times_albedo_over_pi() { return unshadowed_exit_radiance(over_pi(fraction(3, 10))); }
bool dot_product_alone() { return unshadowed_exit_radiance(RadicalSum(1)); }

int number_of_functions(int bands) {
  int count = 0;
  for (int l = 0; l < bands; ++l) count += 2 * l + 1;
  return count;
}
// "second order: 9 coefficients", and elsewhere "fifth order: 25", with one meaning of order.
bool order_is_number_of_bands() { return number_of_functions(2) == 9 && number_of_functions(5) == 25; }
bool order_is_degree() { return number_of_functions(2 + 1) == 9 && number_of_functions(5 + 1) == 25; }
bool third_order_has_nine() { return number_of_functions(3) == 9 && number_of_functions(5) == 25; }

// T_DS = (rho/pi) INT L H V for V = 1 where z > 1/2, its dot product, and 3/4 of rho for uniform light.
bool shadowed_transfer() {
  const cl_RA albedo = fraction(3, 10);
  const cl_RA lowest = fraction(1, 2);
  return over_pi(albedo) * dot(transfer_vector(lowest), sphere::some_coefficients(3, 5)) ==
             over_pi(albedo) * cosine_integral(some_light(), lowest) &&
         over_pi(albedo) * cosine_integral(SphereFunction(1), lowest) == RadicalSum(albedo * fraction(3, 4));
}

// Radiance 1 from everywhere, O included, leaves as rho however much O covers.
bool interreflected_transfer() {
  const cl_RA albedo = fraction(3, 10);
  const SphereFunction one(1);
  const auto exit_radiance = [&](const cl_RA& lowest) {
    const RadicalSum from_object = sphere::zone_integral(SphereFunction::variable(2), 0, lowest);  // 1 - V
    return over_pi(albedo) * cosine_integral(one, lowest) + over_pi(albedo) * from_object;
  };
  const RadicalSum covered = over_pi(albedo) * cosine_integral(one, 0);  // V = 0
  return exit_radiance(fraction(1, 2)) == RadicalSum(albedo) && exit_radiance(fraction(1, 7)) == RadicalSum(albedo) &&
         covered == RadicalSum(albedo);
}

// V^_ij = INT V y_i y_j for V = 1 where z > 1/2, rows to degree 4, columns to degree 2.
Matrix<RadicalSum> visibility_matrix(int rows, int columns) {
  const std::vector<SphereFunction> y = sphere::spherical_harmonics(4);
  Matrix<RadicalSum> v(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) v(i, j) = sphere::zone_integral(y[to_size(i)] * y[to_size(j)], fraction(1, 2), 1);
  }
  return v;
}

std::vector<Surd> visibility_coefficients(int degree) {
  std::vector<Surd> v;
  for (const SphereFunction& y : sphere::spherical_harmonics(degree)) {
    v.push_back(sphere::zone_integral(y, fraction(1, 2), 1).surd());
  }
  return v;
}

bool equal_entries(const std::vector<std::vector<RadicalSum>>& rows, const Matrix<RadicalSum>& matrix) {
  if (rows.size() != to_size(matrix.rows())) return false;
  for (int i = 0; i < matrix.rows(); ++i) {
    if (rows[to_size(i)].size() != to_size(matrix.columns())) return false;
    for (int j = 0; j < matrix.columns(); ++j) {
      if (!(rows[to_size(i)][to_size(j)] == matrix(i, j))) return false;
    }
  }
  return true;
}

bool visibility_matrix_is_the_product_matrix() {
  const Matrix<RadicalSum> square = visibility_matrix(9, 9);
  return square == square.transposed() && equal_entries(transfer_matrix(visibility_coefficients(4), {2, 4, 2}), square);
}
bool light_of_nine_becomes_twenty_five() {
  return equal_entries(transfer_matrix(visibility_coefficients(6), {2, 6, 4}), visibility_matrix(25, 9));
}

}  // namespace

std::vector<Entry> sloan_transfer() {
  return {
      {"S-15",
       "Eq. 8",
       Kind::kEquation,
       Print::kLost,
       "L'_p by an inner product",
       Verdict::kDerived,
       {},
       "L'_p = sum_i (M_p)_i (L_p)_i",
       transfer_vector_gives_the_integral,
       "Decided for M = max(z,0)."},
      {"S-16",
       "Eq. 9",
       Kind::kEquation,
       Print::kLost,
       "(L'_p)_i by a matrix",
       Verdict::kDerived,
       {},
       "(L'_p)_i = sum_j (M_p)_ij (L_p)_j, (M_p)_ij = INT y_i M(y_j) ds",
       transfer_matrix_gives_the_coefficients,
       "Rows belong to the transferred radiance, as the text says. Decided for an operator without symmetry."},
      {"S-17",
       "4.1, T_DU and H",
       Kind::kEquation,
       Print::kRead,
       "T_DU = (rho/pi) INT L H ds, H = max(N.s,0), M^DU = H; T_DU is the inner product of the coefficient vectors",
       Verdict::kUnderReading,
       {{"rho/pi times the inner product", dot_product_times_albedo_over_pi},
        {"the inner product alone", dot_product_alone}},
       "(rho/pi) sum_i L_i H_i",
       nullptr,
       "M holds neither rho nor 1/pi here."},
      {"S-18",
       "4.1, second-order projection",
       Kind::kText,
       Print::kRead,
       "a second-order projection has 9 coefficients; n-th order has n^2, fifth order 25",
       Verdict::kWrong,
       {{"order is the number of bands", order_is_number_of_bands}, {"order is the degree", order_is_degree}},
       "9 coefficients are third order: 3 bands, degree 2",
       third_order_has_nine,
       "Second-order means degree 2 here, also where the projection of M^DS is discussed."},
      {"S-19",
       "4.1, T_DS and Eq. 10",
       Kind::kEquation,
       Print::kRead,
       "T_DS = (rho/pi) INT L H V ds, M^DS = H V",
       Verdict::kCorrect,
       {{"V a cap of 60 degrees about N", shadowed_transfer}},
       "",
       nullptr,
       "The integral is the inner product; rho/pi stays outside."},
      {"S-20",
       "4.1, T_DI",
       Kind::kEquation,
       Print::kRead,
       "T_DI = T_DS + (rho/pi) INT Lbar H (1-V) ds",
       Verdict::kCorrect,
       {{"radiance 1 from everywhere leaves as rho", interreflected_transfer}},
       "",
       nullptr,
       "Lbar is the radiance from O itself."},
      {"S-21",
       "4.2, T_GU, T_GS, T_GI",
       Kind::kEquation,
       Print::kRead,
       "INT L G ds; INT L G V ds; T_GS + INT Lbar G (1-V) ds",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "G has to hold whatever cosine and scale the material needs."},
      {"S-22",
       "4.2, G*_r",
       Kind::kEquation,
       Print::kRead,
       "G*_r(z) = G(s,(0,0,1),r); L' is convolved with it and evaluated at R",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "For a kernel that is symmetric about R."},
      {"S-23",
       "Eq. 11",
       Kind::kEquation,
       Print::kRead,
       "M^GS(L,s) = L(s) V(s), a symmetric matrix V^ by eq. 7; non-square 25x9 matrices",
       Verdict::kCorrect,
       {{"V^_ij = sum_k G_ijk V_k = INT V y_i y_j, symmetric", visibility_matrix_is_the_product_matrix},
        {"25 rows by 9 columns take 9 coefficients of light to 25", light_of_nine_becomes_twenty_five}},
       "",
       nullptr,
       "Only the square matrix can be symmetric. The table of results lists 9x25."},
  };
}

}  // namespace sh::symbolic::errata
