// Rotations: their errors at every tilt, and the rotation nearest to a matrix.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/measure/rotations.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::kernel_of;

TEST(RotationFamilies, SpendTheRootAndTheDivisionOnlyOnAngles) {
  for (const auto& [name, recipe] : {std::pair("rotate", "dense"), std::pair("rotate_quaternion", "polynomial"),
                                     std::pair("rotate_build", "dense"), std::pair("rotate_build", "recursive"),
                                     std::pair("rotate_z", "steps"), std::pair("rotate_evaluate", "turned")}) {
    const Cost cost = test::cost_of(name, recipe, 3);
    EXPECT_EQ(cost.div + cost.sqrt + cost.select, 0) << name << " " << recipe;
  }
}

TEST(RotationFamilies, ErrorsStayWithinTheirLimits) {
  struct Limit {
    std::string family;
    int degree;
    double in_float, in_double;  // of the fastest, absolute, for coefficients of length 1
  };
  const std::vector<Limit> limits{{"rotate", 1, 2e-7, 4e-16},
                                  {"rotate", 2, 6e-7, 1e-15},
                                  {"rotate", 3, 6e-7, 1.6e-15},
                                  {"rotate", 4, 6.8e-7, 1.6e-15},
                                  {"rotate", 5, 1e-6, 1.6e-15},
                                  {"rotate", 6, 1.2e-6, 3e-15},
                                  {"rotate", 10, 2.5e-6, 6e-15},
                                  {"rotate_quaternion", 2, 8e-7, 3e-15},
                                  {"rotate_quaternion", 4, 1e-6, 3e-15},
                                  {"rotate_quaternion", 5, 1e-6, 4e-15},
                                  {"rotate_z", 4, 4e-7, 1e-15},
                                  {"rotate_z", 10, 2e-6, 4e-15},
                                  {"rotate_build", 4, 7e-7, 2e-15},
                                  {"rotate_apply", 4, 2e-7, 4e-16},
                                  {"rotate_evaluate", 4, 5e-7, 1.5e-15}};
  for (const Limit& limit : limits) {
    const FinishedKernel fast = test::fastest(limit.family, limit.degree);
    EXPECT_LE(fast.in_float.rounding.absolute, limit.in_float) << limit.family << " " << limit.degree;
    EXPECT_LE(fast.in_double.rounding.absolute, limit.in_double) << limit.family << " " << limit.degree;
    if (nearest_point(fast.kernel.parameters).empty()) continue;
    EXPECT_LE(fast.in_float.total.absolute, limit.in_float) << limit.family << " " << limit.degree;
    EXPECT_LE(fast.in_double.total.absolute, limit.in_double) << limit.family << " " << limit.degree;
  }
}

// Rz(alpha) Ry(beta) Rz(gamma) and random coefficients of length 1, rounded to float.
std::vector<float> tilted_input(std::mt19937_64& random, double beta, std::size_t coefficients) {
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  const double alpha = angle(random);
  const double gamma = angle(random);
  const auto [ca, sa, cb, sb, cg, sg] =
      std::array{std::cos(alpha), std::sin(alpha), std::cos(beta), std::sin(beta), std::cos(gamma), std::sin(gamma)};
  std::vector<double> input{ca * cb * cg - sa * sg,
                            -ca * cb * sg - sa * cg,
                            ca * sb,  //
                            sa * cb * cg + ca * sg,
                            -sa * cb * sg + ca * cg,
                            sa * sb,  //
                            -sb * cg,
                            sb * sg,
                            cb};
  std::normal_distribution<double> normal;
  double square = 0;
  std::vector<double> c(coefficients);
  for (double& component : c) square += std::pow(component = normal(random), 2);
  for (const double component : c) input.push_back(component / std::sqrt(square));
  return {input.begin(), input.end()};
}

TEST(Rotate, ErrsByLessThanAMillionthAtEveryTiltUpToDegreeFive) {
  for (int degree = 2; degree <= 5; ++degree) {
    const Kernel kernel = kernel_of("rotate", "zxz", degree);
    Evaluator<float> in_float(kernel);
    Evaluator<double> in_double(kernel);
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> exponent(-9, std::log10(std::numbers::pi));
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const double tilt = std::pow(10, exponent(random));
      const auto input = tilted_input(random, i % 2 == 0 ? tilt : std::numbers::pi - tilt,
                                      std::size_t(degree + 1) * std::size_t(degree + 1));
      const std::vector<float> rounded = in_float(input);
      const std::vector<double> exact = in_double(std::vector<double>(input.begin(), input.end()));
      for (std::size_t k = 0; k < exact.size(); ++k) worst = std::max(worst, std::abs(double(rounded[k]) - exact[k]));
    }
    EXPECT_LE(worst, 1e-6) << degree;
    EXPECT_GT(worst, 1e-7) << "the measurement sees nothing";
  }
}

// r for beta = 0 or pi and around it: h = sin^2(beta) is zero, subnormal, below and above the threshold.
TEST(Rotate, HasNoHoleWhereEulerAnglesAreNotUnique) {
  for (const std::string recipe : {"zxz", "dense"}) {
    const Kernel kernel = kernel_of("rotate", recipe, 4);
    Evaluator<float> rotate(kernel);
    for (const float sine : {0.0F, 1e-30F, 1e-22F, 4.3e-16F, 4.5e-16F, 1e-10F}) {
      for (const float sign : {1.0F, -1.0F}) {
        // The turn by 90 degrees about z, tilted about y by almost nothing or almost 180 degrees.
        std::vector<float> input{0, -sign, sine, 1, 0, 0, 0, sine, sign};
        for (int i = 0; i < 25; ++i) input.push_back(i == 8 ? 1 : 0);  // Y_22
        const std::vector<float> out = rotate(input);
        for (std::size_t i = 0; i < out.size(); ++i)
          EXPECT_NEAR(out[i], i == 8 ? -1 : 0, 2e-7) << recipe << " " << sine;
      }
    }
  }
}

TEST(NearestRotation, LeavesRotationsAloneAndRemovesSmallErrors) {
  const auto format = cln::float_format(40);
  for (const RationalQuaternion& q : rational_rotations(5)) {
    std::vector<cln::cl_F> exact;
    std::vector<cln::cl_F> disturbed;
    for (const cln::cl_RA& entry : rotation_entries(q)) {
      exact.push_back(cln::cl_float(entry, format));
      const auto in_float = static_cast<float>(cln::double_approx(entry));
      disturbed.push_back(cln::cl_float(cln::rational(cln::cl_float(in_float)), format));
    }
    const std::vector<cln::cl_F> same = nearest_rotation(exact);
    const std::vector<cln::cl_F> near = nearest_rotation(disturbed);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_LT(std::abs(cln::double_approx(same[i] - exact[i])), 1e-38);
      EXPECT_LT(std::abs(cln::double_approx(near[i] - exact[i])), 1e-7);
    }
    // Rows of length 1.
    const cln::cl_F length = near[0] * near[0] + near[1] * near[1] + near[2] * near[2];
    EXPECT_LT(std::abs(cln::double_approx(length - 1)), 1e-38);
  }
}

}  // namespace
}  // namespace sh::codegen
