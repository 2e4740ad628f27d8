// Recipes: turn a zonal function to a direction, and add cap lights in closed form.
//
//     h(s . d) has coefficients sqrt(4 pi / (2l+1)) h_l Y_lm(d)      [SloanKautzSnyder02], symbolic/zonal/convolution.hpp
//
// The constants of Y_lm include the factor, and h_l multiplies the common part of (l, m) and (l, -m). This needs fewer
// operations than the basis and a scaling.
#include "codegen/recipes/zonal/zonal.hpp"

#include <cln/integer.h>

#include "codegen/recipes/zonal/columns.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

constexpr const char* kCitation =
    "P.-P. Sloan, J. Kautz, J. Snyder, \"Precomputed Radiance Transfer\", SIGGRAPH 2002; P.-P. Sloan, \"Stupid "
    "Spherical Harmonics (SH) Tricks\", GDC 2008; constants derived exactly";
constexpr const char* kOrder = "index l(l+1)+m, orthonormal, no Condon-Shortley phase";

// sqrt(4 pi / (2l+1)) times the factor of Y_lm, m >= 0.
Surd turned_factor(int l, int m) { return symbolic::convolution_factor(l) * whole_axial_form(l, m).scale; }

// The coefficients (l, m) and (l, -m) of one function: weight_l sqrt(4 pi/(2l+1)) Y_lm.
class Turned {
 public:
  Turned(SignedBuilder& build, const Direction& d, std::vector<NodeId> weights)
      : build_(build),
        d_(d),
        weights_(std::move(weights)),
        azimuth_(build, d),
        axial_(build, d.z, Wanted::kAll, turned_factor) {}

  // The coefficients in order of l(l+1)+m.
  std::vector<NodeId> coefficients() {
    const int degree = static_cast<int>(weights_.size()) - 1;
    std::vector<NodeId> result(weights_.size() * weights_.size());
    const auto at = [&](int l, int m) -> NodeId& { return result[coefficient_index(l, m)]; };
    for (int l = 0; l <= degree; ++l) at(l, 0) = axial(l, 0);
    for (int m = 1; m <= degree; ++m) {
      const auto [c, s] = azimuth_.power(m);
      for (int l = m; l <= degree; ++l) {
        const NodeId shared = axial(l, m);
        at(l, -m) = build_.mul(shared, s, indexed("y", l, m) + "s");
        at(l, m) = build_.mul(shared, c, indexed("y", l, m) + "c");
      }
    }
    return result;
  }

 private:
  // weight_l F_lm q_lm(z), F_lm the constant of the turned function.
  NodeId axial(int l, int m) {
    const NodeId weight = (l - m) % 2 == 0 ? weights_[l] : raised(l);
    return build_.mul(axial_.at(l, m), weight, indexed("p", l, m));
  }

  // weight_l z
  NodeId raised(int l) {
    raised_.resize(weights_.size(), -1);
    NodeId& node = raised_[l];
    if (node < 0) node = build_.mul(weights_[l], d_.z, numbered("z", l) + "z");
    return node;
  }

  SignedBuilder& build_;
  Direction d_;
  std::vector<NodeId> weights_;
  std::vector<NodeId> raised_;
  Azimuth azimuth_;
  AxialPolynomials axial_;
};

Kernel described_zonal(int degree) {
  Kernel kernel;
  kernel.title = "A zonal function of degree " + std::to_string(degree) + " turned from +z to a direction";
  kernel.citation = kCitation;
  kernel.domain = "|d| = 1 for d = (x, y, z), the new axis; zonal: any coefficients of Y_l0";
  kernel.result = "sqrt(4 pi/(2l+1)) zonal[l] Y_lm(d) at " + std::string(kOrder);
  kernel.parameters = with_direction({array(Role::kZonalCoefficients, "zonal", degree)});
  kernel.results = {array(Role::kCoefficients, "out", degree)};
  label_coefficients(kernel, degree);
  return kernel;
}

// The recurrence of functions whose squares have the mean 1/(2l+1): sqrt(l^2 - m^2) p_l = (2l-1) z p_(l-1) -
// sqrt((l-1)^2 - m^2) p_(l-2).
Surd turned_upper(int l, int m) { return Surd(2 * l - 1) / Surd::square_root(l * l - m * m); }
Surd turned_lower(int l, int m) {
  return Surd::square_root((l - 1) * (l - 1) - m * m) / Surd::square_root(l * l - m * m);
}

std::vector<NodeId> turned_column(Builder& build, NodeId z, int degree, int m) {
  const Surd power(cln::doublefactorial(m == 0 ? 0 : 2 * m - 1));
  const NodeId start = build.constant(turned_factor(m, m) * power, indexed("k", m, m));
  return append_column(build, {turned_upper, turned_lower}, z, start, degree, m);
}

Kernel described_cap(int degree, bool rgb) {
  Kernel kernel;
  const std::string to = " to coefficients of degree 0 to " + std::to_string(degree);
  kernel.title = rgb ? "Add a coloured cap light" + to + " of red, green and blue" : "Add a cap light" + to;
  kernel.citation = kCitation;
  kernel.domain =
      "|d| = 1 for d = (x, y, z), towards the light; 0 <= one_minus_cos <= 2, that is 1 - cos(half-angle), tiny caps "
      "included (2 sin(h/2)^2 for a small half-angle h); the colour is the radiance in the cap";
  kernel.parameters = with_direction({}, {parameter(Role::kCapSize, "one_minus_cos")});
  if (rgb) {
    for (int channel = 0; channel < 3; ++channel)
      kernel.parameters.push_back({std::string(1, "rgb"[channel]), {}, Role::kColor, -1, channel});
  } else {
    kernel.parameters.push_back(parameter(Role::kColor, "colour"));
  }
  const Parameter sum = array(Role::kCoefficients, "sum", degree, rgb ? 3 : 1);
  kernel.parameters.push_back(sum);
  kernel.results = {sum};
  kernel.result = "the coefficients with the light added, " + std::string(rgb ? "channel by channel, " : "") + kOrder;
  label_coefficients(kernel, degree, rgb ? 3 : 1);
  return kernel;
}

Kernel cap_light(int degree, bool rgb) {
  Kernel kernel = described_cap(degree, rgb);
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build, 0);
  const NodeId u = build.input(3, "u");
  const int channels = rgb ? 3 : 1;
  std::vector<NodeId> colours = inputs(build, 4, channels, "colour");
  const int count = coefficient_count(degree);
  const std::vector<NodeId> sum = inputs(build, 4 + channels, channels * count, "sum");
  const std::vector<NodeId> cap = append_cap(build, u, rgb ? -1 : colours[0], degree);
  const std::vector<NodeId> light = Turned(build, d, cap).coefficients();
  for (int i = 0; i < count; ++i) {
    for (int channel = 0; channel < channels; ++channel) {
      const NodeId added = rgb ? build.mul(colours[channel], light[i]) : light[i];
      const int k = channel * count + i;
      kernel.outputs[k].node = build.add(sum[k], added);
    }
  }
  return kernel;
}

}  // namespace

Kernel zonal_columns(int degree) {
  Kernel kernel = described_zonal(degree);
  SignedBuilder build(kernel);
  const std::vector<NodeId> zonal = inputs(build, 0, degree + 1, "zonal");
  const Direction d = direction_inputs(build, degree + 1);
  set_outputs(kernel, Turned(build, d, zonal).coefficients());
  return kernel;
}

Kernel zonal_recurrence(int degree) {
  Kernel kernel = described_zonal(degree);
  SignedBuilder build(kernel);
  const std::vector<NodeId> zonal = inputs(build, 0, degree + 1, "zonal");
  const Direction d = direction_inputs(build, degree + 1);
  Azimuth azimuth(build, d);
  for (int m = 0; m <= degree; ++m) {
    const std::vector<NodeId> p = turned_column(build, d.z, degree, m);
    for (int l = m; l <= degree; ++l) {
      const NodeId shared = build.mul(p[l - m], zonal[l]);
      const auto set = [&](int order, NodeId node) { kernel.outputs[coefficient_index(l, order)].node = node; };
      if (m == 0) {
        set(0, shared);
        continue;
      }
      const auto [c, s] = azimuth.power(m);
      set(-m, build.mul(shared, s));
      set(m, build.mul(shared, c));
    }
  }
  return kernel;
}

Kernel add_cap(int degree) { return cap_light(degree, false); }
Kernel add_cap_rgb(int degree) { return cap_light(degree, true); }

}  // namespace sh::codegen::recipes
