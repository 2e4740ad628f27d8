// The claims of the sources: which are reproduced, and that those which are not fail for the reasons known.
#include "numeric/report/source_claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace sh::numeric {
namespace {

TEST(SourceClaims, AreReproducedExceptForThoseKnownToBeWrong) {
  const auto claims = source_claims(true);
  ASSERT_EQ(claims.size(), 34U);
  int failed = 0;
  for (const SourceClaim& c : claims) {
    EXPECT_TRUE(std::isfinite(c.measured)) << c.claim;
    EXPECT_FALSE(c.claim.empty() || c.source.empty() || c.printed.empty() || c.how.empty());
    const bool wrong = c.claim.find("16 x 16") != std::string::npos || c.claim.find("32 x 32") != std::string::npos ||
                       c.claim.find("c_2^2") != std::string::npos || c.claim.find("estimate of a texel") == 4;
    EXPECT_EQ(c.reproduced, !wrong) << c.claim << ": " << c.printed << ", measured " << c.measured << c.unit;
    failed += wrong ? 1 : 0;
  }
  EXPECT_EQ(failed, 6);
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
