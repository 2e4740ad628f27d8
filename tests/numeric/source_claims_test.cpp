// The measured claims of the sources: each is reproduced or not as the errata record, for the reasons known.
#include "numeric/report/source_claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "numeric/errata/errata.hpp"

namespace sh::numeric {
namespace {

TEST(SourceClaims, AreReproducedWhereTheErrataSaySo) {
  int failed = 0;
  for (const SourceClaim& c : source_claims(true)) {
    EXPECT_TRUE(std::isfinite(c.measured)) << c.claim;
    EXPECT_FALSE(c.claim.empty() || c.source.empty() || c.printed.empty() || c.how.empty());
    EXPECT_EQ(c.reproduced, c.recorded) << c.id << " " << c.claim << ": " << c.printed << ", measured " << c.measured;
    failed += c.reproduced ? 0 : 1;
  }
  EXPECT_EQ(failed, 6);
}

TEST(SourceClaims, AreEveryMeasuredReadingOfTheErrataOnce) {
  std::multiset<std::string> listed;
  for (const errata::Source& source : errata::all_sources()) {
    for (const errata::Entry& entry : source.entries) {
      for (const errata::Reading& reading : entry.readings) {
        if (!reading.number.empty()) listed.insert(entry.place.id + " " + entry.place.where + ": " + reading.text);
      }
    }
  }
  std::multiset<std::string> measured;
  for (const SourceClaim& c : source_claims(true)) measured.insert(c.id + " " + c.claim);
  EXPECT_EQ(measured, listed);
  EXPECT_THROW(claim_of("S-32", 4, 0, ""), std::out_of_range);
  EXPECT_THROW(claim_of("S-99", 0, 0, ""), std::out_of_range);
}

// Exact values of the errata: 19 sqrt(19)/2700 and 3/32 of one light bound every light's.
TEST(SourceClaims, OnIrradianceStayWithinTheExactErrorsOfOneLight) {
  const auto claims = irradiance_claims(true);
  EXPECT_LE(claims[0].measured, 100 * 19 * std::sqrt(19) / 2700 * 1.001);  // 4000 normals
  EXPECT_GE(claims[0].measured, 3.06);
  EXPECT_LE(claims[1].measured, 9.375);
  EXPECT_GE(claims[1].measured, 9.36);
}

TEST(SourceClaims, OnCubeMapsFallByTheOrderOfTheRule) {
  const auto errors = cube_map_errors({32, 64});
  ASSERT_EQ(errors.size(), 6U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(errors[i].mean_squared / errors[i + 3].mean_squared, 16, 0.5) << errors[i].weight;
    EXPECT_NEAR(errors[i].worst_squared / errors[i + 3].worst_squared, 16, 0.5) << errors[i].weight;
  }
  EXPECT_EQ(errors[0].worst_texel, 0);
  EXPECT_LT(std::abs(errors[0].area), 1e-13);
  EXPECT_GT(errors[1].area, 1e-4);                            // the differential form sums to more than 4 pi
  EXPECT_LT(errors[2].mean_squared, errors[0].mean_squared);  // scaled, it beats the exact solid angle
  EXPECT_NEAR(bilinear_error(8).mean_squared / bilinear_error(16).mean_squared, 12.4, 0.2);
}

// Printed for 8, 16 and 32 texels: all six numbers are right if it was the number of texels that doubled.
TEST(SourceClaims, OnBilinearImagesAreThoseOfEightElevenAndSixteenTexels) {
  const auto claims = bilinear_claims();
  std::size_t i = 0;
  for (const int size : {8, 11, 16}) {
    const BilinearError error = bilinear_error(size);
    EXPECT_TRUE(rounds_to(100 * error.mean_squared, claims[i++].printed)) << size;
    EXPECT_TRUE(rounds_to(100 * error.worst_squared, claims[i++].printed)) << size;
  }
}

TEST(SourceClaims, RoundAtTheLastPrintedDigit) {
  EXPECT_TRUE(rounds_to(0.265, "0.3"));
  EXPECT_FALSE(rounds_to(0.249, "0.3"));
  EXPECT_TRUE(rounds_to(1.49, "1"));
  EXPECT_TRUE(rounds_to(-0.04, "-0.0"));
  EXPECT_FALSE(rounds_to(0.0934, "-0.09"));
  EXPECT_FALSE(rounds_to(std::nan(""), "0"));
}

}  // namespace
}  // namespace sh::numeric
