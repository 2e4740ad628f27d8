// Recipes: irradiance from radiance of degree 1 and a zonal band 2 that band 1 suggests [RoughtonSloan24]. Along the axis
// of band 1 the coefficient of this band is |c_1| (0.08 + 0.6 |c_1| / c_00), a fit of the authors to captured light.
//
// Radiance that is nowhere negative has |c_1| <= sqrt(3) c_00. Beyond this, and at c_00 <= 0, the quotient stays at
// sqrt(3), so that no small c_00 makes the band large. Black light has no axis; its irradiance is 0.
#include <array>

#include "codegen/recipes/basis/sphere.hpp"
#include "codegen/recipes/parts.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

constexpr int kDegree = 1;
constexpr int kCount = 4;

Surd ratio(long numerator, long denominator) { return Surd(cln::cl_RA(numerator) / denominator); }

// A_l times the coefficient of z^l in Y_l0 (l <= 1), or times that of (3 z^2 - 1) in Y_20.
Surd irradiance_constant(int l) {
  const AxialForm form = whole_axial_form(l, 0);
  return symbolic::irradiance_factor(l) * form.scale * Surd(l == 2 ? -form.powers[0] : form.powers[0]);
}

Kernel zh3_described(int channels) {
  Kernel kernel;
  kernel.title =
      "Irradiance towards a normal from radiance of degree 0 to 1 and a zonal band 2 that band 1 suggests (ZH3)";
  kernel.citation =
      "T. Roughton, P.-P. Sloan, A. Silvennoinen, M. Iwanicki, P. Shirley, \"ZH3: Quadratic Zonal Harmonics\", Proc. "
      "ACM Comput. Graph. Interact. Tech. 7 (1), 2024; constants derived exactly but for the fit 0.08, 0.6";
  kernel.domain =
      "|n| = 1 for the normal n = (x, y, z); c (radiance): index l(l+1)+m, orthonormal, no Condon-Shortley phase, and "
      "0 or of size 1e-15 to 1e15; where |c_1| > sqrt(3) c_00, as no radiance has it, the suggestion stays that at "
      "sqrt(3)";
  kernel.result = "E(n) = sum A_l c_lm Y_lm(n) of bands 0 to 2; diffuse exit radiance is albedo/pi E";
  kernel.parameters = with_direction({array(Role::kCoefficients, "c", kDegree, channels)});
  return kernel;
}

// The values that all channels share.
class Zh3 {
 public:
  Zh3(Builder& build, const Direction& normal) : build_(build), n_(normal) {
    k0_ = build.constant(irradiance_constant(0), "k0");
    k1_ = build.constant(irradiance_constant(1), "k1");
    // Both numbers of the fit hold A_2 sqrt(5 / (16 pi)).
    least_ = build.constant(irradiance_constant(2) * ratio(2, 25), "k_fit1");
    slope_ = build.constant(irradiance_constant(2) * ratio(3, 5), "k_fit2");
    shortest_ = build.constant(Surd::square_root(cln::cl_RA(1) / 3), "k_most");
    zero_ = build.constant(Surd(), "none");
    three_ = build.constant(ratio(3, 1), "three");
    other_ = build.constant(ratio(2, 1), "other");
  }

  [[nodiscard]] NodeId zero() const { return zero_; }
  // The product of a vector in the order y, z, x with the normal.
  NodeId towards_normal(const std::array<NodeId, 3>& v) { return dot(v, {n_.y, n_.z, n_.x}); }
  NodeId dot(const std::array<NodeId, 3>& a, const std::array<NodeId, 3>& b) {
    const NodeId first = build_.mul(a[0], b[0]);
    const NodeId second = build_.add(first, build_.mul(a[1], b[1]));
    return build_.add(second, build_.mul(a[2], b[2]));
  }
  // A divisor; of a zero, which divides a zero, any other number.
  NodeId divisor(NodeId a) { return build_.select(zero_, a, a, other_); }
  // 3 a^2 - b
  NodeId parabola(NodeId a, NodeId b) { return build_.sub(build_.mul(three_, build_.mul(a, a)), b); }
  // c_00, or |c_1| / sqrt(3) where that is more.
  NodeId mean(NodeId c00, NodeId size, const std::string& name) {
    const NodeId least = build_.mul(shortest_, size);
    return build_.select(c00, least, least, c00, name);
  }
  // 0.08 mean + 0.6 size with their factors
  NodeId fit(NodeId mean, NodeId size) { return build_.add(build_.mul(least_, mean), build_.mul(slope_, size)); }
  // The irradiance of degree 1. towards: c_1 n
  NodeId linear(NodeId c00, NodeId towards) { return build_.add(build_.mul(k0_, c00), build_.mul(k1_, towards)); }

 private:
  Builder& build_;
  Direction n_;
  NodeId k0_, k1_, least_, slope_, shortest_, zero_, three_, other_;
};

}  // namespace

// With s = |c_1|^2: the band is |c_1| (0.08 + 0.6 |c_1| / c_00) (3 (c_1 n)^2 / s - 1), here with one division.
Kernel irradiance_zh3(int /*degree*/) {
  Kernel kernel = zh3_described(1);
  kernel.results = {parameter(Role::kValue, "irradiance")};
  Builder build(kernel);
  const std::vector<NodeId> c = inputs(build, 0, kCount, "c");
  Zh3 zh3(build, direction_inputs(build, kCount));
  const std::array<NodeId, 3> c1{c[1], c[2], c[3]};
  const NodeId square = zh3.dot(c1, c1);
  const NodeId size = build.sqrt(square, "size");
  const NodeId towards = zh3.towards_normal(c1);
  const NodeId mean = zh3.mean(c[0], size, "mean");
  const NodeId quotient = build.div(zh3.fit(mean, size), zh3.divisor(build.mul(mean, size)));
  const NodeId band = build.mul(quotient, zh3.parabola(towards, square), "band2");
  kernel.outputs = {{build.add(zh3.linear(c[0], towards), band), "E(n)"}};
  return kernel;
}

Kernel irradiance_zh3_rgb(int /*degree*/) {
  Kernel kernel = zh3_described(3);
  kernel.domain += "; all channels share the axis of luminance (Rec. 709), as the source advises";
  kernel.results = {parameter(Role::kValue, "irradiance")};
  kernel.results[0].shape = {3};
  Builder build(kernel);
  const std::vector<NodeId> c = inputs(build, 0, 3 * kCount, "c");
  Zh3 zh3(build, direction_inputs(build, 3 * kCount));
  const std::array<NodeId, 3> weights{build.constant(ratio(2126, 10000), "red"),
                                      build.constant(ratio(7152, 10000), "green"),
                                      build.constant(ratio(722, 10000), "blue")};
  std::array<NodeId, 3> axis{};  // in the order y, z, x, like band 1
  for (std::size_t i = 0; i < axis.size(); ++i) axis[i] = zh3.dot(weights, {c[1 + i], c[5 + i], c[9 + i]});
  const NodeId square = zh3.dot(axis, axis);
  const NodeId positive = zh3.divisor(square);
  const NodeId scale = build.div(build.sqrt(positive), positive);
  for (NodeId& component : axis) component = build.mul(component, scale);
  const NodeId cosine = zh3.towards_normal(axis);
  // Without an axis all sizes are 0.
  const NodeId shape = zh3.parabola(cosine, build.constant(ratio(1, 1)));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::array<NodeId, 3> c1{c[kCount * channel + 1], c[kCount * channel + 2], c[kCount * channel + 3]};
    const NodeId along = zh3.dot(c1, axis);
    const NodeId size =
        build.select(along, zh3.zero(), build.neg(along), along, numbered("size", static_cast<int>(channel)));
    const NodeId mean = zh3.mean(c[kCount * channel], size, numbered("mean", static_cast<int>(channel)));
    const NodeId quotient = build.div(build.mul(size, zh3.fit(mean, size)), zh3.divisor(mean));
    const NodeId linear = zh3.linear(c[kCount * channel], zh3.towards_normal(c1));
    kernel.outputs.push_back({build.add(linear, build.mul(quotient, shape)), channel == 0   ? "red"
                                                                             : channel == 1 ? "green"
                                                                                            : "blue"});
  }
  return kernel;
}

}  // namespace sh::codegen::recipes
