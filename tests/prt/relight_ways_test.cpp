// The bits of relighting against the plain loop, and the ways to relight against each other.
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "generated/batch/batch.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr const TransferKind* kKinds[] = {&kUnshadowed, &kShadowed, &kInterreflected};

// Runs the body on every instruction set of this machine.
template <class Body>
void on_every_instruction_set(const Body& body) {
  const batch::InstructionSet usual = batch::instruction_set();
  for (const auto set :
       {batch::InstructionSet::kBaseline, batch::InstructionSet::kAvx2, batch::InstructionSet::kAvx512}) {
    if (!batch::available(set)) continue;
    SCOPED_TRACE(static_cast<int>(set));
    batch::use_instruction_set(set);
    body();
  }
  batch::use_instruction_set(usual);
}

// One sum, one product and one addition at a time, in the order of the coefficients.
float plain_sum(const Transfer& transfer, std::size_t vertex, std::size_t channel, const LightCoefficients& light) {
  const float* row = transfer.row(vertex) + (transfer.shape.channels == 3 ? channel * transfer.shape.count() : 0);
  float sum = 0.0F;
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    const volatile float term = row[i] * static_cast<float>(light.at(channel, i));  // not contracted
    sum = sum + term;
  }
  return sum;
}

TEST(RelightBits, AreThoseOfThePlainLoopOnEveryInstructionSet) {
  for (const TransferKind* kind : kKinds) {
    for (const int degree : {0, 1, 2, 4, kMaxDegree}) {
      for (const std::size_t vertices : {1U, 15U, 16U, 17U, 40U, 5003U}) {
        if (vertices > 100 && degree > 4) continue;
        const Transfer transfer = random_transfer(*kind, degree, vertices, 2);
        for (const int light_degree : {degree, degree / 2}) {
          for (const bool is_white : {false, true}) {
            const LightCoefficients light =
                is_white ? white(random_light(light_degree, 3)) : random_light(light_degree, 3);
            on_every_instruction_set([&] {
              const std::vector<Eigen::Vector3f> radiance = relight(transfer, light);
              for (std::size_t v = 0; v < vertices; ++v) {
                for (int c = 0; c < 3; ++c) {
                  const float sum = plain_sum(transfer, v, static_cast<std::size_t>(c), light);
                  ASSERT_EQ(radiance[v][c], transfer.shape.holds_albedo ? sum : sum * transfer.mesh.albedo[v][c])
                      << kind->letters << " " << degree << " " << light_degree << " " << is_white << " " << v;
                }
              }
            });
          }
        }
      }
    }
  }
}

TEST(RelightBits, OfOneVertexAndOfGrayOnesAreTheSame) {
  const Transfer transfer = random_transfer(kShadowed, 4, 37, 2);
  const LightCoefficients light = random_light(4, 3);
  on_every_instruction_set([&] {
    const std::vector<float> gray = relight_gray(transfer, light);
    for (std::size_t v = 0; v < gray.size(); ++v) {
      ASSERT_EQ(gray[v], plain_sum(transfer, v, 0, light));
      ASSERT_EQ(relight_vertex(transfer, v, light, Eigen::Vector3f::Ones())[2], plain_sum(transfer, v, 2, light));
    }
  });
}

// Radiance of so many rows is written past the caches; the array of radiance lies at 16 bytes, or 4 or 8 behind.
TEST(RelightBits, OfMoreRowsThanTheCachesHoldAreTheSame) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const std::size_t vertices = (std::size_t{9} << 20U) / kind->shape(4).length() + 3;  // 36 MB
    Transfer transfer = random_transfer(*kind, 4, vertices, 2);
    const LightCoefficients light = random_light(4, 3);
    for (const bool emits : {false, true}) {
      transfer.emitted.assign(emits ? vertices : 0, Eigen::Vector3f(1.0F, 2.0F, 3.0F));
      for (const std::size_t offset : {0U, 1U, 2U}) {
        std::vector<Eigen::Vector3f> room(vertices + offset);
        const std::span radiance = std::span(room).subspan(offset);
        relight_into(transfer, light, radiance);
        for (std::size_t v = 0; v < vertices; v += v + 100 < vertices ? 97 : 1) {
          for (int c = 0; c < 3; ++c) {
            float expected = plain_sum(transfer, v, static_cast<std::size_t>(c), light);
            if (!transfer.shape.holds_albedo) expected *= transfer.mesh.albedo[v][c];
            if (emits) expected += transfer.emitted[v][c];
            ASSERT_EQ(radiance[v][c], expected) << kind->letters << " " << v << " " << offset << " " << emits;
          }
        }
      }
    }
  }
}

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
