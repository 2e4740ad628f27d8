// [Green03] Creating Light Sources, G-87 to G-91: CIE skies, the angular map and its projection.
#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include <array>
#include <cmath>
#include <optional>

#include "symbolic/basis/normalisation.hpp"
#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/zonal/zonal.hpp"
#include "symbolic/zonal/zonal_integrals.hpp"

namespace sh::symbolic::errata {
namespace {

Polynomial axis() { return Polynomial::variable(kAxisVariable); }
cln::cl_RA ratio(int numerator, int denominator) { return cln::cl_RA(numerator) / denominator; }
Surd pi_root(const cln::cl_RA& factor, int radicand) { return Surd(factor) * Surd::square_root(radicand, 1); }

// G-87: the sky that is three times as bright at the zenith as at the horizon, linear in the cosine.
bool overcast_sky() {
  const Polynomial sky = ratio(1, 3) * (Polynomial(1) + 2 * axis());
  const auto at = [&sky](int t) { return substitute(sky, kAxisVariable, Polynomial(t)).coefficient({}); };
  const Polynomial horizontal = definite_integral(2 * sky * axis(), kAxisVariable, Polynomial(), Polynomial(1));
  if (at(1) != 1 || at(0) * 3 != 1 || horizontal.coefficient({}) != ratio(7, 9)) return false;  // over pi
  const std::array<Surd, 5> listed{pi_root(ratio(2, 3), 1), pi_root(ratio(7, 18), 3), pi_root(ratio(1, 12), 5),
                                   pi_root(ratio(-1, 24), 7), pi_root(ratio(-1, 24), 1)};
  for (int l = 0; l < 5; ++l) {
    const ZonalTerm exact = project_profile(l, {{sky, Polynomial(), Polynomial(1)}});
    if (!(exact.at({}) == listed[to_size(l)])) return false;
    if (!same_value(exact, zonal_family("cie-overcast").closed_form(l))) return false;
  }
  return true;
}

// G-88. Exponentials are symbols: indicatrix(e, c) with e = exp(-3 gamma), c = cos gamma; gradation(h) with h =
// exp(-0.32 / cos theta).
Polynomial indicatrix(const Polynomial& e, const Polynomial& c) {
  return Polynomial(ratio(91, 100)) + 10 * e + ratio(45, 100) * (c * c);
}
// cos gamma for the directions (theta from the zenith, alpha from the sun): variables 0, 1 = cos, sin theta; 2, 3 =
// cos, sin S; 4 = cos alpha.
Polynomial cosine_to_sun() {
  const auto v = [](int i) { return Polynomial::variable(i); };
  return v(2) * v(0) + v(3) * v(1) * v(4);
}
// The law of cosines against the product of the two directions.
bool cosine_to_sun_is_dot_product() {
  const std::array<cln::cl_RA, 3> direction{ratio(4, 5) * ratio(5, 13), ratio(4, 5) * ratio(12, 13), ratio(3, 5)};
  const std::array<cln::cl_RA, 3> sun{ratio(15, 17), 0, ratio(8, 17)};
  const cln::cl_RA dot = direction[0] * sun[0] + direction[2] * sun[2];
  const std::array<cln::cl_RA, 5> values{ratio(3, 5), ratio(4, 5), ratio(8, 17), ratio(15, 17), ratio(5, 13)};
  return cosine_to_sun().evaluate(values) == dot;
}
// At the zenith theta = 0: gamma is S, and numerator and denominator are the same polynomial.
bool clear_sky_is_unit_at_zenith() {
  const Polynomial at_zenith = substitute(substitute(cosine_to_sun(), 0, Polynomial(1)), 1, Polynomial());
  const Polynomial cos_s = Polynomial::variable(2);
  const Polynomial exp_s = Polynomial::variable(5);
  const Polynomial printed_denominator = Polynomial(ratio(91, 100)) + 10 * exp_s + ratio(45, 100) * cos_s.power(2);
  return at_zenith == cos_s && indicatrix(exp_s, at_zenith) == printed_denominator;
}
cln::cl_R negative_exponential(const cln::cl_RA& rate, const cln::cl_R& argument) {
  return cln::exp(-(rate * argument));
}
cln::cl_R right_angle() { return cln::pi(cln::float_format(40)) / 2; }
// Nearest multiple of 10^-digits.
cln::cl_RA rounded(const cln::cl_R& value, int digits) {
  const cln::cl_RA scale = cln::expt(cln::cl_RA(10), digits);
  return cln::round1(value * scale) / scale;
}
// The indicatrix of the standard general sky, 1 + c (exp(d gamma) - exp(d pi/2)) + e cos^2 gamma, is 1 at 90 degrees
// for c = 10, d = -3; two digits of its constant term are 0.91.
bool clear_sky_constants() {
  return cosine_to_sun_is_dot_product() && clear_sky_is_unit_at_zenith() &&
         rounded(1 - 10 * negative_exponential(3, right_angle()), 2) == ratio(91, 100);
}

// G-90: the texel of a direction. dz enters through its angle, which is a known part of pi here.
struct Texel {
  cln::cl_RA u;
  cln::cl_RA v;
  cln::cl_I x;
  cln::cl_I y;
};
struct MapDirection {
  cln::cl_RA angle_over_pi;
  Surd sine;
  std::array<cln::cl_RA, 2> azimuth;  // cosine and sine
};

cln::cl_I halved(const cln::cl_RA& value) { return cln::ash(cln::truncate1(value), -1); }  // int(value) >> 1

// Nothing where the code divides by zero.
std::optional<Texel> angular_map_code(const MapDirection& direction, int image_size) {
  const Surd dx = direction.sine * Surd(direction.azimuth[0]);
  const Surd dy = direction.sine * Surd(direction.azimuth[1]);
  const Surd square = dx * dx + dy * dy;
  if (square.is_zero()) return std::nullopt;
  const Surd r = Surd(direction.angle_over_pi) * Surd::square_root(square.rational()).inverse();
  const cln::cl_RA u = (dx * r).rational();
  const cln::cl_RA v = (dy * r).rational();
  return Texel{u, v, halved(u * image_size + image_size), halved(v * image_size + image_size)};
}

std::vector<MapDirection> directions_off_the_axis() {
  const Surd half(ratio(1, 2));
  const std::array<std::pair<cln::cl_RA, Surd>, 7> polar{{{ratio(1, 6), half},
                                                          {ratio(1, 4), half * Surd::square_root(2)},
                                                          {ratio(1, 3), half * Surd::square_root(3)},
                                                          {ratio(1, 2), Surd(1)},
                                                          {ratio(2, 3), half * Surd::square_root(3)},
                                                          {ratio(3, 4), half * Surd::square_root(2)},
                                                          {ratio(5, 6), half}}};
  const std::vector<std::array<cln::cl_RA, 2>> azimuths{
      {1, 0}, {ratio(3, 5), ratio(4, 5)}, {ratio(-5, 13), ratio(12, 13)}, {0, -1}, {ratio(-8, 17), ratio(-15, 17)}};
  std::vector<MapDirection> result;
  for (const auto& [angle, sine] : polar) {
    for (const auto& azimuth : azimuths) result.push_back({angle, sine, azimuth});
  }
  return result;
}

// (u, v) is the azimuth's direction at the distance angle / pi, and the texel is the one that holds it.
bool maps_to_texel(const MapDirection& direction) {
  constexpr int kSize = 37;
  const std::optional<Texel> texel = angular_map_code(direction, kSize);
  if (!texel) return false;
  const auto holds = [](const cln::cl_I& index, const cln::cl_RA& place) {
    const cln::cl_RA lower = cln::cl_RA(2 * index) / kSize - 1;
    return index >= 0 && index < kSize && lower <= place && place < lower + ratio(2, kSize);
  };
  return texel->u == direction.angle_over_pi * direction.azimuth[0] &&
         texel->v == direction.angle_over_pi * direction.azimuth[1] && holds(texel->x, texel->u) &&
         holds(texel->y, texel->v);
}
bool every_direction_maps(const std::vector<MapDirection>& directions) {
  for (const MapDirection& direction : directions) {
    if (!maps_to_texel(direction)) return false;
  }
  return true;
}
bool directions_off_the_axis_map() { return every_direction_maps(directions_off_the_axis()); }
bool all_directions_map() {
  std::vector<MapDirection> directions = directions_off_the_axis();
  directions.push_back({0, Surd(), {1, 0}});  // +z
  directions.push_back({1, Surd(), {1, 0}});  // -z
  return every_direction_maps(directions);
}

// The fragment as it stands, in float: directions (e, 0, -1), which single precision takes for unit vectors.
bool single_precision_stays_in_the_image() {
  constexpr int kSize = 64;
  const float one_over_pi = 1.0F / 3.14159265F;
  for (int k = 1; k < 100; ++k) {
    const float dx = static_cast<float>(k) * 1e-6F;
    const float dz = -1.0F;
    const float invl = 1.0F / std::sqrt(dx * dx);
    const float r = one_over_pi * std::acos(dz) * invl;
    const int x = static_cast<int>(dx * r * static_cast<float>(kSize) + static_cast<float>(kSize)) >> 1;
    if (x < 0 || x >= kSize) return false;
  }
  return true;
}

// G-91: one channel; area over pi is 4.
template <class T>
std::vector<T> projection_code(const std::vector<T>& colours, const std::vector<std::vector<T>>& values) {
  std::vector<T> result(values.front().size(), T(cln::cl_RA(0)));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t n = 0; n < result.size(); ++n) result[n] = result[n] + colours[i] * values[i][n];
  }
  const T factor = T(4 / cln::cl_RA(cln::cl_I(colours.size())));
  for (T& coefficient : result) coefficient = coefficient * factor;
  return result;
}

constexpr int kDegree = 2;
std::vector<Polynomial> basis() {
  std::vector<Polynomial> result;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) result.push_back(solid_harmonic(l, m));
  }
  return result;
}

// For the light S_j the estimate with values S_n converges to integral S_j S_n = delta_jn / k_n^2, 4 pi k^2 rational.
bool projection_converges_to_coefficients() {
  const std::vector<Polynomial> functions = basis();
  std::size_t j = 0;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m, ++j) {
      const std::vector<Polynomial> one_sample = projection_code<Polynomial>({functions[j]}, {functions});
      for (std::size_t n = 0; n < functions.size(); ++n) {
        const cln::cl_RA over_pi = sphere_mean(one_sample[n]);
        if (over_pi != (n == j ? 4 / squared_factor(l, m) : cln::cl_RA(0))) return false;
      }
    }
  }
  const std::vector<cln::cl_RA> two = projection_code<cln::cl_RA>({3, 5}, {{7, 1}, {-2, 4}});
  return two[0] == 2 * (21 - 10) && two[1] == 2 * (3 + 20);
}

}  // namespace

std::vector<Entry> green_environments() {
  return {
      {"G-87",
       "CIE overcast sky",
       Kind::kEquation,
       Print::kLost,
       "luminance from L_Z at the zenith and beta, the angle from the zenith",
       Verdict::kDerived,
       {},
       "L = L_Z (1 + 2 cos beta) / 3",
       overcast_sky,
       "Horizon to zenith 1/3; horizontal irradiance 7 pi L_Z / 9; zonal coefficients over L_Z: 2 sqrt(pi)/3, "
       "7 sqrt(3 pi)/18, sqrt(5 pi)/12, -sqrt(7 pi)/24, -sqrt(pi)/24. The captions say illuminance: it is luminance."},
      {"G-88",
       "CIE clear sky",
       Kind::kEquation,
       Print::kLost,
       "luminance from L_Z, theta, the sun's S and alpha, and gamma, the angle between sun and P",
       Verdict::kDerived,
       {},
       "L = L_Z (0.91 + 10 exp(-3 gamma) + 0.45 cos^2 gamma) (1 - exp(-0.32/cos theta)) / ((0.91 + 10 exp(-3 S) + "
       "0.45 cos^2 S) (1 - exp(-0.32))), cos gamma = cos S cos theta + sin S sin theta cos alpha",
       clear_sky_constants,
       "Decided: the zenith has L_Z, the law of cosines, and 0.91 = 1 - 10 exp(-3 pi/2) in two digits, which makes 90 "
       "degrees from the sun the unit. 10, -3, 0.45 and -0.32 are measurements, here as in Radiance's skybright.cal. "
       "gamma is not a planar angle but that of a great circle."},
      {"G-89",
       "CIE partly cloudy sky",
       Kind::kEquation,
       Print::kLost,
       "simpler than the clear sky, in the same symbols",
       Verdict::kUndecided,
       {},
       "",
       nullptr,
       "Likely L_Z (0.526 + 5 exp(-1.5 gamma)) (1 - exp(-0.80/cos theta)) / ((0.526 + 5 exp(-1.5 S)) (1 - "
       "exp(-0.80))): "
       "its zenith is L_Z and 0.526 = 1 - 5 exp(-1.5 pi/2), but its measured constants cannot be derived."},
      {"G-90",
       "Code hdr_lightsource (angular map)",
       Kind::kCode,
       Print::kRead,
       "r = acos(dz) / (pi sqrt(dx^2+dy^2)); (u,v) = (dx,dy) r; pixel = int(u size + size) >> 1, same for v; "
       "image[y size + x]",
       Verdict::kUnderReading,
       {{"exact numbers, off the z axis: distance angle/pi, the texel that holds (u,v)", directions_off_the_axis_map},
        {"exact numbers, +z and -z too", all_directions_map},
        {"single precision, near -z: the texel is in the image", single_precision_stays_in_the_image}},
       "as printed, (u,v) = (0,0) at +z, indices at most size-1",
       directions_off_the_axis_map,
       "0/0 at dx = dy = 0; at the rim u rounds to 1 and the index is size; |dz| above 1 by rounding gives NaN. "
       "Whether "
       "+v is up in the image is not said."},
      {"G-91",
       "Code SH_project_vector_function_rgb",
       Kind::kCode,
       Print::kRead,
       "result[n] += colour * coeff[n]; then times 4 pi / n_samples",
       Verdict::kCorrect,
       {{"converges to INT colour y_n; n samples give the mean of their contributions",
         projection_converges_to_coefficients}},
       "",
       nullptr,
       "The caller has to clear result. The callback has three arguments, hdr_lightsource five."},
  };
}

}  // namespace sh::symbolic::errata
