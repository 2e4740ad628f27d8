// [Green03] Creating Light Sources, G-92 to G-94: circular lights and proxy shadows.
#include <array>

#include "symbolic/basis/normalisation.hpp"
#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/green_circular_light.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"
#include "symbolic/zonal/zonal_integrals.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kDegree = 2;

// G-92: sqrt(pi / (2l+1)) (P_(l-1)(c) - P_(l+1)(c)), P_-1 = 1.
bool listed_circular_light() {
  const Polynomial c = Polynomial::variable(0);
  const Polynomial s2 = Polynomial(1) - c * c;
  const auto root = [](int divisor, int radicand) {
    return Surd(cln::cl_RA(1) / divisor) * Surd::square_root(radicand, 1);
  };
  const std::array<ZonalTerm, 4> listed{ZonalTerm{root(1, 1), {Polynomial(1) - c}}, ZonalTerm{root(2, 3), {s2}},
                                        ZonalTerm{root(2, 5), {c * s2}},
                                        ZonalTerm{root(8, 7), {s2, 5 * (c * c) - Polynomial(1)}}};
  for (int l = 0; l < 4; ++l) {
    if (!same_value(listed[to_size(l)], project_profile(l, {{Polynomial(1), c, Polynomial(1)}}))) return false;
  }
  return true;
}
bool circular_light_coefficients() {
  constexpr int kHighest = 50;
  if (!listed_circular_light()) return false;
  for (int l = 0; l <= kHighest; ++l) {
    const Polynomial below = l == 0 ? Polynomial(1) : legendre_polynomial(l - 1, 0);
    const ZonalTerm formula{Surd::square_root(cln::cl_RA(1) / (2 * l + 1), 1), {below - legendre_polynomial(l + 1, 0)}};
    if (!same_value(formula, project_profile(l, {{Polynomial(1), Polynomial::variable(0), Polynomial(1)}}))) {
      return false;
    }
  }
  return true;
}

bool printed_circular_light() { return prove_green_circular_light(green_circular_light()).proved; }

// G-94: a light of three bands and a zonal mask of three bands, coefficients of the orthonormal basis.
constexpr int kProductDegree = 2 * kDegree;

std::vector<Surd> light_coefficients() {
  std::vector<Surd> result;
  int value = 1;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      result.push_back(Surd(value) * orthonormal_factor(l, m).inverse());  // value * S_lm
      value = value % 4 + 2;
    }
  }
  return result;
}
Polynomial function_of(const std::vector<Surd>& coefficients) {
  Polynomial sum;
  std::size_t i = 0;
  for (int l = 0; i < coefficients.size(); ++l) {
    for (int m = -l; m <= l; ++m, ++i) {
      sum += (coefficients[i] * orthonormal_factor(l, m)).rational() * solid_harmonic(l, m);
    }
  }
  return sum;
}
// 3 - 2 z + z^2, in coefficients about +z.
Polynomial mask() { return Polynomial(3) - 2 * Polynomial::variable(2) + Polynomial::variable(2).power(2); }
std::vector<Surd> projected(const Polynomial& f, int degree) {
  std::vector<Surd> result;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Surd integral = Surd(4 * sphere_mean(f * solid_harmonic(l, m))) * Surd::square_root(1, 2);
      result.push_back(orthonormal_factor(l, m) * integral);
    }
  }
  return result;
}

bool spherical_convolution_is_product() {
  const std::vector<Surd> light = light_coefficients();
  const std::vector<Surd> zonal = projected(mask(), kDegree);
  std::vector<Surd> convolved;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Surd band = convolution_factor(l) * zonal[to_size(l * (l + 1))];
      convolved.push_back(band * light[to_size(l * (l + 1) + m)]);
    }
  }
  return convolved == projected(function_of(light) * mask(), kDegree);
}
// As for Fourier coefficients: index k collects a_i b_j with i + j = k modulo the number of coefficients.
bool circular_convolution_is_product() {
  const std::vector<Surd> light = light_coefficients();
  const std::vector<Surd> zonal = projected(mask(), kDegree);
  const std::vector<Surd> product = projected(function_of(light) * mask(), kDegree);
  const std::size_t n = light.size();
  for (std::size_t k = 0; k < n; ++k) {
    RadicalSum sum;
    for (std::size_t i = 0; i < n; ++i) sum += RadicalSum(light[i] * zonal[(k + n - i) % n]);
    if (!(sum == RadicalSum(product[k]))) return false;
  }
  return true;
}
// The light turned so that the shadow's direction R z is +z, multiplied by the matrix of the mask, and turned back.
bool transfer_matrix_between_two_rotations_is_product() {
  const Matrix<Polynomial> r = rational_rotation();
  const Polynomial light = function_of(light_coefficients());
  const std::vector<Surd> turned_light = projected(turned(light, r), kDegree);
  const auto matrix = transfer_matrix(projected(mask(), kDegree), {kDegree, kDegree, kProductDegree});
  std::vector<Surd> shadowed;
  for (const std::vector<RadicalSum>& row : matrix) {
    RadicalSum sum;
    for (std::size_t j = 0; j < row.size(); ++j) sum += row[j] * RadicalSum(turned_light[j]);
    shadowed.push_back(sum.is_zero() ? Surd() : sum.surd());
  }
  const Polynomial back = turned(function_of(shadowed), r.transposed());
  const Polynomial exact = light * turned(mask(), r.transposed());
  return reduce_on_sphere(back) == reduce_on_sphere(exact);
}
// Everything but the cap: 2 sqrt(pi) at l = 0 less the cap.
bool complement_is_rest_of_sphere() {
  constexpr int kHighest = 10;
  for (int l = 0; l <= kHighest; ++l) {
    const ZonalTerm cap = zonal_family("cap").closed_form(l);
    const ZonalTerm rest = project_profile(l, {{Polynomial(1), Polynomial(-1), Polynomial::variable(0)}});
    const cln::cl_RA c = cln::cl_RA(2) / 7;
    const Surd whole = l == 0 ? Surd(2) * Surd::square_root(1, 1) : Surd();
    if (!(cap.at(std::array{c}) + rest.at(std::array{c}) == whole)) return false;
  }
  return true;
}
bool proxy_shadow() { return complement_is_rest_of_sphere() && transfer_matrix_between_two_rotations_is_product(); }

}  // namespace

std::vector<Entry> green_lights() {
  return {
      {"G-92",
       "Circular light, function and coefficients",
       Kind::kEquation,
       Print::kLost,
       "1 where theta < t, and its projection by symbolic integration",
       Verdict::kDerived,
       {},
       "f = 1 for theta < t, else 0; c_l0 = sqrt(pi/(2l+1)) (P_(l-1)(c) - P_(l+1)(c)), c = cos t, P_-1 = 1; c_lm = 0 "
       "for m != 0",
       circular_light_coefficients,
       "c_00 = sqrt(pi) (1-c), c_10 = sqrt(3 pi)/2 (1-c^2), c_20 = sqrt(5 pi)/2 (c-c^3), c_30 = sqrt(7 pi)/8 (1-c^2) "
       "(5c^2-1)."},
      {"G-93",
       "Code synth_light(cutoff)",
       Kind::kCode,
       Print::kRead,
       "sh[0], sh[2], sh[6], sh[12] in decimals, c = cos(cutoff), s^2, t3 = [cutoff < pi], t9 = [cutoff < 0]",
       Verdict::kCorrect,
       {{"the cap of half-angle cutoff, each decimal correctly rounded; nothing below 0, the whole sphere from pi on",
         printed_circular_light}},
       "",
       nullptr,
       "Small angles lose digits in 1 - cos(cutoff)."},
      {"G-94",
       "Proxy shadow",
       Kind::kText,
       Print::kRead,
       "light times the complement of a cap, 'by circular convolution' or by a transfer matrix about z between two "
       "rotations",
       Verdict::kWrong,
       {{"convolution of functions on the sphere, band by band", spherical_convolution_is_product},
        {"circular convolution of the vectors of coefficients", circular_convolution_is_product}},
       "c = D(R) M D(R^-1) a, M_ij = INT h y_i y_j, h_l0 = 2 sqrt(pi) delta_l0 - cap_l",
       proxy_shadow,
       "A product couples bands by Gaunt coefficients; a convolution multiplies each band by a number. The transfer "
       "matrix and the two rotations are right."},
  };
}

}  // namespace sh::symbolic::errata
