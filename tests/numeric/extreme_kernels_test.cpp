// Generated kernels at the edges of their domains, degree 0 to 10, in float and double: poles, subnormal components,
// rotations next to the identity, to half turns and without tilt or upside down, caps from 1e-300 to the sphere. Each
// keeps the limits that hold anywhere else.
#include "tests/numeric/extreme_kernels.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/kernels/inputs.hpp"
#include "numeric/kernels/kernel_check.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/sampling/directions.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

using test::report_kernels;

const std::vector<std::string> kOfADirection = {"basis",   "basis_gradient", "basis_normalised",   "evaluate",
                                                "project", "zonal",          "irradiance_evaluate"};

TEST(ExtremeKernels, AtThePolesAndBesideThem) {
  std::vector<NamedInput> poles;
  for (const double z : {1.0, -1.0}) poles.push_back({"pole", {0, 0, z}});
  for (const auto& d : near_pole_directions()) poles.push_back({"beside a pole", {d.x, d.y, d.z}});
  report_kernels("poles, 1e-300..0.1 from them", kOfADirection, "x", poles);
}

TEST(ExtremeKernels, AtSubnormalComponents) {
  std::vector<NamedInput> inputs;
  for (const double tiny : {4.9406564584124654e-324, 1e-320, 2.2e-308, 1.5e-45, 1e-40, 1.1e-38}) {
    for (const auto& [a, b] : {std::pair{1.0, 0.0}, {0.6, -0.8}, {-std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2}}) {
      for (const double small : {tiny, -tiny}) {
        inputs.push_back({"subnormal x", {small, a, b}});
        inputs.push_back({"subnormal y", {b, small, a}});
        inputs.push_back({"subnormal z", {a, b, small}});
      }
    }
    inputs.push_back({"two subnormal", {tiny, -tiny, 1}});
    inputs.push_back({"two subnormal", {1, tiny, tiny}});
    inputs.push_back({"two subnormal", {-tiny, -1, tiny}});
  }
  report_kernels("subnormal components", kOfADirection, "x", inputs);
}

// Directions off the sphere by a factor 1 +- off.
std::vector<NamedInput> off_unit(double off) {
  std::vector<NamedInput> inputs;
  for (const auto& input : direction_inputs(100)) {
    for (const double factor : {1 - off, 1 + off}) {
      inputs.push_back({"off unit", input.values});
      for (double& value : inputs.back().values) value *= factor;
    }
  }
  return inputs;
}

template <class T>
void report_off_unit(double off, const std::string& family, double limit) {
  const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  test::Worst worst;
  for (const BoundKernel& kernel : test::kernels_of({family})) {
    const auto result = kernel_errors<T>(kernel, test::at_extremes(kernel, "x", off_unit(off)));
    worst.keep(result.total.scaled().max() * epsilon / off, "{} {} at {}", result.kernel, result.worst_total.output,
               result.worst_total.input);
  }
  const std::string scalar = sizeof(T) == sizeof(float) ? "float" : "double";
  worst.report(fmt::format("off unit by {:.3g}: {} {}, total / off", off, family, scalar), limit);
}

// The total error that a direction off unit adds, in units of its distance. A homogeneous form grows by r^l,
// l times that; a form in z alone by the slope of the Legendre polynomial at the pole, P_l'(1) = l(l+1)/2: 55 at degree
// 10. At one ulp rounding adds its part.
TEST(ExtremeKernels, OfDirectionsOffUnit) {
  constexpr double kSlope = 55;
  for (const double off : {1e-6, 1e-5, 1e-4, 1e-3}) {
    report_off_unit<float>(off, "basis", 1.05 * kSlope);
    for (const char* family : {"basis", "project", "zonal", "evaluate"}) {
      report_off_unit<double>(off, family, 1.05 * kSlope);
    }
  }
  report_off_unit<float>(0x1p-23, "basis", 2 * kSlope);
  report_off_unit<double>(0x1p-52, "basis", 2 * kSlope);
}

// Unit quaternions: turns by 0 to 1e-12 and by pi less that.
std::vector<NamedInput> tiny_turns() {
  std::vector<NamedInput> inputs;
  const auto axes = random_directions(40, 51);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    constexpr std::array kAngles = {0.0, 1e-300, 1e-40, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12};
    const double half = kAngles[i % kAngles.size()] / 2;
    const auto& [x, y, z] = axes[i];
    inputs.push_back({"almost the identity", {1, half * x, half * y, half * z}});
    inputs.push_back({"almost a half turn", {half, x, y, z}});
  }
  for (auto& input : inputs) scale_to_unit(4, input.values.data(), input.values.data());
  return inputs;
}

// Unit quaternions: beta = 0, turns about z; beta = pi, half turns about horizontal axes.
std::vector<NamedInput> upright_or_upside_down() {
  std::vector<NamedInput> inputs;
  constexpr int kAngles = 24;
  for (int i = -kAngles; i <= kAngles; ++i) {
    const double t = static_cast<double>(i) / kAngles;  // cos and sin of an angle are (1 - t^2, 2 t) / (1 + t^2)
    const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    inputs.push_back({"beta = 0", {c, 0, 0, s}});
    inputs.push_back({"beta = pi", {0, c, s, 0}});
    inputs.push_back({"beta = 0", {s, 0, 0, c}});
    inputs.push_back({"beta = pi", {0, s, c, 0}});
  }
  return inputs;
}

std::vector<NamedInput> as_matrices(std::vector<NamedInput> quaternions) {
  for (auto& input : quaternions) {
    std::vector<double> matrix(9);
    matrix_of_quaternion(input.values.data(), matrix.data());
    input.values = matrix;
  }
  return quaternions;
}

void report_rotations(const std::string& what, const std::vector<NamedInput>& quaternions) {
  report_kernels(what, {"rotate", "rotate_build", "rotate_evaluate"}, "r", as_matrices(quaternions));
  report_kernels(what, {"rotate_quaternion"}, "q", quaternions);
}

TEST(ExtremeKernels, OfRotationsWithin1em12OfTheIdentityAndOfHalfTurns) {
  report_rotations("turns by <= 1e-12, pi - that", tiny_turns());
  std::vector<NamedInput> turns;
  for (const double sine : {0.0, 1e-300, 1e-40, 1e-17, 1e-15, 1e-13, 1e-12}) {
    for (const double cosine : {1.0, -1.0}) turns.push_back({"almost none or a half", {cosine, sine}});
  }
  report_kernels("turns by <= 1e-12, pi - that", {"rotate_z"}, "cos_angle", turns);
}

TEST(ExtremeKernels, OfRotationsWithoutTiltAndUpsideDown) {
  report_rotations("beta = 0 and pi exactly", upright_or_upside_down());
}

TEST(ExtremeKernels, OfCapsFromNothingToTheSphere) {
  std::vector<NamedInput> caps = {{"hemisphere", {1}}, {"sphere", {2}}, {"nothing", {0}}};
  for (const double angle : {1e-150, 1e-14, 1e-8, 1e-4, 0.01}) {
    const double sine = std::sin(angle / 2);
    caps.push_back({"cap of a small angle", {2 * sine * sine}});
    caps.push_back({"all but a cap", {2 - 2 * sine * sine}});
  }
  for (const double off : {0x1p-53, -0x1p-53, 0x1p-24, -0x1p-24}) caps.push_back({"almost a hemisphere", {1 + off}});
  report_kernels("caps of 1e-8 rad .. sphere", {"cap", "add_cap"}, "one_minus_cos", caps);
}

}  // namespace
}  // namespace sh::numeric
