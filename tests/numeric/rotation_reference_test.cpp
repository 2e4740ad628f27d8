// Reference values of rotations against the recursion of the oracle, for every way to write a rotation; exact zeros;
// what happens near the identity; refusals.
#include "numeric/reference/rotation_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/oracle/real.hpp"
#include "numeric/oracle/rotation.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

std::vector<std::string> all_entries(int degree, const GivenRotation& rotation, int digits) {
  return RotationReference(degree, rotation).all(digits, [] {});
}

// The rotation matrix of a unit quaternion.
std::array<Mpfr100, 9> matrix_of(const GivenRotation& rotation) {
  const PrecisionScope scope(110);
  std::array<Mpfr100, 4> q;
  const auto given = rotation.quaternion();
  std::transform(given.begin(), given.end(), q.begin(), [](const MpfrAny& c) { return Mpfr100(c); });
  const auto& [w, x, y, z] = q;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

const std::array<std::string, 9> kTwoThirds{"0", "0", "1", "1", "0",
                                            "0", "0", "1", "0"};  // 120 degrees about (1, 1, 1)

TEST(RotationReference, IsTheRecursionOfTheOracleHoweverTheRotationIsWritten) {
  const std::vector<GivenRotation> rotations{
      rotation_from_quaternion("q", {"0.3", "-0.5", "0.2", "0.9"}),
      rotation_from_matrix("m", {"0.6", "-0.8", "0", "0.8", "0.6", "0", "0", "0", "1"}),
      rotation_from_matrix("m", {"0.36", "0.48", "-0.8", "-0.8", "0.6", "0", "0.48", "0.64", "0.6"}),
      rotation_from_matrix("m", {"0.3601", "0.48", "-0.8", "-0.8", "0.6", "0", "0.48", "0.64", "0.6"}),
      rotation_from_euler("e", {"0.4", "1.1", "-2.5"}),
      rotation_from_axis("v", {"1", "2", "-2"}, "a", "3.1"),
      rotation_from_matrix("m", kTwoThirds)};
  for (const auto& rotation : rotations) {
    const auto r = matrix_of(rotation);
    const auto bands = rotation_bands(8, r.data());
    for (int l = 0; l <= 8; ++l) {
      const auto entries = all_entries(l, rotation, 60);
      const auto& band = bands[l];
      ASSERT_EQ(entries.size(), band.size());
      for (std::size_t i = 0; i < band.size(); ++i) {
        EXPECT_LT(abs(Mpfr100(Mpfr100(entries[i]) - band[i])), 1e-59) << l << " " << i;
      }
    }
  }
}

TEST(RotationReference, GivesTheSameMatrixForTheSameRotation) {
  const auto from_matrix = all_entries(3, rotation_from_matrix("m", kTwoThirds), 30);
  EXPECT_EQ(from_matrix, all_entries(3, rotation_from_quaternion("q", {"1", "1", "1", "1"}), 30));
  EXPECT_EQ(from_matrix, all_entries(3, rotation_from_quaternion("q", {"-1e9", "-1e9", "-1e9", "-1e9"}), 30));
  // Rz(a) Ry(0) Rz(c) is a turn by a + c about z.
  EXPECT_EQ(all_entries(2, rotation_from_euler("e", {"0.25", "0", "0.5"}), 30),
            all_entries(2, rotation_from_axis("v", {"0", "0", "2"}, "a", "0.75"), 30));
}

TEST(RotationReference, KnowsExactZerosAndOnes) {
  for (const auto& entry : all_entries(4, rotation_from_axis("v", {"1", "2", "3"}, "a", "0"), 9)) {
    EXPECT_TRUE(entry == "0" || entry == "1.00000000e+00") << entry;
  }
  // A quarter turn about x: D_2 has (y, z) -> (z, -y), so that xy -> xz.
  RotationReference quarter(2, rotation_from_matrix("m", {"1", "0", "0", "0", "0", "-1", "0", "1", "0"}));
  EXPECT_EQ(quarter.entry(1, -2, 9), "1.00000000e+00");
  EXPECT_EQ(quarter.entry(-2, -2, 9), "0");
  EXPECT_EQ(quarter.entry(0, 0, 9), "-5.00000000e-01");
  EXPECT_EQ(quarter.entry(2, 0, 9), "-8.66025404e-01");
}

TEST(RotationReference, NearTheIdentityKeepsTheDigitsOfSmallEntries) {
  // By t about y: D_4 from order 4 to 0 is sqrt(35) / 8 sin(t)^4 with the real basis' root 2 in it.
  RotationReference small(4, rotation_from_axis("v", {"0", "1", "0"}, "a", "1e-30"));
  EXPECT_EQ(small.entry(4, 0, 20), "7.3950997288745200532e-121");
  EXPECT_EQ(small.entry(4, -4, 20), "0");
  EXPECT_EQ(small.entry(4, 4, 20), "1.0000000000000000000e+00");
}

TEST(RotationReference, MoreDigitsBeginWithFewer) {
  RotationReference reference(40, rotation_from_quaternion("q", {"1", "2", "3", "4.5"}));
  const auto many = reference.entry(17, -23, 600);
  EXPECT_EQ(reference.entry(17, -23, 61).substr(0, 60), many.substr(0, 60));
}

TEST(RotationReference, TakesTheNearestRotationAndSaysHowFarItWas) {
  const auto exact = rotation_from_matrix("m", {"0.6", "-0.8", "0", "0.8", "0.6", "0", "0", "0", "1"});
  EXPECT_EQ(exact.distance, 0);
  // A length of 1.0001 in the plane: each of the four entries is off by 1e-4 of itself.
  const auto longer = rotation_from_matrix("m", {"0.60006", "-0.80008", "0", "0.80008", "0.60006", "0", "0", "0", "1"});
  EXPECT_NEAR(longer.distance, 1e-4 * std::sqrt(2.0), 1e-15);
  EXPECT_EQ(all_entries(3, longer, 40), all_entries(3, exact, 40));
}

TEST(RotationReference, RefusesWhatIsNoRotation) {
  const auto matrix = [](const char* first, const char* last) {
    return message_of([&] { rotation_from_matrix("m", {first, "0", "0", "0", "1", "0", "0", "0", last}); });
  };
  EXPECT_EQ(matrix("1", "-1"), "m: expected a rotation, determinant 1, got a reflection, -1");
  EXPECT_EQ(matrix("1.01", "1"), "m: expected a rotation, |R R^T - 1| at most 0.002, got 0.02");
  EXPECT_EQ(matrix("1", "1e9999"), "m: expected a rotation, |R R^T - 1| at most 0.002, got inf");
  const std::array<std::string, 4> no_turn = {"0", "0.0", "-0", "0e5"};
  const auto axis = [](const char* z, const char* by) {
    return message_of([&] { rotation_from_axis("v", {"0", "0", z}, "a", by); });
  };
  EXPECT_EQ(message_of([&] { rotation_from_quaternion("q", no_turn); }),
            "q: expected a number that is not zero, got zeros only");
  EXPECT_EQ(axis("0", "1"), "v: expected a number that is not zero, got zeros only");
  EXPECT_EQ(axis("1", "one"), "a: expected a decimal number such as -0.5 or 1e-3, got 'one'");
  const auto turn = rotation_from_euler("e", {"1", "2", "3"});
  EXPECT_EQ(message_of([&] { RotationReference(1001, turn); }), "degree: expected 0 to 1000, got 1001");
  EXPECT_EQ(message_of([&] { RotationReference(2, turn).entry(3, 0, 9); }), "row: expected -2 to 2, got 3");
  EXPECT_EQ(message_of([&] { RotationReference(2, turn).entry(0, -3, 9); }), "column: expected -2 to 2, got -3");
  EXPECT_EQ(message_of([&] { RotationReference(2, turn).entry(0, 0, 0); }), "digits: expected 1 to 10000, got 0");
}

}  // namespace
}  // namespace sh::numeric
