// Recipes: transferred radiance at many vertices under one light, by quadrature [SloanKautzSnyder02, section 4].
//
// With visibility V of degree 2n and a light L of degree n, the product with a function of degree n has degree 4n. n
// pairs of rings and the poles are exact for it in z, and M = 4n angles in phi, but for order 4n itself. It comes from
// three orders alone, 2n of V, n of L and n of the result. At phi_j = (j + 1/2) 2 pi / M, cos(2n phi_j) = 0 and
// sin(2n phi_j) = (-1)^j, so that the rings see v_s l_s where the product holds (v_c l_c + v_s l_s) / 2, and so on. The
// difference is, for cosine and sine of order n,
//     K (v_c l_c - v_s l_s),  -K (v_c l_s + v_s l_c),  K = integral of y_2n,2n y_nn y_nn.
//
// On each ring the parts of V by parity (codegen/recipes/product/phi_transform.hpp) give its samples at +-phi_j and
// pi +- phi_j; the light's samples there multiply them, and the transposed maps project the products.
#include <array>

#include "codegen/recipes/product/phi_transform.hpp"
#include "codegen/recipes/product/product.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;
using Parts = std::array<Value, kParts>;  // by part, or at phi_j, pi + phi_j, -phi_j, pi - phi_j

constexpr const char* kCitation =
    "P.-P. Sloan, J. Kautz, J. Snyder, \"Precomputed Radiance Transfer\", SIGGRAPH 2002, equation 11; by quadrature on "
    "rings of constant z (Lobatto; M. Abramowitz, I. Stegun, 1964, 25.4), split by parity; ";

ExactReal with_pi(const ExactReal& factor, int numerator, int denominator) {
  return multiply(factor, multiply(Surd(cln::cl_RA(numerator) / denominator), Surd::square_root(1, 2)));
}

class Transfer {
 public:
  Transfer(Kernel& kernel, int degree, int channels)
      : kernel_(kernel),
        build_(kernel),
        n_(degree),
        channels_(channels),
        quadrature_(Rings{degree, true, false}),
        of_light_(shape(n_)),
        of_visibility_(shape(2 * n_)) {}

  void prepare() {
    const std::vector<Value> light = build_.inputs(0, coefficient_count(n_));
    if (n_ == 0) {
      output(build_.times(symbolic::gaunt(0, 0, 0), light[0]));
      return;
    }
    for (int pair = 0; pair < n_; ++pair) {
      for (const auto& ring : samples_of(light, n_, pair, of_light_)) {
        for (const Parts& samples : ring) {
          for (const Value& sample : samples) output(sample);
        }
      }
    }
    for (const Value& sample : poles_of(light, n_)) output(sample);
    for (const int order : {n_, -n_}) output(build_.times(correction(), light[coefficient_index(n_, order)]));
  }

  void apply() {
    if (n_ == 0) {
      for (int channel = 0; channel < channels_; ++channel) {
        output(build_.times(build_.inputs(0, 1)[0], build_.inputs(1 + channel, 1)[0]));
      }
      return;
    }
    const int count = coefficient_count(2 * n_);
    const std::vector<Value> visibility = build_.inputs(0, count);
    const int size = kernel_.parameters[1].size() / channels_;
    for (int channel = 0; channel < channels_; ++channel) {
      lights_.push_back(build_.inputs(count + channel * size, size));
    }
    sums_.assign(channels_, std::vector<std::vector<Value>>(coefficient_count(n_)));
    add_poles(poles_of(visibility, 2 * n_));
    for (int pair = 0; pair < n_; ++pair) {
      const auto samples = samples_of(visibility, 2 * n_, pair, of_visibility_);
      for (int channel = 0; channel < channels_; ++channel) add_pair(pair, channel, samples);
    }
    correct(visibility);
    for (const auto& channel : sums_) {
      for (const std::vector<Value>& terms : channel) output(build_.sum(terms));
    }
  }

 private:
  using Samples = std::vector<std::vector<Parts>>;  // by ring of the pair, then by j

  [[nodiscard]] PhiShape shape(int degree) const {
    return {.degree = degree, .angles = 4 * n_, .rings = 2, .preferred = {}, .unscaled = {}, .half_step = true};
  }

  void output(Value value) { kernel_.outputs[written_++].node = build_.node(value); }

  // K, see above: the integral of y_2n,2n y_nn y_nn.
  [[nodiscard]] ExactReal correction() const {
    const int order = coefficient_index(n_, n_);
    return symbolic::gaunt(coefficient_index(2 * n_, 2 * n_), order, order);
  }

  // The coefficient of an order on a pair of rings: its parts even and odd in z, without the factor of the transform.
  [[nodiscard]] std::array<Value, 2> halves(const std::vector<Value>& c, int degree, int order, int ring,
                                            const ExactReal& scale) {
    std::array<std::vector<Value>, 2> terms;
    for (int l = std::abs(order); l <= degree; ++l) {
      const ExactReal factor = multiply(quadrature_.theta(l, std::abs(order), ring), scale);
      terms[(l - std::abs(order)) % 2].push_back(build_.times(factor, c[coefficient_index(l, order)]));
    }
    return {build_.sum(terms[0]), build_.sum(terms[1])};
  }

  [[nodiscard]] std::array<Value, 2> poles_of(const std::vector<Value>& c, int degree) {
    const auto [even, odd] = halves(c, degree, 0, n_, Surd(1));
    return {build_.plus(even, odd), build_.minus(even, odd)};
  }

  [[nodiscard]] Samples samples_of(const std::vector<Value>& c, int degree, int pair, const PhiTransform& phi) {
    PhiTransform::Coefficients on(2, std::vector<Value>(2 * degree + 1));
    for (int order = -degree; order <= degree; ++order) {
      const auto [even, odd] = halves(c, degree, order, pair, phi.scale(order));
      on[0][order + degree] = build_.plus(even, odd);
      on[1][order + degree] = phi.shared(order) ? even : build_.minus(even, odd);
    }
    Samples samples = phi.sample(build_, on);
    for (auto& ring : samples) {
      for (Parts& parts : ring) parts = turned(parts);
    }
    return samples;
  }

  // From parts to the values at phi_j, pi + phi_j, -phi_j, pi - phi_j; the transposed map is `turned_back`.
  [[nodiscard]] Parts turned(const Parts& p) {
    const Value a = build_.plus(p[0], p[1]), b = build_.minus(p[0], p[1]);
    const Value c = build_.plus(p[2], p[3]), d = build_.minus(p[2], p[3]);
    return {build_.plus(a, c), build_.minus(a, c), build_.plus(b, d), build_.minus(b, d)};
  }
  [[nodiscard]] Parts turned_back(const Parts& s) {
    const Value a = build_.plus(s[0], s[1]), c = build_.minus(s[0], s[1]);
    const Value b = build_.plus(s[2], s[3]), d = build_.minus(s[2], s[3]);
    return {build_.plus(a, b), build_.minus(a, b), build_.plus(c, d), build_.minus(c, d)};
  }

  void add_pair(int pair, int channel, const Samples& visibility) {
    Samples products = visibility;
    std::size_t next = static_cast<std::size_t>(pair) * 8 * n_;
    for (auto& ring : products) {
      for (Parts& at : ring) {
        for (Value& sample : at) sample = build_.times(sample, lights_[channel][next++]);
        at = turned_back(at);
      }
    }
    const PhiTransform::Coefficients c = of_light_.analyze(build_, products);
    for (int order = -n_; order <= n_; ++order) {
      const std::size_t at = order + n_;
      const bool once = of_light_.shared(order);
      const std::array<Value, 2> halves = {once ? c[0][at] : build_.plus(c[0][at], c[1][at]),
                                           once ? Value{} : build_.minus(c[0][at], c[1][at])};
      add(channel, pair, order, halves, with_pi(of_light_.scale(order), 2, 4 * n_));
    }
  }

  void add_poles(const std::array<Value, 2>& visibility) {
    for (int channel = 0; channel < channels_; ++channel) {
      const std::size_t first = 8 * n_ * n_;
      const Value north = build_.times(visibility[0], lights_[channel][first]);
      const Value south = build_.times(visibility[1], lights_[channel][first + 1]);
      add(channel, n_, 0, {build_.plus(north, south), build_.minus(north, south)}, with_pi(Surd(1), 2, 1));
    }
  }

  // out_lm += scale weight theta_lm (even or odd half)
  void add(int channel, int ring, int order, const std::array<Value, 2>& halves, const ExactReal& scale) {
    const int m = std::abs(order);
    const ExactReal weight = multiply(scale, quadrature_.weight(ring));
    for (int l = m; l <= n_; ++l) {
      const Value term = build_.times(multiply(weight, quadrature_.theta(l, m, ring)), halves[(l - m) % 2]);
      if (!term.is_zero()) sums_[channel][coefficient_index(l, order)].push_back(term);
    }
  }

  void correct(const std::vector<Value>& visibility) {
    const Value vc = visibility[coefficient_index(2 * n_, 2 * n_)], vs = visibility[coefficient_index(2 * n_, -2 * n_)];
    for (int channel = 0; channel < channels_; ++channel) {
      const std::size_t first = 8 * n_ * n_ + 2;
      const Value lc = lights_[channel][first], ls = lights_[channel][first + 1];
      auto& cosine = sums_[channel][coefficient_index(n_, n_)];
      auto& sine = sums_[channel][coefficient_index(n_, -n_)];
      cosine.insert(cosine.end(), {build_.times(vc, lc), -build_.times(vs, ls)});
      sine.insert(sine.end(), {-build_.times(vc, ls), -build_.times(vs, lc)});
    }
  }

  Kernel& kernel_;
  SignedBuilder build_;
  int n_;
  int channels_;
  RingQuadrature quadrature_;
  PhiTransform of_light_;  // and of the result, which has the same degree
  PhiTransform of_visibility_;
  std::size_t written_ = 0;
  std::vector<std::vector<Value>> lights_;             // by channel: the inputs
  std::vector<std::vector<std::vector<Value>>> sums_;  // by channel and coefficient: the terms of the result
};

}  // namespace

Kernel transfer_prepare(int degree) {
  Kernel kernel;
  kernel.citation = kCitation + RingQuadrature({degree, true, false}).definition();
  kernel.title = "A light of " + degrees_to(degree) + ", prepared for transfer_apply";
  kernel.domain = "any coefficients";
  kernel.result = "its values at the nodes of transfer_apply, in the order that it takes";
  kernel.parameters = {array(Role::kCoefficients, "light", degree)};
  kernel.results = {array(Role::kSamples, "samples", degree)};
  for (int i = 0; i < total_size(kernel.results); ++i) kernel.outputs.push_back({-1, "sample " + std::to_string(i)});
  Transfer(kernel, degree, 1).prepare();
  return kernel;
}

Kernel transfer_apply(int degree, int channels) {
  Kernel kernel;
  kernel.citation = kCitation + RingQuadrature({degree, true, false}).definition();
  kernel.title = "Transferred radiance of " + degrees_to(degree) + ": visibility times a prepared light";
  kernel.domain = "any coefficients of the visibility, " + degrees_to(2 * degree) + "; a light from transfer_prepare";
  kernel.result =
      "coefficients of visibility times light at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley "
      "phase";
  kernel.parameters = {array(Role::kCoefficients, "visibility", 2 * degree),
                       array(Role::kSamples, "samples", degree, channels)};
  kernel.results = {array(Role::kCoefficients, "out", degree, channels)};
  label_coefficients(kernel, degree, channels);
  Transfer(kernel, degree, channels).apply();
  return kernel;
}

}  // namespace sh::codegen::recipes
