#include "codegen/ir/literal.hpp"

#include <cln/real.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

namespace sh::codegen {
namespace {

using symbolic::Surd;

cln::cl_RA power_of_two(int exponent) { return cln::expt(cln::cl_RA(2), exponent); }

TEST(Literal, RoundsTiesToEven) {
  // 1 + 2^-24 lies halfway between 1 and its next float, 1 + 3 * 2^-24 between the next two.
  EXPECT_EQ(nearest<float>(1 + power_of_two(-24)), 1.0F);
  EXPECT_EQ(nearest<float>(1 + 3 * power_of_two(-24)), 1.0F + 2 * std::ldexp(1.0F, -23));
  EXPECT_EQ(nearest<double>(1 + power_of_two(-53)), 1.0);
  EXPECT_EQ(nearest<double>(-1 - 3 * power_of_two(-53)), -1.0 - std::ldexp(1.0, -51));
}

TEST(Literal, RoundsFloatDirectlyAndNotThroughDouble) {
  // Just above a float tie: through double the tail is lost and the tie goes to even, down to 1.
  const cln::cl_RA value = 1 + power_of_two(-24) + power_of_two(-60);
  EXPECT_EQ(nearest<float>(value), std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(static_cast<float>(nearest<double>(value)), 1.0F);
}

TEST(Literal, DecidesIrrationalsNextToATie) {
  // q * pi with q the 120-digit quotient of a float tie by pi: 50 digits cannot tell on which side it lies.
  const cln::cl_RA tie = 1 + power_of_two(-24);
  const cln::cl_RA scale = cln::expt(cln::cl_RA(10), 120);
  const cln::cl_RA pi = cln::rational(cln::pi(cln::float_format(300)));
  const cln::cl_RA below = cln::floor1(tie / pi * scale) / scale;
  const cln::cl_RA above = below + 1 / scale;
  const Surd exact_pi = Surd::square_root(1, 2);
  EXPECT_EQ(nearest<float>(ExactReal(Surd(below) * exact_pi)), 1.0F);
  EXPECT_EQ(nearest<float>(ExactReal(Surd(above) * exact_pi)), std::nextafter(1.0F, 2.0F));
}

TEST(Literal, RoundsSubnormalsAndOverflow) {
  EXPECT_EQ(nearest<float>(power_of_two(-149)), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(nearest<float>(power_of_two(-150)), 0.0F);
  EXPECT_EQ(nearest<float>(3 * power_of_two(-151)), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(nearest<double>(power_of_two(-1074)), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest<float>(power_of_two(128)), std::numeric_limits<float>::infinity());
  EXPECT_EQ(nearest<float>(-power_of_two(128) + power_of_two(103)), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(nearest<float>(power_of_two(128) - power_of_two(104)), std::numeric_limits<float>::max());
  EXPECT_EQ(nearest<double>(-power_of_two(20000)), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest<double>(power_of_two(1024) - power_of_two(970)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest<double>(power_of_two(1024) - power_of_two(971)), std::numeric_limits<double>::max());
}

TEST(Literal, AgreesWithTheCorrectlyRoundedSquareRoot) {
  // IEEE square roots are correctly rounded, in both types.
  for (int n = 1; n <= 2000; ++n) {
    EXPECT_EQ(nearest<double>(ExactReal(Surd::square_root(n))), std::sqrt(static_cast<double>(n))) << n;
    EXPECT_EQ(nearest<float>(ExactReal(Surd::square_root(n))), std::sqrt(static_cast<float>(n))) << n;
  }
}

TEST(Literal, DoublesReadBackFromTheirDigits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtod(decimal(value).c_str(), nullptr), value) << decimal(value);
  }
}

TEST(Literal, FloatsReadBackFromTheirDigitsDirectlyAndThroughDouble) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const std::string digits = decimal(value);
    EXPECT_EQ(std::strtof(digits.c_str(), nullptr), value) << digits;
    EXPECT_EQ(static_cast<float>(std::strtod(digits.c_str(), nullptr)), value) << digits;
  }
}

// Its shortest decimal is so near the middle of two floats that the nearest double is the middle.
TEST(Literal, OfAFloatReadsBackThroughDoubleEvenNextToATie) {
  const float value = std::strtof("7.038531e-26", nullptr);
  ASSERT_NE(static_cast<float>(std::strtod("7.038531e-26", nullptr)), value);
  const std::string digits = decimal(value);
  EXPECT_EQ(static_cast<float>(std::strtod(digits.c_str(), nullptr)), value) << digits;
  EXPECT_EQ(std::strtof(digits.c_str(), nullptr), value) << digits;
}

TEST(Literal, UsesFewDigitsAndAlwaysLooksLikeAFloatingPointNumber) {
  EXPECT_EQ(decimal(0.1F), "0.1");
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(decimal(3.0), "3.0");
  EXPECT_EQ(decimal(-2.0F), "-2.0");
  EXPECT_EQ(decimal(nearest<double>(ExactReal(Surd::square_root(cln::cl_RA(1) / 4, -1)))), "0.28209479177387814");
  EXPECT_EQ(decimal(nearest<float>(ExactReal(Surd::square_root(cln::cl_RA(1) / 4, -1)))), "0.2820948");
}

}  // namespace
}  // namespace sh::codegen
