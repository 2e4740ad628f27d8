// [Green03] SH Lighting Diffuse Surfaces, G-71 to G-79: unshadowed and shadowed transfer, interreflection.
//
// A transfer fragment is transcribed as a function of the number type. Carried out on the polynomials x, y, z of one
// sample it gives the contribution of that sample; the mean over the sphere of that is what the estimate converges to,
// exactly. Values hold S_lm, the rational part of Y_lm, for every l up to kDegree; openings are cones about the normal.
#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kDegree = 3;
constexpr int kCoefficients = (kDegree + 1) * (kDegree + 1);

cln::cl_RA albedo() { return cln::cl_RA(3) / 7; }
Surd reciprocal_pi() { return surd_pi().inverse(); }
Polynomial coordinate(int axis) { return Polynomial::variable(axis); }
Polynomial cosine() { return coordinate(2); }  // of the angle to a normal +z

template <class T>
struct Sample {
  std::array<T, 3> direction;
  std::vector<T> values;
};

// The code of the transfer, one channel: `above` decides H > 0, `blocked` is self_shadow.
template <class T, class Above, class Blocked>
std::vector<T> transfer_code(const std::vector<Sample<T>>& samples, const std::array<T, 3>& normal,
                             const T& reflectance, const T& area, Above above, Blocked blocked) {
  std::vector<T> result(to_size(kCoefficients), T(cln::cl_RA(0)));
  for (const Sample<T>& sample : samples) {
    const auto& d = sample.direction;
    const T h = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
    if (!above(h) || blocked(sample)) continue;
    for (std::size_t j = 0; j < result.size(); ++j) {
      const T value = h * sample.values[j];
      result[j] = result[j] + reflectance * value;
    }
  }
  const T factor = area * T(cln::cl_RA(1) / cln::cl_I(samples.size()));
  for (T& coefficient : result) coefficient = coefficient * factor;
  return result;
}

template <class Function>
void for_each_index(Function function) {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) function(l, m);
  }
}

Sample<cln::cl_RA> rational_sample(int x, int y, int z, int length) {
  const std::array<cln::cl_RA, 3> d{cln::cl_RA(x) / length, cln::cl_RA(y) / length, cln::cl_RA(z) / length};
  Sample<cln::cl_RA> sample{d, {}};
  for_each_index([&sample, &d](int l, int m) { sample.values.push_back(solid_harmonic(l, m).evaluate(d)); });
  return sample;
}

// What the code converges to with reflectance * unit for its albedo, area 4 pi and the normal R z, if the directions
// with s . normal > opening see the light: s = R s' with s' the x, y, z of the polynomials.
std::vector<Surd> limit_of_code(const cln::cl_RA& reflectance, const Surd& unit, const cln::cl_RA& opening) {
  const Matrix<Polynomial> r = rational_rotation();
  Sample<Polynomial> sample;
  for (int i = 0; i < 3; ++i) sample.direction[to_size(i)] = turned(coordinate(i), r);
  for_each_index([&](int l, int m) { sample.values.push_back(turned(solid_harmonic(l, m), r)); });
  const auto yes = [](const Polynomial&) { return true; };  // the region of integration says so
  const auto no = [](const Sample<Polynomial>&) { return false; };
  const Polynomial four(4);  // the area over pi
  const auto one_sample =
      transfer_code<Polynomial>({sample}, {r(0, 2), r(1, 2), r(2, 2)}, Polynomial(reflectance), four, yes, no);
  std::vector<Surd> limit;
  limit.reserve(one_sample.size());
  for (const Polynomial& p : one_sample) {
    // pi times the mean over the sphere, which is the integral over 4 pi.
    limit.push_back(unit * surd_pi() * Surd(cap_integral(p, opening) / 4));
  }
  return limit;
}

// (rho / pi) times the projection of max(0, N . s) restricted to the opening: by the addition theorem its coefficients
// are 2 pi (integral of t P_l(t) from the opening to 1) times those of a delta function towards N.
std::vector<Surd> exact_transfer(const cln::cl_RA& opening) {
  const Matrix<cln::cl_RA> r = constants(rational_rotation());
  const std::array<cln::cl_RA, 3> normal{r(0, 2), r(1, 2), r(2, 2)};
  std::vector<Surd> result;
  for_each_index([&](int l, int m) {
    const Polynomial profile = cosine() * legendre_polynomial(l, 2);
    const Surd moment = Surd(2 * definite_integral(profile, 2, Polynomial(opening), Polynomial(1)).coefficient({}));
    const Surd factor = cln::zerop(opening) ? irradiance_factor(l) : moment * surd_pi();
    result.push_back(Surd(albedo()) * reciprocal_pi() * factor * Surd(solid_harmonic(l, m).evaluate(normal)));
  });
  return result;
}

// Samples above and below the horizon, seen and blocked: the result is the mean of those of single samples.
bool code_averages_its_samples() {
  const std::vector<Sample<cln::cl_RA>> samples{rational_sample(2, 1, 2, 3), rational_sample(1, 2, -2, 3),
                                                rational_sample(2, 3, 6, 7), rational_sample(-6, 2, 3, 7)};
  const std::array<cln::cl_RA, 3> normal{0, 0, 1};
  const auto above = [](const cln::cl_RA& h) { return cln::plusp(h); };
  const auto blocked = [](const Sample<cln::cl_RA>& s) { return cln::minusp(s.direction[0]); };  // a wall at x < 0
  const auto all = transfer_code<cln::cl_RA>(samples, normal, albedo(), 4, above, blocked);
  for (int j = 0; j < kCoefficients; ++j) {
    cln::cl_RA sum = 0;
    for (const Sample<cln::cl_RA>& s : samples) {
      if (cln::minusp(s.direction[0]) || cln::minusp(s.direction[2])) continue;
      sum = sum + albedo() * s.direction[2] * s.values[to_size(j)];
    }
    if (all[to_size(j)] != 4 * sum / 4) return false;
  }
  return true;
}

enum class Albedo { kReflectance, kReflectanceOverPi };

cln::cl_RA full() { return 0; }
cln::cl_RA partial() { return cln::cl_RA(3) / 5; }

template <Albedo meaning, cln::cl_RA (*opening)()>
bool code_gives_transfer() {
  const Surd unit = meaning == Albedo::kReflectance ? Surd(1) : reciprocal_pi();
  return limit_of_code(albedo(), unit, opening()) == exact_transfer(opening()) && code_averages_its_samples();
}

// (rho / pi) INT L max(N . s, 0) with the normal +z.
Surd diffuse_radiance(const cln::cl_RA& rho, const Polynomial& light, const cln::cl_RA& opening) {
  return Surd(rho) * reciprocal_pi() * surd_pi() * Surd(cap_integral(light * cosine(), opening));
}
Surd irradiance(const Polynomial& light) { return surd_pi() * Surd(cap_integral(light * cosine(), 0)); }

// What leaves is the integral of the constant radiance over the hemisphere; the albedo is its share of what arrives.
Surd exitance(const Surd& radiance) { return radiance * surd_pi() * Surd(cap_integral(cosine(), 0)); }

std::vector<Polynomial> lights() {
  return {Polynomial(1), cosine(), Polynomial(2) + coordinate(0) * cosine(), coordinate(1).power(2)};
}

// G-71 with f_r = 1 / pi: a white surface returns what a constant light sends.
bool white_surface_in_constant_light() { return diffuse_radiance(1, Polynomial(1), 0) == Surd(1); }

// G-72
bool reflected_share_is_albedo() {
  for (const Polynomial& light : lights()) {
    if (!(exitance(diffuse_radiance(albedo(), light, 0)) / irradiance(light) == Surd(albedo()))) return false;
  }
  return true;
}

// G-73
bool radiance_over_irradiance_is(const Surd& ratio) {
  for (const Polynomial& light : lights()) {
    if (!(diffuse_radiance(albedo(), light, 0) / irradiance(light) == ratio)) return false;
  }
  return true;
}
// With rho the BRDF, pi rho is the share that is reflected, which the printed range would let exceed 1.
bool share_stays_below_one_over_printed_range() {
  const Surd brdf(1);  // the end of [0, 1]
  const Surd share = exitance(brdf * irradiance(Polynomial(1))) / irradiance(Polynomial(1));
  return cln::rational(share.evaluate(30)) <= 1;
}
bool radiosity_over_irradiance_is_pi_brdf() {
  const Surd brdf = Surd(albedo()) * reciprocal_pi();
  for (const Polynomial& light : lights()) {
    const Surd radiosity = exitance(brdf * irradiance(light));
    if (!(radiosity / irradiance(light) == surd_pi() * brdf) || !(surd_pi() * brdf == Surd(albedo()))) return false;
  }
  return true;
}

// G-74, G-77: the integral of light times the kernel, with a factor in front, against the exit radiance that makes the
// reflected share of what arrives through the opening the albedo.
bool kernel_gives_radiance(const Surd& factor, const cln::cl_RA& opening) {
  for (const Polynomial& light : lights()) {
    const Surd arriving = surd_pi() * Surd(cap_integral(light * cosine(), opening));
    const Surd radiance = factor * arriving;
    if (!(exitance(radiance) / arriving == Surd(albedo()))) return false;
  }
  return true;
}
template <cln::cl_RA (*opening)()>
bool kernel_with_factor() {
  return kernel_gives_radiance(Surd(albedo()) * reciprocal_pi(), opening());
}
template <cln::cl_RA (*opening)()>
bool kernel_with_albedo() {
  return kernel_gives_radiance(Surd(albedo()), opening());
}
template <cln::cl_RA (*opening)()>
bool kernel_alone() {
  return kernel_gives_radiance(Surd(1), opening());
}

// G-76: constant light through a round opening, cosine c of its half-angle a symbol: the share of the projected disc
// (Nusselt), a disc of radius sin.
constexpr int kOpening = 3;
Polynomial share_of_opening(const Polynomial& from, const Polynomial& to) {
  return definite_integral(2 * cosine(), 2, from, to);  // 2 pi t dt over pi
}
bool round_opening_is_projected_disc() {
  const Polynomial c = Polynomial::variable(kOpening);
  return share_of_opening(c, Polynomial(1)) == Polynomial(1) - c * c &&
         diffuse_radiance(albedo(), Polynomial(1), partial()) == Surd(albedo() * (1 - partial() * partial()));
}

// G-79: where the light and what the model reflects are both 1 everywhere, the opening does not matter.
bool furnace_of_direct_and_reflected_light() {
  const Polynomial c = Polynomial::variable(kOpening);
  const Polynomial direct = share_of_opening(c, Polynomial(1));
  const Polynomial reflected = share_of_opening(Polynomial(), c);
  return direct + reflected == Polynomial(1) && !(direct == Polynomial(1));
}

}  // namespace

std::vector<Entry> green_transfer() {
  constexpr auto kRho = Albedo::kReflectance;
  constexpr auto kRhoOverPi = Albedo::kReflectanceOverPi;
  return {
      {"G-71",
       "Diffuse Unshadowed Transfer, general",
       Kind::kEquation,
       Print::kRead,
       "L(x,wo) = INT_S f_r(x,wo,wi) L_i(x,wi) H(x,wi) dwi",
       Verdict::kCorrect,
       {{"H = max(0, N.wi): white Lambertian surface, f_r = 1/pi, returns a constant light unchanged",
         white_surface_in_constant_light}},
       "",
       nullptr,
       "The rendering equation without emission."},
      {"G-72",
       "L_DU",
       Kind::kEquation,
       Print::kRead,
       "L_DU(x) = (rho/pi) INT_S L_i(x,wi) max(N.wi, 0) dwi",
       Verdict::kCorrect,
       {{"what leaves is rho times what arrives, for several lights", reflected_share_is_albedo}},
       "",
       nullptr,
       "rho is the albedo."},
      {"G-73",
       "Note on albedo",
       Kind::kText,
       Print::kRead,
       "albedo = emitted radiance / irradiance; for diffuse surfaces pi rho; rho in [0, 1]",
       Verdict::kWrong,
       {{"radiance / irradiance = rho", [] { return radiance_over_irradiance_is(Surd(albedo())); }},
        {"radiance / irradiance = pi rho", [] { return radiance_over_irradiance_is(surd_pi() * Surd(albedo())); }},
        {"rho is the BRDF: pi rho is the reflected share, at most 1 for rho in [0, 1]",
         share_stays_below_one_over_printed_range}},
       "albedo = radiosity / irradiance = pi f_r = rho; radiance / irradiance = f_r = rho/pi",
       radiosity_over_irradiance_is_pi_brdf,
       "The rho of the equation above is the albedo itself, so pi rho is not."},
      {"G-74",
       "M_DU",
       Kind::kEquation,
       Print::kRead,
       "M_DU(s) = max(N.s, 0)",
       Verdict::kUnderReading,
       {{"kernel, rho/pi stays in front", kernel_with_factor<full>},
        {"rho, not rho/pi, in front (as the code multiplies by 'albedo')", kernel_with_albedo<full>},
        {"its product with the light is the exit radiance", kernel_alone<full>}},
       "L_DU = (rho/pi) INT L M_DU",
       kernel_with_factor<full>,
       "The text calls M_DU the transfer function itself."},
      {"G-75",
       "Code, unshadowed transfer",
       Kind::kCode,
       Print::kRead,
       "for H = s.N > 0: result[j] += albedo * Hs * coeff[j]; coeff = result * area / n_samples",
       Verdict::kUnderReading,
       {{"albedo = rho/pi, area = 4 pi", code_gives_transfer<kRhoOverPi, full>},
        {"albedo = rho, area = 4 pi", code_gives_transfer<kRho, full>}},
       "T_j = (rho/pi) (4 pi/N) sum max(s.N, 0) y_j(s)",
       code_gives_transfer<kRhoOverPi, full>,
       "H is declared and Hs used, area is not defined in the fragment: it does not compile. The later fragment "
       "divides "
       "kd by pi; with rho the result is pi times too bright."},
      {"G-76",
       "L_DS",
       Kind::kEquation,
       Print::kRead,
       "L_DS(x) = (rho/pi) INT_Omega L_i(wi) V(wi) max(N.wi, 0) dwi, V = 0 blocked, 1 free",
       Verdict::kCorrect,
       {{"constant light through a round opening: rho sin^2 of its half-angle", round_opening_is_projected_disc}},
       "",
       nullptr,
       "Omega may be the sphere or the hemisphere: the clamped cosine makes them equal."},
      {"G-77",
       "M_DS",
       Kind::kEquation,
       Print::kRead,
       "M_DS(w) = V(w) max(N.w, 0)",
       Verdict::kUnderReading,
       {{"kernel, rho/pi stays in front", kernel_with_factor<partial>},
        {"rho, not rho/pi, in front (as the code multiplies by 'albedo')", kernel_with_albedo<partial>},
        {"its product with the light is the exit radiance", kernel_alone<partial>}},
       "L_DS = (rho/pi) INT L M_DS",
       kernel_with_factor<partial>,
       "As M_DU."},
      {"G-78",
       "Code, shadowed transfer",
       Kind::kCode,
       Print::kRead,
       "as the unshadowed code, only where self_shadow(pos, s) is false",
       Verdict::kUnderReading,
       {{"albedo = rho/pi, area = 4 pi", code_gives_transfer<kRhoOverPi, partial>},
        {"albedo = rho, area = 4 pi", code_gives_transfer<kRho, partial>}},
       "T_j = (rho/pi) (4 pi/N) sum V(s) max(s.N, 0) y_j(s)",
       code_gives_transfer<kRhoOverPi, partial>,
       "Decided for a round opening about the normal. The same 1/pi."},
      {"G-79",
       "L_DI",
       Kind::kEquation,
       Print::kLost,
       "direct shadowed light plus light reflected from other points x' of the model",
       Verdict::kDerived,
       {},
       "L_DI(x) = L_DS(x) + (rho/pi) INT L(x',wi) (1 - V(wi)) max(N.wi, 0) dwi",
       furnace_of_direct_and_reflected_light,
       "L(x',wi) is the light that leaves x' towards x. Light and reflected light 1 everywhere give rho for every "
       "opening."},
  };
}

}  // namespace sh::symbolic::errata
