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
//
// A glossy vertex needs one number of the result only: its product with the lobe, turned to the reflected view
// direction [equation 12]. The lobe is a third function of degree n at the nodes. It replaces the projection of every
// channel.
#include <array>

#include "codegen/recipes/product/phi_transform.hpp"
#include "codegen/recipes/product/product.hpp"
#include "codegen/recipes/product/ring_factor.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;
using Parts = std::array<Value, kParts>;  // by part, or at phi_j, pi + phi_j, -phi_j, pi - phi_j

std::string citation(const char* equation, int degree) {
  return std::string("P.-P. Sloan, J. Kautz, J. Snyder, \"Precomputed Radiance Transfer\", SIGGRAPH 2002, ") +
         equation +
         "; by quadrature on rings of constant z (Lobatto; M. Abramowitz, I. Stegun, 1964, 25.4), split by parity; " +
         RingQuadrature({degree, true, false}).definition();
}

class Transfer {
 public:
  // looped: a loop runs over the pairs of rings.
  Transfer(Kernel& kernel, int degree, int channels, bool looped)
      : kernel_(kernel),
        build_(kernel),
        n_(degree),
        channels_(channels),
        looped_(looped && degree > 1),
        quadrature_(Rings{degree, true, false}),
        factors_(kernel, quadrature_, looped_),
        of_light_(shape(n_)),
        of_visibility_(shape(2 * n_)) {}

  void prepare() {
    const std::vector<Value> light = build_.inputs(0, coefficient_count(n_));
    if (n_ == 0) {
      output(build_.times(symbolic::gaunt(0, 0, 0), light[0]));
      return;
    }
    for (int pair = 0; pair < n_; ++pair) {
      for (const std::vector<Value>& ring : on_rings(light, n_, pair, of_light_, factors_.one(pair))) {
        for (const Parts& samples : samples_of(ring, of_light_)) {
          for (const Value& sample : samples) output(sample);
        }
      }
    }
    for (const Value& sample : poles_of(light, n_, factors_.one(n_))) output(sample);
    for (const int order : {n_, -n_}) output(build_.times(correction(), light[coefficient_index(n_, order)]));
  }

  void apply() {
    if (n_ == 0) {
      for (int channel = 0; channel < channels_; ++channel) {
        output(build_.times(build_.inputs(0, 1)[0], light(channel, 0)));
      }
      return;
    }
    const std::vector<Value> visibility = build_.inputs(0, coefficient_count(2 * n_));
    sums_.assign(channels_, std::vector<std::vector<Value>>(coefficient_count(n_)));
    add_poles(poles_of(visibility, 2 * n_, factors_.one(n_)));
    for (int pair = 0; pair < (looped_ ? 1 : n_); ++pair) {
      add_pair(pair, on_rings(visibility, 2 * n_, pair, of_visibility_, factors_.one(pair)));
    }
    correct(visibility);
    for (const auto& channel : sums_) {
      for (const std::vector<Value>& terms : channel) output(build_.sum(terms));
    }
  }

  void reflect() {
    const std::vector<Value> visibility = build_.inputs(0, coefficient_count(2 * n_));
    const std::vector<Value> lobe = turned_lobe();
    if (n_ == 0) {
      const Value seen = build_.times(visibility[0], lobe[0]);
      for (int channel = 0; channel < channels_; ++channel) output(build_.times(seen, light(channel, 0)));
      return;
    }
    dots_.resize(channels_);
    for (int pair = 0; pair < (looped_ ? 1 : n_); ++pair) {
      const OnRings of_visibility = on_rings(visibility, 2 * n_, pair, of_visibility_, factors_.one(pair));
      const OnRings of_lobe = on_rings(lobe, n_, pair, of_light_, ring_weight(pair));
      for (std::size_t ring = 0; ring < of_lobe.size(); ++ring) {
        const Samples seen = samples_of(of_visibility[ring], of_visibility_);
        add_dots(products(seen, samples_of(of_lobe[ring], of_light_)), looped_);
      }
    }
    samples_met_ = 8 * static_cast<std::size_t>(n_) * n_;
    const auto [north, south] = poles_of(visibility, 2 * n_, factors_.one(n_));
    const auto [lobe_north, lobe_south] = poles_of(lobe, n_, pole_weight());
    const auto [vc, vs] = top_orders(visibility, 2 * n_);
    const auto [gc, gs] = top_orders(lobe, n_);
    const Value at_north = build_.times(north, lobe_north), at_south = build_.times(south, lobe_south);
    const Value ss = build_.times(vs, gs), cc = build_.times(vc, gc), cosine = build_.minus(cc, ss);
    const Value cs = build_.times(vc, gs), sc = build_.times(vs, gc), sine = -build_.plus(sc, cs);
    add_dots({at_north, at_south, cosine, sine});
    for (const std::vector<Value>& dots : dots_) output(build_.balanced_sum(dots));
  }

 private:
  using Samples = std::vector<Parts>;                 // of one ring, by j
  using OnRings = std::array<std::vector<Value>, 2>;  // the coefficients of all orders on the rings of a pair

  [[nodiscard]] PhiShape shape(int degree) const {
    return {.degree = degree, .angles = 4 * n_, .rings = 1, .preferred = {}, .unscaled = {}, .half_step = true};
  }

  // A sample of a channel's light. in_loop: of the pair of rings of the current row.
  [[nodiscard]] Value light(int channel, std::size_t sample, bool in_loop = false) {
    const int first = kernel_.parameters[0].size() + channel * kernel_.parameters[1].size() / channels_;
    return {build_.input(first + static_cast<int>(sample), "", in_loop ? 8 * n_ : 0)};
  }

  // The lobe, a zonal function, about the direction; both follow the samples of the light.
  std::vector<Value> turned_lobe() {
    const Kernel zonal = zonal_columns(n_);
    const int first = kernel_.parameters[0].size() + kernel_.parameters[1].size();
    std::vector<NodeId> nodes = inputs(build_, first, n_ + 1, "lobe");
    const Direction d = direction_inputs(build_, first + n_ + 1);
    nodes.insert(nodes.end(), {d.x, d.y, d.z});
    std::vector<Value> turned;
    for (const NodeId node : splice(build_, zonal, nodes)) turned.push_back({node});
    return turned;
  }

  [[nodiscard]] std::vector<Value> products(const Samples& a, const Samples& b) {
    std::vector<Value> products;
    for (std::size_t j = 0; j < a.size(); ++j) {
      for (std::size_t i = 0; i < kParts; ++i) products.push_back(build_.times(a[j][i], b[j][i]));
    }
    return products;
  }

  // For every channel the sum of the values times the next samples of the light.
  void add_dots(const std::vector<Value>& values, bool in_loop = false) {
    for (int channel = 0; channel < channels_; ++channel) {
      std::vector<Value> terms;
      for (std::size_t i = 0; i < values.size(); ++i) {
        terms.push_back(build_.times(values[i], light(channel, samples_met_ + i, in_loop)));
      }
      const Value dot = build_.sum(terms);
      dots_[channel].push_back(in_loop ? build_.row_sum(dot) : dot);
    }
    samples_met_ += values.size();
  }

  void output(Value value) { kernel_.outputs[written_++].node = build_.node(value); }

  // K, see above: the integral of y_2n,2n y_nn y_nn.
  [[nodiscard]] ExactReal correction() const {
    const int order = coefficient_index(n_, n_);
    return symbolic::gaunt(coefficient_index(2 * n_, 2 * n_), order, order);
  }

  // The coefficient of an order on a pair of rings: its parts even and odd in z, times a scale.
  [[nodiscard]] std::array<Value, 2> halves(const std::vector<Value>& c, int degree, int order, int ring,
                                            const Factor& scale) {
    std::array<std::vector<Value>, 2> terms;
    for (int l = std::abs(order); l <= degree; ++l) {
      const Factor factor = times(factors_.theta(l, std::abs(order), ring), scale);
      terms[(l - std::abs(order)) % 2].push_back(factors_.scaled(build_, factor, c[coefficient_index(l, order)]));
    }
    return {build_.sum(terms[0]), build_.sum(terms[1])};
  }

  // scale: multiplies all values.
  [[nodiscard]] std::array<Value, 2> poles_of(const std::vector<Value>& c, int degree, const Factor& scale) {
    const auto [even, odd] = halves(c, degree, 0, n_, scale);
    return {build_.plus(even, odd), build_.minus(even, odd)};
  }

  [[nodiscard]] OnRings on_rings(const std::vector<Value>& c, int degree, int pair, const PhiTransform& phi,
                                 const Factor& scale) {
    OnRings on;
    for (int order = -degree; order <= degree; ++order) {
      const auto [even, odd] = halves(c, degree, order, pair, times(scale, phi.scale(order)));
      on[0].push_back(build_.plus(even, odd));
      on[1].push_back(build_.minus(even, odd));
    }
    return on;
  }

  [[nodiscard]] Samples samples_of(const std::vector<Value>& on_ring, const PhiTransform& phi) {
    Samples samples = phi.sample(build_, {on_ring}).front();
    for (Parts& parts : samples) parts = turned(parts);
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

  // One ring after the other, all channels of each: few samples are live at once.
  void add_pair(int pair, const OnRings& visibility) {
    std::vector<OnRings> results(channels_);
    for (std::size_t ring = 0; ring < visibility.size(); ++ring) {
      const Samples seen = samples_of(visibility[ring], of_visibility_);
      for (int channel = 0; channel < channels_; ++channel) {
        results[channel][ring] = times_light(seen, channel, 2 * static_cast<std::size_t>(pair) + ring);
      }
    }
    for (int channel = 0; channel < channels_; ++channel) {
      for (int order = -n_; order <= n_; ++order) {
        const Value& a = results[channel][0][order + n_];
        const Value& b = results[channel][1][order + n_];
        add(channel, pair, order, {build_.plus(a, b), build_.minus(a, b)},
            times(ring_weight(pair), of_light_.scale(order)));
      }
    }
  }

  // The coefficients of the product with a channel's light on a ring.
  [[nodiscard]] std::vector<Value> times_light(Samples samples, int channel, std::size_t ring) {
    std::size_t next = ring * 4 * n_;
    for (Parts& at : samples) {
      for (Value& sample : at) sample = build_.times(sample, light(channel, next++, looped_));
      at = turned_back(at);
    }
    return of_light_.analyze(build_, {samples}).front();
  }

  void add_poles(const std::array<Value, 2>& visibility) {
    for (int channel = 0; channel < channels_; ++channel) {
      const std::size_t first = 8 * n_ * n_;
      const Value north = build_.times(visibility[0], light(channel, first));
      const Value south = build_.times(visibility[1], light(channel, first + 1));
      add(channel, n_, 0, {build_.plus(north, south), build_.minus(north, south)}, pole_weight());
    }
  }

  // out_lm += weight theta_lm (even or odd half)
  void add(int channel, int ring, int order, const std::array<Value, 2>& halves, const Factor& weight) {
    const int m = std::abs(order);
    for (int l = m; l <= n_; ++l) {
      const Value term = factors_.scaled(build_, times(weight, factors_.theta(l, m, ring)), halves[(l - m) % 2]);
      if (term.is_zero()) continue;
      sums_[channel][coefficient_index(l, order)].push_back(weight.size() > 1 ? build_.row_sum(term) : term);
    }
  }

  // The weight of a node.
  [[nodiscard]] Factor ring_weight(int pair) const { return times(factors_.weight(pair), pi_times(2, 4 * n_)); }
  [[nodiscard]] Factor pole_weight() const { return times(factors_.weight(n_), pi_times(2, 1)); }

  // The cosine and the sine of the largest order.
  [[nodiscard]] static std::array<Value, 2> top_orders(const std::vector<Value>& c, int degree) {
    return {c[coefficient_index(degree, degree)], c[coefficient_index(degree, -degree)]};
  }

  void correct(const std::vector<Value>& visibility) {
    const auto [vc, vs] = top_orders(visibility, 2 * n_);
    for (int channel = 0; channel < channels_; ++channel) {
      const std::size_t first = 8 * n_ * n_ + 2;
      const Value lc = light(channel, first), ls = light(channel, first + 1);
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
  bool looped_;
  RingQuadrature quadrature_;
  RingFactors factors_;
  PhiTransform of_light_;  // and of the result, which has the same degree
  PhiTransform of_visibility_;
  std::size_t written_ = 0;
  std::vector<std::vector<std::vector<Value>>> sums_;  // by channel and coefficient: the terms of the result
  std::vector<std::vector<Value>> dots_;               // by channel: parts of the one number of the result
  std::size_t samples_met_ = 0;                        // in dots_
};

// The parameters and texts that kernels on visibility and a prepared light share.
Kernel frame(int degree, int channels) {
  Kernel kernel;
  kernel.domain = "any coefficients of the visibility, " + degrees_to(2 * degree) + "; a light from transfer_prepare";
  kernel.parameters = {array(Role::kCoefficients, "visibility", 2 * degree),
                       array(Role::kSamples, "samples", degree, channels)};
  return kernel;
}

}  // namespace

Kernel transfer_prepare(int degree) {
  Kernel kernel;
  kernel.citation = citation("equation 11", degree);
  kernel.title = "A light of " + degrees_to(degree) + ", prepared for transfer_apply";
  kernel.domain = "any coefficients";
  kernel.result = "its values at the nodes of transfer_apply, in the order that it takes";
  kernel.parameters = {array(Role::kCoefficients, "light", degree)};
  kernel.results = {array(Role::kSamples, "samples", degree)};
  for (int i = 0; i < total_size(kernel.results); ++i) kernel.outputs.push_back({-1, "sample " + std::to_string(i)});
  Transfer(kernel, degree, 1, false).prepare();
  return kernel;
}

Kernel transfer_apply(int degree, int channels, bool looped) {
  Kernel kernel = frame(degree, channels);
  kernel.citation = citation("equation 11", degree);
  kernel.title = "Transferred radiance of " + degrees_to(degree) + ": visibility times a prepared light";
  kernel.result =
      "coefficients of visibility times light at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley "
      "phase";
  kernel.results = {array(Role::kCoefficients, "out", degree, channels)};
  label_coefficients(kernel, degree, channels);
  Transfer(kernel, degree, channels, looped).apply();
  return kernel;
}

Kernel transfer_glossy(int degree, int channels, bool looped) {
  Kernel kernel = frame(degree, channels);
  kernel.citation = citation("equation 12", degree);
  kernel.title = "Radiance that a glossy vertex reflects: transferred radiance of " + degrees_to(degree) +
                 ", convolved with a lobe, in one direction";
  kernel.domain += "; lobe: any coefficients of Y_l0; |d| = 1 for d = (x, y, z), the reflected view direction";
  kernel.parameters =
      with_direction({kernel.parameters[0], kernel.parameters[1], array(Role::kZonalCoefficients, "lobe", degree)});
  kernel.result = "the sum of sqrt(4 pi/(2l+1)) lobe[l] t_lm Y_lm(d), t = visibility times light";
  if (channels == 1) {
    kernel.result = "returns " + kernel.result;
    kernel.results = {parameter(Role::kValue, "value")};
    kernel.outputs = {{-1, ""}};
  } else {
    kernel.result = "red, green, blue: " + kernel.result;
    kernel.results = {{"rgb", {3}, Role::kValue}};
    kernel.outputs = {{-1, "red"}, {-1, "green"}, {-1, "blue"}};
  }
  Transfer(kernel, degree, channels, looped).reflect();
  return kernel;
}

}  // namespace sh::codegen::recipes
