// Relighting against the plain double sum, and the PLY file it is written to.
#include "prt/runtime/relight.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

TEST(Relight, AddsTheLightOfTheSurfacesThemselvesWhateverTheLight) {
  Transfer transfer = random_transfer(kUnshadowed, 2, 17, 3);
  const std::vector<Eigen::Vector3f> reflected = relight(transfer, random_light(2, 4));
  for (std::size_t v = 0; v < reflected.size(); ++v) transfer.emitted.emplace_back(static_cast<float>(v), 3.0F, 0.0F);
  const std::vector<Eigen::Vector3f> all = relight(transfer, random_light(2, 4));
  const std::vector<Eigen::Vector3f> alone = relight(transfer, LightCoefficients::zero(2));
  for (std::size_t v = 0; v < reflected.size(); ++v) {
    EXPECT_EQ(all[v], reflected[v] + transfer.emitted[v]);
    EXPECT_EQ(alone[v], transfer.emitted[v]);
  }
  const std::vector<Eigen::Vector3f> colors(all.size(), {0.25F, 0.5F, 1.0F});
  const std::vector<Eigen::Vector3f> other = recolored(transfer, random_light(2, 4), colors);
  for (std::size_t v = 0; v < all.size(); ++v) {
    EXPECT_EQ(relight_vertex(transfer, v, random_light(2, 4), transfer.mesh.albedo[v]), all[v]);
    EXPECT_EQ(relight_vertex(transfer, v, random_light(2, 4), colors[v]), other[v]);
  }
  EXPECT_EQ(recolored(transfer, LightCoefficients::zero(2), colors), transfer.emitted);
}

TEST(Relight, IsAlbedoTimesTheDotProductOfTransferAndLight) {
  for (const int degree : {0, 1, 2, 4, kMaxDegree}) {
    const Transfer transfer = random_transfer(kUnshadowed, degree, 3001, 1);
    const LightCoefficients light = random_light(degree, 2);
    const std::vector<Eigen::Vector3f> radiance = relight(transfer, light);
    ASSERT_EQ(radiance.size(), 3001U);
    const std::size_t n = light.bands_squared();
    for (std::size_t v = 0; v < radiance.size(); ++v) {
      for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        double terms = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          const double term = static_cast<double>(transfer.coefficients[v * n + i]) * light.at(c, i);
          sum += term;
          terms += std::abs(term);
        }
        const auto albedo = static_cast<double>(transfer.mesh.albedo[v][c]);
        EXPECT_NEAR(static_cast<double>(radiance[v][c]), albedo * sum, 5e-7 * terms + 1e-12) << degree;
      }
    }
  }
}

TEST(Relight, IsLinearInTheLight) {
  const Transfer transfer = random_transfer(kUnshadowed, 3, 100, 3);
  LightCoefficients light = random_light(3, 4);
  const std::vector<Eigen::Vector3f> once = relight(transfer, light);
  for (double& value : light.values) value *= 4.0;
  const std::vector<Eigen::Vector3f> fourfold = relight(transfer, light);
  for (std::size_t v = 0; v < once.size(); ++v) EXPECT_EQ(fourfold[v], 4.0F * once[v]);
}

TEST(Relight, OpenUpwardVertexUnderUnitConstantLightLeavesItsAlbedo) {
  Transfer transfer = random_transfer(kUnshadowed, 1, 3, 5);
  transfer.coefficients.assign(12, 0.0F);
  const auto dc = static_cast<float>(1.0 / std::sqrt(4.0 * std::numbers::pi));
  for (const std::size_t v : {0U, 1U, 2U}) transfer.coefficients[4 * v] = dc;  // A_0 / pi Y_00
  const std::vector<Eigen::Vector3f> radiance = relight(transfer, constant_light(1));
  for (const std::size_t v : {0U, 1U, 2U}) EXPECT_LT((radiance[v] - transfer.mesh.albedo[v]).norm(), 2e-7F);
}

TEST(Relight, BitsDoNotDependOnTheNumberOfThreads) {
  const Transfer transfer = random_transfer(kUnshadowed, 4, 20000, 6);
  const LightCoefficients light = random_light(4, 7);
  const std::vector<Eigen::Vector3f> expected = relight(transfer, light);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(relight(transfer, light), expected);
}

TEST(Relight, ALightOfHigherDegreeIsRefused) {
  const std::string message = message_of([] { relight(random_transfer(kUnshadowed, 2, 3, 8), random_light(3, 9)); });
  EXPECT_EQ(message, "the light has degree 3, the transfer 2; the light's must not be higher");
}

TEST(Relight, PlyHoldsPositionsNormalsRadianceAndFaces) {
  const TemporaryFolder folder;
  const Transfer transfer = random_transfer(kUnshadowed, 0, 5, 10);
  const std::vector<Eigen::Vector3f> radiance = relight(transfer, random_light(0, 11));
  write_ply(folder.file("a.ply"), transfer.mesh, radiance);
  const std::string bytes = read_all(folder.file("a.ply"));
  const std::string end = "end_header\n";
  const std::size_t body = bytes.find(end) + end.size();
  ASSERT_EQ(bytes.size(), body + 5U * 9U * sizeof(float) + 3U * (1U + 3U * sizeof(std::uint32_t)));
  EXPECT_NE(bytes.find("element vertex 5\n"), std::string::npos);
  EXPECT_NE(bytes.find("element face 3\n"), std::string::npos);
  for (std::size_t v = 0; v < 5; ++v) {
    Eigen::Matrix<float, 3, 3> row;  // columns: position, normal, radiance
    std::memcpy(row.data(), bytes.data() + body + v * 9 * sizeof(float), 9 * sizeof(float));
    EXPECT_EQ(row.col(0), transfer.mesh.positions[v]);
    EXPECT_EQ(row.col(1), transfer.mesh.normals[v]);
    EXPECT_EQ(row.col(2), radiance[v]);
  }
}

TEST(Relight, PlyThatCannotBeWrittenIsNamedAndLeavesNothing) {
  const TemporaryFolder folder;
  const Transfer transfer = random_transfer(kUnshadowed, 0, 5, 12);
  const std::vector<Eigen::Vector3f> radiance(5, Eigen::Vector3f::Ones());
  for (const std::string& file : {folder.file("no/a.ply"), std::string("/dev/full")}) {
    const std::string message = message_of([&] { write_ply(file, transfer.mesh, radiance); });
    EXPECT_EQ(message.rfind(file + ": cannot write", 0), 0U) << message;
  }
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace sh::prt::test
