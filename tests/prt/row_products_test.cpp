// The inner loop of relighting against the plain loop, bit by bit, and the ways to relight against each other.
#include "prt/runtime/row_products.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

float plain_sum(const RowProducts& rows, std::size_t vertex, std::size_t s) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < rows.coefficients; ++i) {
    sum += rows.transfer[vertex * rows.stride + s * rows.transfer_step + i] * rows.light[s * rows.light_step + i];
  }
  return sum;
}

constexpr float kUntouched = 1234.5F;

/// Compares every instruction set, with and without color, with the plain loop; nothing is written past the end.
void expect_bits_of_the_plain_loop(const RowProducts& rows, std::size_t count) {
  const std::vector<float> color = random_values(3 * count + 1, 5);
  for (const RowProductsOn& on : row_products_here()) {
    SCOPED_TRACE(testing::Message() << on.instruction_set << ", " << count << " vertices, " << rows.coefficients
                                    << " of " << rows.stride << " values, sums " << rows.sums);
    for (const bool colored : {false, true}) {
      std::vector<float> out(3 * count + 1, kUntouched);
      on.color(rows, count, colored ? color.data() : nullptr, out.data());
      for (std::size_t v = 0; v < count; ++v) {
        for (std::size_t c = 0; c < 3; ++c) {
          const float sum = plain_sum(rows, v, rows.sums == 3 ? c : 0);
          ASSERT_EQ(out[3 * v + c], colored ? sum * color[3 * v + c] : sum) << v;
        }
      }
      EXPECT_EQ(out.back(), kUntouched);
    }
    if (rows.sums == 1) {
      std::vector<float> out(count + 1, kUntouched);
      on.gray(rows, count, out.data());
      for (std::size_t v = 0; v < count; ++v) ASSERT_EQ(out[v], plain_sum(rows, v, 0)) << v;
      EXPECT_EQ(out.back(), kUntouched);
    }
  }
}

TEST(RowProducts, HaveTheBitsOfThePlainLoopOnEveryInstructionSet) {
  constexpr std::size_t kMost = 121;
  for (const std::size_t n : {1U, 2U, 3U, 4U, 6U, 7U, 9U, 16U, 25U, 121U}) {
    const std::vector<float> light = random_values(3 * kMost, 1);
    for (const std::size_t count : {0U, 1U, 7U, 8U, 15U, 16U, 17U, 40U}) {
      const std::vector<float> values = random_values((3 * n + 2) * count + 1, 2);  // the vectors begin unaligned
      const float* transfer = values.data() + (count > 0 ? 1 : 0);
      for (const std::size_t unused : {0U, 2U}) {
        expect_bits_of_the_plain_loop({transfer, n + unused, 0, light.data(), 0, n, 1}, count);
        expect_bits_of_the_plain_loop({transfer, n + unused, 0, light.data(), n, n, 3}, count);
        expect_bits_of_the_plain_loop({transfer, 3 * n + unused, n, light.data(), n, n, 3}, count);
        expect_bits_of_the_plain_loop({transfer, 3 * n + unused, n, light.data(), 0, n, 3}, count);
      }
    }
  }
}

TEST(RowProducts, AreTheSameForLongRowsAsForShortOnes) {  // rows are fetched ahead in long ones
  const std::vector<float> light = random_values(75, 3);
  const std::vector<float> values = random_values(std::size_t{25} * 1003, 4);
  expect_bits_of_the_plain_loop({values.data(), 25, 0, light.data(), 25, 25, 3}, 1003);
  expect_bits_of_the_plain_loop({values.data(), 25, 0, light.data(), 25, 4, 3}, 1003);
}

constexpr const TransferKind* kKinds[] = {&kUnshadowed, &kShadowed, &kInterreflected};

TEST(WaysToRelight, WhiteLightGivesTheBitsOfThreeEqualChannels) {
  const LightCoefficients light = white(random_light(4, 8));
  LightCoefficients nearly = light;  // is handled as colored light; blue is zero in both
  for (std::size_t i = 0; i < 25; ++i) nearly.at(2, i) = 0.0;
  for (const TransferKind* kind : kKinds) {
    const Transfer transfer = random_transfer(*kind, 4, 1000);
    const std::vector<Eigen::Vector3f> one = relight(transfer, light);
    const std::vector<Eigen::Vector3f> three = relight(transfer, nearly);
    for (std::size_t v = 0; v < one.size(); ++v) ASSERT_EQ(one[v].head<2>(), three[v].head<2>()) << v;
  }
}

TEST(WaysToRelight, RecoloringByTheAlbedoChangesNothingAndGrayIsWithoutIt) {
  const LightCoefficients light = white(random_light(3, 9));
  const Transfer transfer = random_transfer(kShadowed, 3, 333);
  EXPECT_EQ(recolored(transfer, light, transfer.mesh.albedo), relight(transfer, light));
  const std::vector<float> gray = relight_gray(transfer, light);
  const std::vector<Eigen::Vector3f> ones(333, Eigen::Vector3f::Ones());
  const std::vector<Eigen::Vector3f> as_colors = recolored(transfer, light, ones);
  for (std::size_t v = 0; v < 333; ++v) ASSERT_EQ(as_colors[v], Eigen::Vector3f::Constant(gray[v]));
}

TEST(WaysToRelight, FourCoefficientsAreThoseOfBandsZeroAndOne) {
  const LightCoefficients light = random_light(1, 10);
  for (const TransferKind* kind : kKinds) {
    const Transfer transfer = random_transfer(*kind, 4, 100);
    LightCoefficients padded = LightCoefficients::zero(4);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 4; ++i) padded.at(c, i) = light.at(c, i);
    }
    EXPECT_EQ(relight(transfer, light), relight(transfer, padded));
  }
}

TEST(WaysToRelight, WhatCannotBeDoneIsRefusedInOneLine) {
  const Transfer bounces = random_transfer(kInterreflected, 1, 5);
  const Transfer shadowed = random_transfer(kShadowed, 1, 5);
  const LightCoefficients light = random_light(1, 11);
  std::vector<Eigen::Vector3f> four(4);
  EXPECT_NE(message_of([&] { relight_gray(bounces, light); }).find("cannot be recolored"), std::string::npos);
  EXPECT_NE(message_of([&] { recolored(bounces, light, bounces.mesh.albedo); }).find("cannot be recolored"),
            std::string::npos);
  EXPECT_EQ(message_of([&] { recolored(shadowed, light, four); }),
            "4 colors for 5 vertices: expected one for each vertex");
  EXPECT_EQ(message_of([&] { relight_into(shadowed, light, four); }),
            "4 radiances for 5 vertices: expected one for each vertex");
}

}  // namespace
}  // namespace sh::prt::test
