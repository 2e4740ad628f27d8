// Reference values: correct to the last digit asked for, exact zeros, and refusals in one line.
#include "numeric/reference/reference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

TEST(Reference, PrintsTheDigitsOfClosedForms) {
  // sqrt(1 / 4 pi), sqrt(3 / 4 pi), and Y_22 = sqrt(15 / 16 pi) (x^2 - y^2) at (0.6, 0, 0.8).
  EXPECT_EQ(reference_value(0, 0, {"1", "2", "3"}, 50), "2.8209479177387814347403972578038629292202531466450e-01");
  EXPECT_EQ(reference_value(1, 0, {"0", "0", "-7"}, 30), "-4.88602511902919921586384622838e-01");
  EXPECT_EQ(reference_value(2, 2, {"3", "0", "4"}, 30), "1.96658717506574232697809427044e-01");
  EXPECT_EQ(reference_value(0, 0, {"0", "0", "1"}, 1), "3e-01");
}

TEST(Reference, MoreDigitsBeginWithFewerDigits) {
  const std::string many = reference_value(20, -13, {"0.1", "-0.25", "1e-2"}, 1000);
  EXPECT_EQ(many.size(), 1000 + std::string(".e-02").size());
  for (const int digits : {20, 100, 500}) {
    const std::string few = reference_value(20, -13, {"0.1", "-0.25", "1e-2"}, digits + 1);
    EXPECT_EQ(few.substr(0, digits), many.substr(0, digits));
  }
}

TEST(Reference, DoesNotDependOnTheLengthOfTheDirection) {
  const auto value = reference_value(7, 3, {"1", "-2", "3"}, 60);
  EXPECT_EQ(reference_value(7, 3, {"1e5000", "-2e5000", "0.3E+5001"}, 60), value);
  EXPECT_EQ(reference_value(7, 3, {".01", "-0.02", "+3.e-2"}, 60), value);
}

TEST(Reference, KnowsExactZerosFromValuesThatAreOnlySmall) {
  EXPECT_EQ(reference_value(2, 0, {"1", "1", "1"}, 50), "0");   // z^2 = 1/3
  EXPECT_EQ(reference_value(4, -4, {"1", "1", "9"}, 20), "0");  // sin 4 phi at 45 degrees
  EXPECT_EQ(reference_value(9, 4, {"0", "0", "1"}, 20), "0");
  EXPECT_EQ(reference_value(5, 2, {"1", "3", "0"}, 20), "0");
  // 3 z^2 - 1 = 4/3 1e-80 beside the zero: every digit of z above the last one cancels.
  EXPECT_EQ(reference_value(2, 0, {"1", "1", "1." + std::string(73, '0') + "1"}, 20), "4.2052208700336000804e-75");
  const std::string beside = "1." + std::string(79, '0') + "1";
  EXPECT_EQ(reference_value(2, 0, {"1", "1", beside}, 12), "4.20522087003e-81");
}

TEST(Reference, HoldsFarUpAndBelowTheRangeOfDouble) {
  EXPECT_EQ(reference_value(10000, 0, {"0", "0", "1"}, 20), "3.9895225383377636777e+01");
  const std::string tiny = reference_value(10000, 5000, {"0.1", "0.2", "3"}, 20);
  EXPECT_EQ(tiny, "4.2673336498669470896e-3581");
}

TEST(Reference, PrintsTheDigitsOfGradientsInClosedForm) {
  using Text = std::array<std::string, 3>;
  EXPECT_EQ(reference_gradient(0, 0, {"1", "2", "3"}, 9), (Text{"0", "0", "0"}));
  // sqrt(3 / 4 pi), and sqrt(15 / 16 pi) (2 x, -2 y, 0) at (0.6, 0, 0.8).
  EXPECT_EQ(reference_gradient(1, 0, {"1", "2", "3"}, 30), (Text{"0", "0", "4.88602511902919921586384622838e-01"}));
  EXPECT_EQ(reference_gradient(2, 2, {"3", "0", "4"}, 25), (Text{"6.555290583552474423260314e-01", "0", "0"}));
  EXPECT_EQ(reference_gradient(7, 3, {"1", "-2", "3"}, 40), reference_gradient(7, 3, {"1e9", "-2e9", "3e9"}, 40));
}

// Zeros are found modulo primes from polynomials with whole coefficients, values from the normalized recurrence.
TEST(Reference, FindsExactlyTheZerosOfGradients) {
  for (const std::array<std::string, 3>& d : std::vector<std::array<std::string, 3>>{
           {"0", "0", "1"}, {"1", "1", "1"}, {"3", "0", "4"}, {"0", "1", "0"}, {"1", "-1", "0"}, {"-2", "1", "2"}}) {
    const auto [x, y, z] = normalized(Mpfr100(d[0]), Mpfr100(d[1]), Mpfr100(d[2]));
    for (int i = 0; i < 49; ++i) {
      const auto l = static_cast<int>(std::sqrt(i));
      const int m = i - l * (l + 1);
      const auto texts = reference_gradient(l, m, d, 20);
      const auto values = basis_value_gradient(l, m, x, y, z);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Mpfr100 error = values[axis] - Mpfr100(texts[axis]);
        EXPECT_LE(static_cast<double>(abs(error)), 1e-19 * static_cast<double>(abs(values[axis])) + 1e-95) << l << m;
        EXPECT_EQ(texts[axis] == "0", static_cast<double>(abs(values[axis])) < 1e-95) << l << m << axis;
      }
    }
  }
}

TEST(Reference, ItsGradientHoldsFarUpAndBelowTheRangeOfDouble) {
  // d/dz Y_(l,m) at the pole: P_l'(1) = l(l+1)/2 on the sphere, l P_l(1) for the homogeneous form.
  EXPECT_EQ(reference_gradient(10000, 0, {"0", "0", "1"}, 20)[2], "3.9895225383377636777e+05");
  const auto text = reference_gradient(3000, -1500, {"0.1", "0.2", "3"}, 30);
  const auto [x, y, z] = normalized(Mpfr50("0.1"), Mpfr50("0.2"), Mpfr50(3));
  const Mpfr50 along = x * Mpfr50(text[0]) + y * Mpfr50(text[1]) + z * Mpfr50(text[2]);
  const Mpfr50 value(reference_value(3000, -1500, {"0.1", "0.2", "3"}, 30));
  EXPECT_LT(static_cast<double>(value), 1e-300);
  EXPECT_LT(static_cast<double>(Mpfr50(abs(along / (3000 * value) - 1))), 1e-26);  // Euler
}

TEST(Reference, RefusesBadInputInOneLine) {
  const auto refusal = [](int degree, int order, const std::array<std::string, 3>& direction, int digits) {
    return message_of([&] { reference_value(degree, order, direction, digits); });
  };
  EXPECT_EQ(refusal(2, 3, {"0", "0", "1"}, 5), "order: expected -2 to 2, got 3");
  EXPECT_EQ(refusal(-1, 0, {"0", "0", "1"}, 5), "degree: expected 0 to 10000, got -1");
  EXPECT_EQ(refusal(10001, 0, {"0", "0", "1"}, 5), "degree: expected 0 to 10000, got 10001");
  EXPECT_EQ(refusal(1, 0, {"0", "0", "1"}, 0), "digits: expected 1 to 10000, got 0");
  EXPECT_EQ(refusal(1, 0, {"0", "-0.0", "0e9"}, 5), "direction: expected a vector that is not zero, got zeros");
  for (const std::string bad : {"nan", "inf", "", ".", "-", "1e", "0x1", "1 ", "1..2", "--1", "+-1", "1e+-2"}) {
    EXPECT_EQ(refusal(1, 0, {"1", bad, "1"}, 5),
              "direction y: expected a decimal number such as -0.5 or 1e-3, got '" + bad + "'");
  }
  for (const std::string far : {"1e200000", "1e-99999999999999999999"}) {
    EXPECT_EQ(refusal(1, 0, {"1", far, "1"}, 5),
              "direction y: expected an exponent within +-100000, got '" + far + "'");
  }
}

}  // namespace
}  // namespace sh::numeric
