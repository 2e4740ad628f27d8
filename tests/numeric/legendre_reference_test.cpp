// Reference values of Legendre functions and caps: closed forms, other algorithms of the oracle, exact zeros, refusals.
#include <gtest/gtest.h>

#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/oracle/zonal.hpp"
#include "numeric/reference/reference.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

Colatitude cosine(const std::string& text) { return {Colatitude::Kind::kCosine, "--z", text}; }
Colatitude angle(const std::string& text) { return {Colatitude::Kind::kAngle, "--theta", text}; }
Colatitude depth(const std::string& text) { return {Colatitude::Kind::kOneMinusCos, "--one-minus-cos", text}; }

TEST(LegendreReference, PrintsTheDigitsOfClosedForms) {
  // P_11 = sqrt(3 / 8 pi) sin theta, P_20 = sqrt(5 / 16 pi) (3 z^2 - 1).
  EXPECT_EQ(legendre_reference(1, 1, cosine("0.6"), 20), "2.7639531957706838341e-01");
  EXPECT_EQ(legendre_reference(2, 0, cosine("-1"), 20), "6.3078313050504001206e-01");
  EXPECT_EQ(legendre_reference(2, 0, depth("0.5"), 20), "-7.8847891313130001508e-02");
}

TEST(LegendreReference, AgreesWithItselfWhicheverWayThePointIsGiven) {
  const std::string many = legendre_reference(60, 17, cosine("0.375"), 200);
  EXPECT_EQ(legendre_reference(60, 17, depth("0.625"), 200), many);
  EXPECT_EQ(legendre_reference(60, 17, cosine("0.375"), 30).substr(0, 30), many.substr(0, 30));
  const auto value = legendre_value(60, 17, Mpfr100(0.375), Mpfr100(sqrt(Mpfr100(1 - Mpfr100(0.140625)))));
  EXPECT_EQ(value.str(90, std::ios::scientific).substr(0, 88), many.substr(0, 88));
}

TEST(LegendreReference, KnowsExactZeros) {
  EXPECT_EQ(legendre_reference(3, 0, cosine("0"), 9), "0");
  EXPECT_EQ(legendre_reference(3, 1, cosine("-1.0"), 9), "0");
  EXPECT_EQ(legendre_reference(3, 2, angle("0"), 9), "0");
  EXPECT_EQ(legendre_reference(3, 2, depth("2"), 9), "0");
  // Not zero, but small: beside the pole, and beside the root 5 z^2 = 1.
  EXPECT_EQ(legendre_reference(4, 2, depth("1e-9"), 20), "4.0142792499699437766e-09");
  EXPECT_EQ(legendre_reference(3, 1, cosine("0.447213595499957939281834733746255247088"), 15), "-1.59873258481311e-40");
}

TEST(LegendreReference, ReachesFarBelowTheUsualExponents) {
  EXPECT_EQ(legendre_reference(10000, 10000, angle("1e-100000"), 9), "2.99661356e-1000000000");
}

TEST(CapReference, IsTheRecurrenceOfTheOracle) {
  for (const std::string u : {"0.5", "0.0009765625", "1.75", "1"}) {
    std::vector<Mpfr100> values(41);
    cap_zonal(40, Mpfr100(u), values.data());
    for (const int l : {0, 1, 3, 39, 40}) {
      const auto& value = values[l];
      const std::string wanted = value == 0 ? "0" : Mpfr50(value).str(39, std::ios::scientific);
      EXPECT_EQ(cap_reference(l, depth(u), 40), wanted) << u << " " << l;
    }
  }
}

TEST(CapReference, KnowsTheEdgesOfItsDomain) {
  EXPECT_EQ(cap_reference(5, angle("0"), 9), "0");
  EXPECT_EQ(cap_reference(0, depth("0"), 9), "0");
  EXPECT_EQ(cap_reference(5, depth("2.0"), 9), "0");
  EXPECT_EQ(cap_reference(0, depth("2"), 9), "3.54490770e+00");
  EXPECT_EQ(cap_reference(4, depth("1"), 9), "0");
  // sqrt(7 pi) u (1 - 3 u), u = 5e-17.
  EXPECT_EQ(cap_reference(3, angle("1e-8"), 9), "2.34473605e-16");
}

TEST(LegendreReference, RefusesBadInputInOneLine) {
  const auto legendre = [](int order, const Colatitude& at) {
    return message_of([&] { legendre_reference(3, order, at, 9); });
  };
  const auto cap = [](int degree, const Colatitude& at, int digits) {
    return message_of([&] { cap_reference(degree, at, digits); });
  };
  EXPECT_EQ(legendre(1, cosine("1.5")), "--z: expected -1 to 1, got 1.5");
  EXPECT_EQ(legendre(1, angle("-1")), "--theta: expected 0 to pi, got -1");
  EXPECT_EQ(legendre(1, angle("3.1416")), "--theta: expected 0 to pi, got 3.1416");
  EXPECT_EQ(legendre(-1, cosine("0")), "order: expected 0 to 3, got -1");
  EXPECT_EQ(legendre(1, cosine("x")), "--z: expected a decimal number such as -0.5 or 1e-3, got 'x'");
  EXPECT_EQ(cap(3, depth("2.1"), 9), "--one-minus-cos: expected 0 to 2, got 2.1");
  EXPECT_EQ(cap(3, depth("1"), 10001), "digits: expected 1 to 10000, got 10001");
  EXPECT_EQ(cap(-3, depth("1"), 1), "degree: expected 0 to 10000, got -3");
}

}  // namespace
}  // namespace sh::numeric
