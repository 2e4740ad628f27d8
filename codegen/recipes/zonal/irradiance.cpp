// Recipes: irradiance from radiance coefficients, E(n) = sum A_l c_lm Y_lm(n) [RamamoorthiHanrahan01b], its 4x4
// quadratic form, its value E(n), and its lightmap form of degree 1.
#include <array>

#include "codegen/recipes/zonal/columns.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::irradiance_factor;
using symbolic::Surd;

constexpr const char* kCitation =
    "R. Ramamoorthi, P. Hanrahan, \"On the relationship between radiance and irradiance\", JOSA A 18, 2001; constants "
    "derived exactly";
constexpr const char* kEfficient =
    "R. Ramamoorthi, P. Hanrahan, \"An Efficient Representation for Irradiance Environment Maps\", SIGGRAPH 2001; "
    "constants derived exactly";
constexpr const char* kLightmap =
    "Y. O'Donnell, \"Precomputed Global Illumination in Frostbite\", GDC 2018; constants derived exactly";
constexpr const char* kOrder = "index l(l+1)+m, orthonormal, no Condon-Shortley phase";

std::vector<NodeId> coefficients(Builder& build, int degree) {
  return inputs(build, 0, coefficient_count(degree), "c");
}

// A_l times the constant of Y_lm, |m|.
Surd irradiance_constant(int l, int m) { return irradiance_factor(l) * whole_axial_form(l, m).scale; }

// The same times the coefficient of z^n in d^m P_l / dz^m; n = 2 power, or 2 power + 1 for odd l - m.
Surd irradiance_coefficient(int l, int m, int power) {
  return irradiance_constant(l, m) * Surd(whole_axial_form(l, m).powers[power]);
}

Kernel described_evaluate(int degree) {
  Kernel kernel;
  kernel.title = "Irradiance towards a normal from radiance coefficients of " + degrees_to(degree);
  kernel.citation = degree == 2 || degree == 3 ? kEfficient : kCitation;
  kernel.domain = "|n| = 1 for the normal n = (x, y, z); c (radiance): " + std::string(kOrder);
  kernel.result = "E(n) = sum A_l c_lm Y_lm(n), A_0 = pi; diffuse exit radiance is albedo/pi E";
  kernel.parameters = with_direction({array(Role::kCoefficients, "c", degree)});
  kernel.results = {parameter(Role::kValue, "irradiance")};
  kernel.outputs = {{-1, "E(n)"}};
  return kernel;
}

// The sum over l of A_l k_lm q_lm(z) c_lm for one sign of m.
Value column(SignedBuilder& build, AxialPolynomials& axial, NodeId z, const std::vector<NodeId>& c, int degree, int m,
             int sign) {
  Value even;
  Value odd;
  for (int l = m; l <= degree; ++l) {
    if (irradiance_factor(l).is_zero()) continue;
    Value& part = (l - m) % 2 == 0 ? even : odd;
    part = build.plus(part, {build.mul(axial.at(l, m), c[coefficient_index(l, sign * m)])});
  }
  return odd.is_zero() ? even : build.plus(even, {build.mul(z, odd.node)});
}

}  // namespace

Kernel irradiance(int degree) {
  Kernel kernel;
  kernel.title = "Convolve radiance coefficients of " + degrees_to(degree) + " with the clamped cosine";
  kernel.citation = kCitation;
  kernel.domain = "any coefficients; " + std::string(kOrder);
  kernel.result =
      "irradiance A_l c_lm, in place: A_0 = pi, A_1 = 2 pi/3, A_2 = pi/4, A_4 = -pi/24; exactly zero at odd l > 1";
  kernel.parameters = {array(Role::kCoefficients, "c", degree)};
  kernel.results = {array(Role::kIrradiance, "c", degree)};
  label_coefficients(kernel, degree);
  Builder build(kernel);
  const std::vector<NodeId> c = coefficients(build, degree);
  for (int l = 0; l <= degree; ++l) {
    const Surd factor = irradiance_factor(l);
    const NodeId a = build.constant(factor, factor.is_zero() ? "none" : numbered("a", l));
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      kernel.outputs[i].node = factor.is_zero() ? a : build.mul(a, c[i]);
    }
  }
  return kernel;
}

Kernel irradiance_matrix(int degree) {
  Kernel kernel;
  kernel.title = "Irradiance as a quadratic form of the normal, from radiance coefficients of " + degrees_to(degree);
  kernel.citation = kEfficient;
  kernel.domain = "any coefficients c (radiance); " + std::string(kOrder);
  kernel.result = "the symmetric 4x4 matrix M, row by row, with E(n) = (x, y, z, 1) M (x, y, z, 1)^T for |n| = 1";
  kernel.parameters = {array(Role::kCoefficients, "c", degree)};
  kernel.results = {parameter(Role::kQuadraticForm, "m")};
  Builder build(kernel);
  const std::vector<NodeId> c = coefficients(build, degree);
  const auto half = Surd(cln::cl_RA(1) / 2);
  // A product such as x y has two places in M; 3 z^2 - 1 and x^2 - y^2 lie on its diagonal.
  const NodeId c1 = build.constant(irradiance_coefficient(2, 1, 0) * half, "c1");
  const NodeId c2 = build.constant(irradiance_coefficient(1, 1, 0) * half, "c2");
  const NodeId c3 = build.constant(irradiance_coefficient(2, 0, 1), "c3");
  const NodeId c4 = build.constant(irradiance_coefficient(0, 0, 0), "c4");
  const NodeId c5 = build.constant(-irradiance_coefficient(2, 0, 0), "c5");
  const NodeId xx = build.mul(c1, c[8], "xx");
  const NodeId xy = build.mul(c1, c[4], "xy");
  const NodeId xz = build.mul(c1, c[7], "xz");
  const NodeId yz = build.mul(c1, c[5], "yz");
  const NodeId yy = build.neg(xx, "yy");
  const NodeId zz = build.mul(c3, c[6], "zz");
  const NodeId x = build.mul(c2, c[3], "x");
  const NodeId y = build.mul(c2, c[1], "y");
  const NodeId z = build.mul(c2, c[2], "z");
  const NodeId mean = build.mul(c4, c[0]);
  const NodeId one = build.sub(mean, build.mul(c5, c[6]), "one");
  const std::array<NodeId, 16> entries{xx, xy, xz, x, xy, yy, yz, y, xz, yz, zz, z, x, y, z, one};
  const std::array<const char*, 4> axes{"x", "y", "z", "1"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    kernel.outputs.push_back({entries[i], std::string(axes[i / 4]) + " " + axes[i % 4]});
  }
  return kernel;
}

Kernel irradiance_evaluate(int degree) {
  Kernel kernel = described_evaluate(degree);
  SignedBuilder build(kernel);
  const std::vector<NodeId> c = coefficients(build, degree);
  const Direction n = direction_inputs(build, coefficient_count(degree));
  Azimuth azimuth(build, n);
  AxialPolynomials axial(build, n.z, Wanted::kFew, irradiance_constant);
  NodeId total = column(build, axial, n.z, c, degree, 0, 1).node;
  for (int m = 1; m <= degree; ++m) {
    const Value cosine = column(build, axial, n.z, c, degree, m, 1);
    if (cosine.is_zero()) continue;
    const Value sine = column(build, axial, n.z, c, degree, m, -1);
    const auto [real, imaginary] = azimuth.power(m);
    total = build.add(total, build.mul(real, cosine.node));
    total = build.add(total, build.mul(imaginary, sine.node));
  }
  kernel.outputs[0].node = total;
  return kernel;
}

Kernel irradiance_evaluate_nested(int degree) {
  Kernel kernel = described_evaluate(degree);
  Builder build(kernel);
  const std::vector<NodeId> c = coefficients(build, degree);
  const auto [x, y, z] = direction_inputs(build, coefficient_count(degree));
  // The constant of x y, y z and x z, which divides the sum; x^2 - y^2 has half of it.
  const Surd scale = irradiance_coefficient(2, 1, 0);
  const NodeId k = build.constant(scale, "k");
  const NodeId linear = build.constant(irradiance_coefficient(1, 1, 0) / scale, "k_linear");
  const NodeId half = build.constant(Surd(cln::cl_RA(1) / 2), "k_half");
  const NodeId square = build.constant(irradiance_coefficient(2, 0, 1) / scale, "k_square");
  const NodeId least = build.constant(-irradiance_coefficient(2, 0, 0) / scale, "k_least");
  const NodeId mean = build.constant(irradiance_coefficient(0, 0, 0) / scale, "k_mean");
  const auto times = [&](NodeId a, NodeId b) { return build.mul(a, b); };
  const NodeId h = times(half, c[8]);
  // x (linear c3 + c4 y + c7 z + h x) + y (linear c1 + c5 z - h y) + z (linear c2 + square c6 z) + mean c0 - least c6
  NodeId of_x = times(linear, c[3]);
  of_x = build.add(of_x, times(c[4], y));
  of_x = build.add(of_x, times(c[7], z));
  of_x = build.add(of_x, times(h, x));
  NodeId of_y = times(linear, c[1]);
  of_y = build.add(of_y, times(c[5], z));
  of_y = build.sub(of_y, times(h, y));
  NodeId of_z = times(square, c[6]);
  of_z = times(of_z, z);
  of_z = build.add(of_z, times(linear, c[2]));
  NodeId total = times(mean, c[0]);
  total = build.sub(total, times(least, c[6]));
  total = build.add(total, times(of_z, z));
  total = build.add(total, times(of_y, y));
  total = build.add(total, times(of_x, x));
  kernel.outputs[0].node = build.mul(k, total);
  return kernel;
}

namespace {

constexpr const char* kForm = "(e_0, e_1, e_2, e_3) with irradiance E(n) = e_0 + e_1 y + e_2 z + e_3 x";

void label_lightmap(Kernel& kernel) {
  for (const char* label : {"1", "y", "z", "x"}) kernel.outputs.push_back({-1, label});
}

}  // namespace

Kernel lightmap(int degree) {
  Kernel kernel;
  kernel.title = "Radiance coefficients of " + degrees_to(degree) + " as irradiance that a dot product evaluates";
  kernel.citation = kLightmap;
  kernel.domain = "any coefficients c (radiance); " + std::string(kOrder);
  kernel.result = std::string(kForm) + "; may be c itself";
  kernel.parameters = {array(Role::kCoefficients, "c", degree)};
  kernel.results = {parameter(Role::kLinearForm, "out")};
  label_lightmap(kernel);
  Builder build(kernel);
  const std::vector<NodeId> c = coefficients(build, degree);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const int l = i == 0 ? 0 : 1;
    const NodeId k = build.constant(irradiance_constant(l, 0), numbered("k", l));
    kernel.outputs[i].node = build.mul(k, c[i]);
  }
  return kernel;
}

Kernel lightmap_project(int /*degree*/) {
  Kernel kernel;
  kernel.title = "Add a radiance sample to irradiance of degree 1 that a dot product evaluates";
  kernel.citation = kLightmap;
  kernel.domain = "|d| = 1 for d = (x, y, z), towards the light; weight: radiance times solid angle of the sample";
  kernel.result = std::string(kForm) + ", the sample added";
  const Parameter sum = parameter(Role::kLinearForm, "sum");
  kernel.parameters = with_direction({}, {parameter(Role::kWeight, "weight"), sum});
  kernel.results = {sum};
  label_lightmap(kernel);
  Builder build(kernel);
  std::array<NodeId, 8> input{};
  for (int i = 0; i < 8; ++i) input[i] = build.input(i, "");
  // A_l times the square of the constant of Y_lm.
  const auto factor = [](int l) { return irradiance_constant(l, 0) * whole_axial_form(l, 0).scale; };
  const NodeId mean = build.mul(build.constant(factor(0), "k0"), input[3]);
  const NodeId linear = build.mul(build.constant(factor(1), "k1"), input[3]);
  kernel.outputs[0].node = build.add(input[4], mean);
  constexpr int kAxes[] = {1, 2, 0};  // y, z, x
  for (int i = 0; i < 3; ++i) {
    const NodeId added = build.mul(linear, input[kAxes[i]]);
    kernel.outputs[i + 1].node = build.add(input[i + 5], added);
  }
  return kernel;
}

Kernel lightmap_evaluate(int degree) {
  Kernel kernel;
  kernel.title = "Irradiance towards a normal from its lightmap form of " + degrees_to(degree);
  kernel.citation = kLightmap;
  kernel.domain = "|n| = 1 for the normal n = (x, y, z); e: " + std::string(kForm);
  kernel.result = "E(n); diffuse exit radiance is albedo/pi E";
  kernel.parameters = with_direction({parameter(Role::kLinearForm, "e")});
  kernel.results = {parameter(Role::kValue, "irradiance")};
  Builder build(kernel);
  const std::vector<NodeId> e = coefficients(build, degree);
  const auto [x, y, z] = direction_inputs(build, coefficient_count(degree));
  NodeId total = build.add(e[0], build.mul(e[1], y));
  total = build.add(total, build.mul(e[2], z));
  total = build.add(total, build.mul(e[3], x));
  kernel.outputs = {{total, "E(n)"}};
  return kernel;
}

}  // namespace sh::codegen::recipes
