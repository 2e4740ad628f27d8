// [SloanKautzSnyder02] section 3, properties: rotation, dot product, convolution, product: S-08 to S-14.
#include <array>

#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }
Polynomial variable(int i) { return Polynomial::variable(i); }

SphereFunction some_function() {  // bands 0 to 5
  return SphereFunction(Surd(1),
                        (variable(0) + cl_RA(2) * variable(2)).power(5) - variable(1).power(4) + Polynomial(1));
}

bool projection_commutes_with_rotation() {
  const Matrix<cl_RA> q = sphere::some_rotation();
  const SphereFunction f = some_function();
  return sphere::equal_on_sphere(sphere::expansion(sphere::projection(f.turned(q), 3)),
                                 sphere::expansion(sphere::projection(f, 3)).turned(q));
}

// Samples at +-x, +-y, +-z, each with weight 4 pi / 6: exact to degree 3.
SphereFunction projection_by_samples(const SphereFunction& f, int degree) {
  std::vector<RadicalSum> coefficients;
  for (const SphereFunction& y : sphere::spherical_harmonics(degree)) {
    RadicalSum sum;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int sign : {1, -1}) {
        std::array<RadicalSum, 3> d;
        d[axis] = RadicalSum(sign);
        sum += (f * y).at(d);
      }
    }
    coefficients.push_back(RadicalSum(Surd(fraction(2, 3)) * Surd::square_root(1, 2)) * sum);
  }
  return sphere::expansion(coefficients);
}

bool samples_commute_with_rotation() {
  const Matrix<cl_RA> q = sphere::some_rotation();
  const SphereFunction f = some_function();
  return sphere::equal_on_sphere(projection_by_samples(f.turned(q), 1), projection_by_samples(f, 1).turned(q));
}

// Bands 0..2 of b suffice, whatever a holds above them.
bool integral_of_product_is_dot_product() {
  const std::vector<RadicalSum> a = sphere::some_coefficients(3, 5);
  const std::vector<RadicalSum> b = sphere::some_coefficients(2, 3);
  RadicalSum dot;
  for (std::size_t i = 0; i < b.size(); ++i) dot += a[i] * b[i];
  return sphere::sphere_integral(sphere::expansion(a) * sphere::expansion(b)) == dot;
}

bool convolution_scales_bands() {
  const Polynomial t = variable(2);
  const SphereFunction h(Surd(1), Polynomial(1) + cl_RA(2) * t - t.power(2) + cl_RA(3) * t.power(3));
  const std::vector<RadicalSum> f = sphere::some_coefficients(3, 7);
  std::vector<RadicalSum> scaled;
  for (int l = 0; l <= 3; ++l) {
    const RadicalSum h_l = sphere::zone_integral(h * sphere::zonal_harmonic(l), -1, 1);
    const RadicalSum alpha(Surd::square_root(fraction(4, 2 * l + 1), 1));
    for (int m = -l; m <= l; ++m) scaled.push_back(alpha * h_l * f[to_size(coefficient_index(l, m))]);
  }
  return sphere::projection(sphere::convolved(sphere::expansion(f), h), 3) == scaled;
}

bool clamped_cosine_coefficients() {
  const auto root = [](const cl_RA& factor, int square) { return Surd(factor) * Surd::square_root(square, 1); };
  const std::array<Surd, 7> listed{root(fraction(1, 2), 1),   root(fraction(1, 3), 3),
                                   root(fraction(1, 8), 5),   Surd(),
                                   root(fraction(-1, 16), 1), Surd(),
                                   root(fraction(1, 128), 13)};
  for (int l = 0; l < 7; ++l) {
    const SphereFunction integrand = SphereFunction::variable(2) * sphere::zonal_harmonic(l);
    if (!(sphere::zone_integral(integrand, 0, 1) == RadicalSum(listed[to_size(l)]))) return false;
  }
  return true;
}

// c_i = (a_k G_ijk) b_j against the product of the functions, bands 0..2 of each.
bool product_matrix_multiplies() {
  const std::vector<RadicalSum> a = sphere::some_coefficients(2, 4);
  const std::vector<RadicalSum> b = sphere::some_coefficients(2, 9);
  Matrix<RadicalSum> matrix(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      for (int k = 0; k < 9; ++k) matrix(i, j) += a[to_size(k)] * RadicalSum(gaunt(i, j, k));
    }
  }
  std::vector<RadicalSum> c(9);
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) c[to_size(i)] += matrix(i, j) * b[to_size(j)];
  }
  return matrix == matrix.transposed() && sphere::projection(sphere::expansion(a) * sphere::expansion(b), 2) == c;
}

// Whether a product of one function of degree <= first with one of degree second reaches degree <= result.
bool contributes(int first, int second, int result) {
  for (int i = 0; i < (first + 1) * (first + 1); ++i) {
    for (int j = second * second; j < (second + 1) * (second + 1); ++j) {
      for (int k = 0; k < (result + 1) * (result + 1); ++k) {
        if (!gaunt(i, j, k).is_zero()) return true;
      }
    }
  }
  return false;
}

// n = 3: nothing above order 2n-1, that is degree 2n-2 = 4, matters to degree 2, and degree 4 does.
bool one_factor_of_order_n() { return !contributes(2, 5, 2) && !contributes(2, 6, 2) && contributes(2, 4, 2); }
bool both_factors_arbitrary() {  // y_20,0 squared
  const int high = coefficient_index(20, 0);
  return gaunt(high, high, 0).is_zero();
}
bool product_of_two_of_order_n() {  // of degree 2 each: no degree above 4 in the product
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      for (int k = coefficient_index(5, -5); k <= coefficient_index(6, 6); ++k) {
        if (!gaunt(i, j, k).is_zero()) return false;
      }
    }
  }
  return true;
}

bool one_or_both_factors_of_order_n() { return one_factor_of_order_n() && product_of_two_of_order_n(); }

// y_i(Q s) has no part in another band.
bool rotation_keeps_bands_apart() {
  const Matrix<cl_RA> q = sphere::some_rotation();
  for (int i = 0; i < 16; ++i) {
    const auto [l, m] = degree_order(i);
    const std::vector<RadicalSum> c = sphere::projection(sphere::spherical_harmonic(l, m).turned(q), 3);
    for (int j = 0; j < 16; ++j) {
      if (degree_order(j).degree != l && !c[to_size(j)].is_zero()) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> sloan_properties() {
  return {
      {"S-08",
       "Eq. 4",
       Kind::kEquation,
       Print::kRead,
       "g(s) = f(Q(s)) => g~(s) = f~(Q(s)); no aliasing when samples are collected at a rotated set",
       Verdict::kUnderReading,
       {{"exact integration", projection_commutes_with_rotation},
        {"sums over finitely many samples", samples_commute_with_rotation}},
       "samples: only when the rule integrates f y_i exactly",
       nullptr,
       "Second reading: six samples on the axes."},
      {"S-09",
       "Eq. 5",
       Kind::kEquation,
       Print::kLost,
       "INT a~ b~ ds as a dot product",
       Verdict::kDerived,
       {},
       "INT a~ b~ ds = INT a b~ ds = sum_{i=1}^{n^2} a_i b_i",
       integral_of_product_is_dot_product,
       "One of the two projections is enough."},
      {"S-10",
       "Eq. 6",
       Kind::kEquation,
       Print::kRead,
       "(h*f)_l^m = sqrt(4 pi/(2l+1)) h_l^0 f_l^m = alpha_l^0 h_l^0 f_l^m",
       Verdict::kCorrect,
       {{"against the integral of f(w) h(w.t)", convolution_scales_bands}},
       "",
       nullptr,
       "Half of the line is lost."},
      {"S-11",
       "Text after Eq. 6",
       Kind::kEquation,
       Print::kLost,
       "h_l^0 of h(z) = max(z,0) by an analytic formula",
       Verdict::kDerived,
       {},
       "h_l^0 = sqrt(pi)/2, sqrt(pi/3), sqrt(5 pi)/8, 0, -sqrt(pi)/16, 0, sqrt(13 pi)/128, ...",
       clamped_cosine_coefficients,
       "The formula is only referred to."},
      {"S-12",
       "Eq. 7",
       Kind::kEquation,
       Print::kLost,
       "c_i = a^_ij b_j, a^ a symmetric matrix",
       Verdict::kDerived,
       {},
       "c_i = INT a (b_j y_j) y_i = (a_k INT y_i y_j y_k) b_j = a^_ij b_j",
       product_matrix_multiplies,
       "Symmetric because the triple integral is."},
      {"S-13",
       "Text after Eq. 7",
       Kind::kText,
       Print::kRead,
       "the product's order n projection involves coefficients of the two factors up to order 2n-1",
       Verdict::kUnderReading,
       {{"both factors arbitrary", both_factors_arbitrary},
        {"one factor of order n; the product of two such has order 2n-1", one_or_both_factors_of_order_n}},
       "a is needed to degree 2(n-1) when b has n bands",
       nullptr,
       "Arbitrarily high bands of both factors together reach band 0: the square of y_20,0 does."},
      {"S-14",
       "Rotation",
       Kind::kText,
       Print::kRead,
       "rotation is linear and treats each band by itself",
       Verdict::kCorrect,
       {{"degree <= 3", rotation_keeps_bands_apart}},
       "",
       nullptr,
       "That zyz angles with recurrences are the most efficient way is a matter of measurement, not decided here."},
  };
}

}  // namespace sh::symbolic::errata
