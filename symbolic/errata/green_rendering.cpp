// [Green03] interreflection in code, Rendering SH Diffuse Surfaces and local lights, G-80 to G-86.
//
// Fragments are transcribed and carried out on exact numbers in small scenes whose answer is known.
#include <algorithm>
#include <array>

#include "symbolic/basis/normalisation.hpp"
#include "symbolic/errata/exact_integrals.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

using Number = RadicalSum;

Number number(const cln::cl_RA& value) { return Number(value); }
cln::cl_RA ratio(int numerator, int denominator) { return cln::cl_RA(numerator) / denominator; }
Number pi() { return Number(surd_pi()); }

// G-80: an enclosure that radiates 1 from everywhere. The estimate converges to weight times the mean of the clamped
// cosine over the sphere; the surface has to send out its albedo.
bool enclosure_returns_albedo(const Surd& weight, const Surd& reflectance) {
  const Surd mean(cap_integral(Polynomial::variable(2), 0) / 4);
  return reflectance * weight * mean == Surd(ratio(3, 7));
}
Surd brdf() { return Surd(ratio(3, 7)) / surd_pi(); }
bool times_four_pi_and_brdf() { return enclosure_returns_albedo(Surd(4) * surd_pi(), brdf()); }
bool times_four_pi() { return enclosure_returns_albedo(Surd(4) * surd_pi(), Surd(1)); }
bool over_four_pi_and_brdf() { return enclosure_returns_albedo((Surd(4) * surd_pi()).inverse(), brdf()); }

// G-81: the code, with the ray tracer replaced by a table of hits on one face whose corners are points 0, 1, 2.
constexpr std::size_t kCoefficients = 2;
constexpr std::size_t kBlock = 3 * kCoefficients;  // a point's coefficients, channel by channel
constexpr int kPoints = 3;
constexpr int kBounces = 2;

using Direction = std::array<cln::cl_RA, 3>;
using Buffer = std::vector<Number>;

struct SelfHit {
  bool hit = false;
  cln::cl_RA u = 0;
  cln::cl_RA v = 0;
};

struct LightingPoint {
  Direction normal;
  std::array<cln::cl_RA, 3> kd;
  std::vector<SelfHit> hits;  // one per sample
};

cln::cl_RA dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void gather(const LightingPoint& point, const std::vector<Direction>& samples, const Buffer& from, Number* to) {
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (!point.hits[n].hit) continue;
    const cln::cl_RA cosine = dot(samples[n], point.normal);
    if (!cln::plusp(cosine)) continue;
    const cln::cl_RA u = point.hits[n].u;
    const cln::cl_RA v = point.hits[n].v;
    const cln::cl_RA w = 1 - (u + v);
    std::array<Number, kBlock> lerped;
    for (std::size_t k = 0; k < kBlock; ++k) {
      lerped[k] = number(u) * from[k] + number(v) * from[kBlock + k] + number(w) * from[2 * kBlock + k];
    }
    for (std::size_t k = 0; k < kCoefficients; ++k) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const Number albedo = number(point.kd[channel]) * pi().inverse();
        Number& sum = to[k + channel * kCoefficients];
        sum = sum + albedo * number(cosine) * lerped[k + channel * kCoefficients];
      }
    }
  }
}

Buffer self_transfer_code(const std::vector<LightingPoint>& points, const std::vector<Direction>& samples,
                          const Buffer& direct) {
  const Number area = number(4) * pi();
  const Number factor = area * number(1 / cln::cl_RA(cln::cl_I(samples.size())));
  std::vector<Buffer> buffers{direct};
  for (int bounce = 1; bounce <= kBounces; ++bounce) {
    Buffer next(direct.size());
    for (std::size_t i = 0; i < points.size(); ++i) gather(points[i], samples, buffers.back(), &next[i * kBlock]);
    for (Number& value : next) value = value * factor;
    buffers.push_back(next);
  }
  for (std::size_t bounce = 1; bounce < buffers.size(); ++bounce) {
    for (std::size_t j = 0; j < direct.size(); ++j) buffers[0][j] += buffers[bounce][j];
  }
  return buffers[0];
}

// A transfer that varies linearly over the plane of the face, corners (0,0), (1,0), (0,1).
struct Place {
  cln::cl_RA p = 0;
  cln::cl_RA q = 0;
};
cln::cl_RA linear_transfer(std::size_t k, const Place& place) {
  const cln::cl_I index(k);
  return 2 + index + (3 - 2 * index) * place.p + (index * index - 5) * place.q;
}

enum class Barycentric { kLastIsRemainder, kFirstIsRemainder };  // w goes with corner 2, or with corner 0

// Above the horizon the samples' cosines add up to 1 of 4 samples: the mean of the clamped cosine, 1/4. The ray with
// 2/3 of it hits the face at (u, v), the other sees the sky; rays below the horizon hit the face but do not count.
template <Barycentric convention>
bool bounces_add_linear_transfer_at_hit() {
  const std::vector<Direction> samples{{ratio(2, 3), ratio(1, 3), ratio(2, 3)},
                                       {ratio(2, 3), ratio(2, 3), ratio(1, 3)},
                                       {ratio(-2, 3), ratio(-1, 3), ratio(-2, 3)},
                                       {ratio(-2, 3), ratio(-2, 3), ratio(-1, 3)}};
  const SelfHit hit{true, ratio(1, 5), ratio(3, 7)};
  const std::array<cln::cl_RA, 3> kd{ratio(1, 2), ratio(2, 5), ratio(8, 9)};
  const LightingPoint point{{0, 0, 1}, kd, {hit, {}, hit, hit}};
  const std::array<Place, kPoints> corners{Place{0, 0}, Place{1, 0}, Place{0, 1}};
  const cln::cl_RA rest = 1 - hit.u - hit.v;
  const Place place = convention == Barycentric::kLastIsRemainder ? Place{hit.v, rest} : Place{hit.u, hit.v};
  Buffer direct;
  Buffer expected;
  for (const Place& corner : corners) {
    for (std::size_t k = 0; k < kBlock; ++k) {
      const cln::cl_RA share = ratio(2, 3) * kd[k / kCoefficients];
      const cln::cl_RA at_hit = linear_transfer(k, place);
      direct.push_back(number(linear_transfer(k, corner)));
      expected.push_back(number(linear_transfer(k, corner) + share * at_hit + share * share * at_hit));
    }
  }
  return self_transfer_code({point, point, point}, samples, direct) == expected;
}

// G-82, G-83: light and transfer of three bands, given as polynomials.
constexpr int kDegree = 2;

Polynomial combination(const std::vector<int>& weights) {
  Polynomial sum;
  std::size_t i = 0;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) sum += cln::cl_RA(weights[i++]) * solid_harmonic(l, m);
  }
  return sum;
}
Polynomial light() { return combination({3, 1, -2, 4, 1, -1, 2, 5, -3}); }
Polynomial other_light() { return combination({1, 0, 2, -3, 2, 6, -1, 1, 1}); }
Polynomial transfer() { return combination({2, -1, 3, 1, 0, 2, -2, 1, 4}); }
Polynomial other_transfer() { return combination({1, 4, -1, 0, 3, 1, 5, -2, 2}); }

std::vector<Surd> projected(const Polynomial& f) {
  std::vector<Surd> result;
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Surd integral = Surd(4 * sphere_mean(f * solid_harmonic(l, m))) * surd_pi();
      result.push_back(orthonormal_factor(l, m) * integral);
    }
  }
  return result;
}
Surd product_integral(const Polynomial& a, const Polynomial& b) { return Surd(4 * sphere_mean(a * b)) * surd_pi(); }

// One channel of each loop: an accumulator that starts at zero.
Surd plain_loop(const std::vector<Surd>& l, const std::vector<Surd>& sh) {
  Surd channel;
  for (std::size_t j = 0; j < l.size(); ++j) channel = channel + l[j] * sh[j];
  return channel;
}
Surd tinted_loop(const Surd& k, const std::vector<Surd>& l, const std::vector<Surd>& sh) {
  Surd channel;
  for (std::size_t j = 0; j < l.size(); ++j) channel = channel + k * l[j] * sh[j];
  return channel;
}
bool dot_product_is_integral() {
  return plain_loop(projected(light()), projected(transfer())) == product_integral(light(), transfer());
}
bool white_light_loop() {
  return dot_product_is_integral() &&
         plain_loop(projected(light()), projected(other_transfer())) == product_integral(light(), other_transfer());
}
bool coloured_light_loop() {
  return white_light_loop() && plain_loop(projected(other_light()), projected(other_transfer())) ==
                                   product_integral(other_light(), other_transfer());
}
bool tinted_transfer_loop() {
  const cln::cl_RA rho = ratio(5, 8);
  const Surd wanted = product_integral(light(), rho * transfer()) / surd_pi();
  return tinted_loop(Surd(rho) / surd_pi(), projected(light()), projected(transfer())) == wanted;
}

// G-84: the clamped cosine in the first bands, a polynomial in t (variable 0), at most a parabola.
Polynomial truncated_cosine(int bands) {
  Polynomial sum;
  for (int l = 0; l < bands; ++l) {
    sum += (cln::cl_RA(2 * l + 1) / 4 * irradiance_factor(l).rational()) * legendre_polynomial(l, 0);
  }
  return sum;
}
// The largest |p| of a parabola between two points.
cln::cl_RA largest(const Polynomial& p, const cln::cl_RA& from, const cln::cl_RA& to) {
  const auto size = [&p](const cln::cl_RA& t) { return cln::abs(p.evaluate(std::array{t})); };
  cln::cl_RA result = std::max(size(from), size(to));
  const cln::cl_RA curvature = p.coefficient({2});
  if (!cln::zerop(curvature)) {
    const cln::cl_RA vertex = -p.coefficient({1}) / (2 * curvature);
    if (from < vertex && vertex < to) result = std::max(result, size(vertex));
  }
  return result;
}
cln::cl_RA cosine_error(int bands) {
  const Polynomial p = truncated_cosine(bands);
  return std::max(largest(p, -1, 0), largest(p - Polynomial::variable(0), 0, 1));
}
bool two_bands_to_a_quarter() { return cosine_error(2) <= ratio(1, 4); }
bool two_bands_to_a_tenth() { return cosine_error(2) <= ratio(1, 10); }
bool four_coefficients_are_ambient_and_three_lights() {
  const auto weight = [](int i) { return Polynomial::variable(3 + i); };
  Polynomial sum = weight(0) * solid_harmonic(0, 0);
  for (int m = -1; m <= 1; ++m) sum += weight(2 + m) * solid_harmonic(1, m);
  Polynomial affine = weight(0);
  const std::array<int, 3> axes{1, 2, 0};
  for (int i = 0; i < 3; ++i) affine += weight(1 + i) * Polynomial::variable(axes[to_size(i)]);
  return sum == affine;
}
bool errors_of_two_and_three_bands() {
  return four_coefficients_are_ambient_and_three_lights() && cosine_error(2) == ratio(1, 4) &&
         cosine_error(3) == ratio(3, 32);
}

// G-85: weights of light points at given distances.
std::vector<cln::cl_RA> distance_weights(const std::vector<cln::cl_RA>& distances) {
  constexpr int kPower = 10;
  cln::cl_RA sum = 0;
  std::vector<cln::cl_RA> weights;
  for (const cln::cl_RA& d : distances) {
    weights.push_back(cln::expt(d, -kPower));
    sum = sum + weights.back();
  }
  for (cln::cl_RA& w : weights) w = w / sum;
  return weights;
}
bool normalised_weights_keep_uniform_light() {
  const std::vector<cln::cl_RA> w = distance_weights({ratio(1, 2), 3, ratio(7, 5)});
  const std::vector<cln::cl_RA> near = distance_weights({ratio(1, 1000), 1, 2});
  return w[0] + w[1] + w[2] == 1 && w[0] / w[1] == cln::expt(cln::cl_RA(6), 10) &&
         1 - near[0] < cln::expt(cln::cl_RA(10), -29);
}

// G-86: barycentric coordinates by areas in the plane of the lighting triangle.
cln::cl_RA area(const Place& a, const Place& b, const Place& c) {
  return (b.p - a.p) * (c.q - a.q) - (c.p - a.p) * (b.q - a.q);
}
const std::array<Place, 3>& triangle() {
  static const std::array<Place, 3> corners{Place{0, 0}, Place{4, 1}, Place{1, 3}};
  return corners;
}
std::array<cln::cl_RA, 3> weights_at(const Place& place) {
  const auto& [a, b, c] = triangle();
  const cln::cl_RA whole = area(a, b, c);
  return {area(place, b, c) / whole, area(a, place, c) / whole, area(a, b, place) / whole};
}
std::vector<Place> projections() { return {{ratio(3, 2), 1}, {2, ratio(4, 3)}, {5, 2}}; }  // the last one is outside

bool weights_reproduce_linear_light() {
  for (const Place& place : projections()) {
    const std::array<cln::cl_RA, 3> w = weights_at(place);
    for (std::size_t k = 0; k < 3; ++k) {
      cln::cl_RA sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum = sum + w[i] * linear_transfer(k, triangle()[i]);
      if (sum != linear_transfer(k, place)) return false;
    }
  }
  return true;
}
bool weights_are_between_zero_and_one() {
  for (const Place& place : projections()) {
    for (const cln::cl_RA& w : weights_at(place)) {
      if (cln::minusp(w) || w > 1) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> green_rendering() {
  constexpr auto kLast = Barycentric::kLastIsRemainder;
  constexpr auto kFirst = Barycentric::kFirstIsRemainder;
  return {
      {"G-80",
       "Four steps of interreflection",
       Kind::kText,
       Print::kRead,
       "(b) interpolate the transfer at the hit, (c) times the cosine, summed, divided by the number of samples and "
       "the "
       "Monte Carlo weighting term, (d) bounces added to the direct part",
       Verdict::kUnderReading,
       {{"times 4 pi / N and the rho/pi of the receiver: an enclosure of radiance 1 gives rho", times_four_pi_and_brdf},
        {"times 4 pi / N, nothing of the receiver", times_four_pi},
        {"divided by 4 pi N, times rho/pi", over_four_pi_and_brdf}},
       "T_b(x) = (rho/pi) (4 pi/N) sum (1-V) max(N.s, 0) T_(b-1)(x')",
       times_four_pi_and_brdf,
       "Step (c) does not name the reflectance of the receiver; the code has it."},
      {"G-81",
       "Code self_transfer_sh",
       Kind::kCode,
       Print::kRead,
       "albedo = kd/pi; sh = u v0 + v v1 + w v2, w = 1-(u+v); buffer[b][i] += albedo Hs sh; times 4 pi/n; buffers "
       "added",
       Verdict::kUnderReading,
       {{"hit = u V0 + v V1 + (1-u-v) V2: a linear transfer is gathered at the hit, over two bounces",
         bounces_add_linear_transfer_at_hit<kLast>},
        {"hit = (1-u-v) V0 + u V1 + v V2, as many ray tracers count", bounces_add_linear_transfer_at_hit<kFirst>}},
       "sh = sum of the corners' transfers with the weights that make the hit point",
       bounces_add_linear_transfer_at_hit<kLast>,
       "Needs a direct pass with rho/pi (G-75). It does not test that the hit faces the receiver, as the text asks. "
       "One "
       "brace too many after the scaling, one missing at the end, fptr for face_ptr, k and i out of scope."},
      {"G-82",
       "Rendering diffuse surfaces",
       Kind::kEquation,
       Print::kLost,
       "dot product of the coefficients of light and transfer",
       Verdict::kDerived,
       {},
       "L = sum_(i=0)^(n^2-1) L_i t_i",
       dot_product_is_integral,
       "Equals INT L t for band-limited light and transfer. Eq. 7 prints the sum from 0 to n^2."},
      {"G-83",
       "Three lighting loops",
       Kind::kCode,
       Print::kRead,
       "red += light[j] sh_red[j]; red += light_red[j] sh_red[j]; red += k_red light[j] sh[j]",
       Verdict::kCorrect,
       {{"white light", white_light_loop},
        {"a light per channel", coloured_light_loop},
        {"one transfer without albedo, k = rho/pi", tinted_transfer_loop}},
       "",
       nullptr,
       "Accumulators have to start at zero. The third form has no colour bleeding, as the text says."},
      {"G-84",
       "4-coefficient claim",
       Kind::kText,
       Print::kRead,
       "two bands approximate the cosine well, at the work of three parallel lights and ambient",
       Verdict::kUnderReading,
       {{"to a quarter of the peak", two_bands_to_a_quarter},
        {"to a tenth of the peak, as three bands do", two_bands_to_a_tenth},
        {"four coefficients: ambient plus three dot terms of the normal",
         four_coefficients_are_ambient_and_three_lights}},
       "max(t, 0) = 1/4 + t/2 to 1/4 with two bands (affine in the normal), to 3/32 with three",
       errors_of_two_and_three_bands,
       ""},
      {"G-85",
       "Local light weights",
       Kind::kEquation,
       Print::kLost,
       "weight between vertex i and light point j by distance, n = 10",
       Verdict::kDerived,
       {},
       "w_ij = d_ij^-n / sum_k d_ik^-n",
       normalised_weights_keep_uniform_light,
       "The weights have to add up to 1, or a uniform light changes. Singular at d = 0, where the limit is that light "
       "point alone."},
      {"G-86",
       "Polyhedron weights",
       Kind::kText,
       Print::kRead,
       "project the vertex on the nearest lighting triangle; its 2D barycentric coordinates are the weights",
       Verdict::kUnderReading,
       {{"the weights reproduce light that varies linearly over the plane", weights_reproduce_linear_light},
        {"the weights of every vertex lie between 0 and 1", weights_are_between_zero_and_one}},
       "",
       nullptr,
       "A projection outside the triangle extrapolates, with negative weights."},
  };
}

}  // namespace sh::symbolic::errata
