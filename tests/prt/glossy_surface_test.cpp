// Glossy transfer in pictures, in files, and where it is refused.
#include <gtest/gtest.h>

#include "prt/material/lobe.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

TEST(GlossySurface, AtAVertexIsTheExitRadianceOfTheVertex) {
  const Mesh mesh = statue(12.0F);
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 256, 4);
  const TransferredRadiance reaching(transfer, random_light(4, 9));
  const Eigen::Vector3d eye(2.0, -3.0, 1.5);
  const std::vector<Eigen::Vector3f> relit = exit_radiance(transfer, reaching, eye, mesh.albedo);
  const Surface surface = glossy_surface(transfer, reaching, mesh.albedo);
  for (std::uint32_t f = 0; f < mesh.faces.size(); f += 13) {
    for (int k = 0; k < 3; ++k) {
      const Hit hit{f, k == 1 ? 1.0F : 0.0F, k == 2 ? 1.0F : 0.0F, 1.0F};
      const std::uint32_t v = mesh.faces[f][k];
      const Eigen::Vector3d direction = (mesh.point(v) - eye).normalized();
      EXPECT_LT((surface(hit, direction.cast<float>()) - relit[v]).norm(), 1e-5F) << f;
    }
  }
}

TEST(GlossySurface, ShowsEmissionToo) {
  Mesh mesh = polished(primitive_mesh("sphere", 9), 0.0F, 0.0F, 1.0F);
  shine(mesh, {1.0F, 2.0F, 3.0F});
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, 2);
  const TransferredRadiance reaching(transfer, random_light(2, 9));
  EXPECT_EQ(exit_radiance(transfer, reaching, {5.0, 0.0, 0.0}, mesh.albedo)[3], Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(glossy_surface(transfer, reaching, mesh.albedo)({0, 0.25F, 0.25F, 1.0F}, Eigen::Vector3f::UnitX()),
            Eigen::Vector3f(1.0F, 2.0F, 3.0F));
}

TEST(GlossySurface, IsFiniteFromBelowTheHorizonAndFromTheVertexItself) {
  const Mesh mesh = statue(1e6F);
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, 4);
  const TransferredRadiance reaching(transfer, random_light(4, 9));
  for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0.0, 0.0, -9.0), mesh.point(0), Eigen::Vector3d(1e30, 0.0, 0.0)}) {
    for (const Eigen::Vector3f& value : exit_radiance(transfer, reaching, eye, mesh.albedo)) {
      EXPECT_TRUE(value.allFinite());
    }
  }
}

TEST(GlossySurface, OfAMeshWithoutLobesIsDiffuse) {
  Mesh mesh = primitive_mesh("stairs");
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, 2);
  const TransferredRadiance reaching(transfer, random_light(2, 3));
  for (std::size_t v = 0; v < mesh.positions.size(); v += 5) {
    const std::vector<Eigen::Vector3f> a = exit_radiance(transfer, reaching, {1.0, 2.0, 3.0}, mesh.albedo);
    const std::vector<Eigen::Vector3f> b = exit_radiance(transfer, reaching, {-3.0, 2.0, 1.0}, mesh.albedo);
    EXPECT_EQ(a[v], b[v]);
  }
}

TEST(GlossyFile, KeepsEveryNumberAndMaterial) {
  const TemporaryFolder folder;
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed}) {
    const Transfer written = baked(statue(12.0F), kind, 64, 3);
    write_transfer(folder.file("g"), written);
    const Transfer read = read_transfer(folder.file("g"));
    EXPECT_EQ(read.kind, kind);
    EXPECT_TRUE(is_alike(read.shape, written.shape));
    EXPECT_EQ(read.coefficients, written.coefficients);
    EXPECT_EQ(read.mesh.specular, written.mesh.specular);
    EXPECT_EQ(read.mesh.exponent, written.mesh.exponent);
  }
}

TEST(GlossyFile, IsRefusedWithMaterialsThatDoNotExist) {
  const TemporaryFolder folder;
  Transfer transfer = baked(statue(12.0F), &kGlossyShadowed, 64, 1);
  const auto refused = [&](const std::string& reason) {
    EXPECT_NE(message_of([&] { write_transfer(folder.file("g"), transfer); }).find(reason), std::string::npos);
  };
  for (const float bad : {-1.0F, 1.1e6F, std::numeric_limits<float>::quiet_NaN()}) {
    transfer.mesh.exponent.back() = bad;
    refused("an exponent is not from 0 to 1e6");
  }
  transfer.mesh.exponent.back() = 1.0F;
  transfer.mesh.specular.back().y() = 1.5F;
  refused("a specular reflectance is not from 0 to 1");
  transfer.mesh.exponent.pop_back();
  refused("differ in length");
}

TEST(SharpestLobe, IsThatOfTheLargestExponentThatReflects) {
  Transfer transfer = baked(statue(12.0F), &kGlossyShadowed, 64, 4);
  EXPECT_EQ(sharpest_lobe(transfer)->exponent, 12.0);
  EXPECT_EQ(sharpest_lobe(transfer)->share, phong_share(4, 12.0));
  transfer.mesh.exponent.back() = 100.0F;
  transfer.mesh.exponent[3] = 50.0F;
  EXPECT_EQ(sharpest_lobe(transfer)->exponent, 100.0);
  transfer.mesh.specular.back().setZero();
  EXPECT_EQ(sharpest_lobe(transfer)->exponent, 50.0);
  transfer.mesh.specular.assign(transfer.mesh.specular.size(), Eigen::Vector3f::Zero());
  EXPECT_FALSE(sharpest_lobe(transfer).has_value());
  EXPECT_FALSE(sharpest_lobe(baked(statue(12.0F), &kShadowed, 64, 1)).has_value());
}

TEST(GlossyBake, RefusesWhatItCannotHold) {
  Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 64, 6);
  const auto refused = [&](const std::string& reason) {
    const std::string message = message_of([&] { bake(scene); });
    EXPECT_NE(message.find(reason), std::string::npos) << message;
  };
  refused("degree: expected 0 to 5 (of the kind glossy_shadowed), got 6");
  scene.bake.degree = 4;
  scene.bake.sampler = Sampler::kCosine;
  refused("the sampler cosine");
  scene.bake.sampler = Sampler::kFibonacci;
  scene.mesh.mirror.assign(scene.mesh.positions.size(), Eigen::Vector3f::Constant(0.5F));
  refused("expected no mirrors, or a diffuse kind");
}

TEST(GlossyTransfer, IsRefusedWhereRadianceNeedsNoDirection) {
  const Transfer glossy = baked(statue(12.0F), &kGlossyShadowed, 64, 2);
  const LightCoefficients light = random_light(2, 1);
  EXPECT_NE(message_of([&] { relight(glossy, light); }).find("expected diffuse transfer"), std::string::npos);
  EXPECT_NE(message_of([&] { relight_gray(glossy, light); }).find("expected diffuse transfer"), std::string::npos);
  EXPECT_NE(message_of([&] { TransferredRadiance(glossy, random_light(3, 1)); }).find("must not be higher"),
            std::string::npos);
  const Transfer diffuse = baked(primitive_mesh("box"), &kShadowed, 64, 2);
  EXPECT_NE(message_of([&] { TransferredRadiance(diffuse, light); }).find("expected a glossy kind"), std::string::npos);
  LightCoefficients strong = light;
  for (double& value : strong.values) value = 3e38;
  EXPECT_NE(message_of([&] { TransferredRadiance(glossy, strong); }).find("exceeds single precision"),
            std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
