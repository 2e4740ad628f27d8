// Glossy transfer seen from a point at rest, and under a light at rest: against the run time where both are free.
#include "prt/runtime/fixed_view.hpp"

#include <gtest/gtest.h>

#include "prt/material/microfacet.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/light_at_rest.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const std::vector<Eigen::Vector3d> kEyes = {{2.0, -3.0, 1.5}, {0.0, 0.0, -9.0}, {1e6, 0.0, 1.0}};

void expect_as_seen(const Transfer& glossy, const Eigen::Vector3d& eye) {
  const LightCoefficients light = random_light(glossy.degree(), 5);
  const std::vector<Eigen::Vector3f> wanted =
      exit_radiance(glossy, TransferredRadiance(glossy, light), eye, glossy.mesh.albedo);
  const std::vector<Eigen::Vector3f> got = relight(seen_from(glossy, eye), light);
  ASSERT_EQ(got.size(), wanted.size());
  float largest = 0.0F;
  for (const Eigen::Vector3f& value : wanted) largest = std::max(largest, value.cwiseAbs().maxCoeff());
  for (std::size_t v = 0; v < got.size(); ++v) {
    ASSERT_LT((got[v] - wanted[v]).cwiseAbs().maxCoeff(), 3e-6F * largest) << glossy.kind->letters << " " << v;
  }
}

TEST(FixedView, GivesTheRadianceTowardsTheEyeUnderAnyLight) {
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    for (const int degree : {0, 1, 4}) {
      const Transfer glossy = baked(statue(12.0F), kind, 64, degree);
      for (const Eigen::Vector3d& eye : kEyes) expect_as_seen(glossy, eye);
    }
  }
}

TEST(FixedView, OfOneVertexAndOfNoLobes) {
  Transfer glossy = baked(statue(1e6F), &kGlossyShadowed, 64, 3);
  expect_as_seen(glossy, glossy.mesh.point(0));  // an eye on a vertex
  glossy.mesh.specular.clear();
  glossy.mesh.exponent.clear();
  expect_as_seen(glossy, kEyes.front());
}

void expect_same_from_all_eyes(const Transfer& glossy) {
  const TransferredRadiance reaching(glossy, random_light(glossy.degree(), 5));
  const LightAtRest at_rest(glossy, reaching, glossy.mesh.albedo);
  for (const Eigen::Vector3d& eye : kEyes) {
    const std::vector<Eigen::Vector3f> wanted = exit_radiance(glossy, reaching, eye, glossy.mesh.albedo);
    const std::vector<Eigen::Vector3f> got = at_rest.exit_radiance(eye);
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t v = 0; v < got.size(); ++v) {
      ASSERT_LT((got[v] - wanted[v]).cwiseAbs().maxCoeff(), 2e-5F) << glossy.kind->letters << ' ' << v;
    }
  }
}

TEST(LightAtRest, GivesTheRadianceTowardsAnyEye) {
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    for (const int degree : {0, 1, 4}) {
      Mesh mesh = statue(12.0F);
      mesh.specular[5].setZero();
      expect_same_from_all_eyes(baked(mesh, kind, 64, degree));
    }
  }
  expect_same_from_all_eyes(baked(statue(12.0F), &kGlossyUnshadowed, 64, kMaxDegree));
}

TEST(LightAtRest, OfNoLobesOfBrdfsAndOfLampsToo) {
  Mesh mesh = statue(3.0F);
  mesh.brdfs.number_of(microfacet_reflectance(0.5F, 0.5F));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.brdf.push_back(v % 3 == 0 ? 1 : 0);
  shine(mesh, {1.0F, 2.0F, 3.0F});
  expect_same_from_all_eyes(baked(mesh, &kGlossyShadowed, 64, 2));
  mesh.specular.clear();
  mesh.exponent.clear();
  expect_same_from_all_eyes(baked(mesh, &kGlossyShadowed, 64, 2));
  mesh.brdf.clear();
  mesh.brdfs = {};
  expect_same_from_all_eyes(baked(mesh, &kGlossyShadowed, 64, 2));
}

TEST(LightAtRest, IsFiniteForAnEyeOnAVertex) {
  const Transfer glossy = baked(statue(1e6F), &kGlossyShadowed, 64, 4);
  const LightAtRest at_rest(glossy, TransferredRadiance(glossy, random_light(4, 5)), glossy.mesh.albedo);
  for (const Eigen::Vector3d& eye : {glossy.mesh.point(0), Eigen::Vector3d(1e30, 0.0, 0.0)}) {
    for (const Eigen::Vector3f& value : at_rest.exit_radiance(eye)) EXPECT_TRUE(value.allFinite());
  }
}

TEST(FixedView, KeepsTheLightOfTheSurfacesThemselves) {
  Mesh mesh = polished(primitive_mesh("sphere", 9), 0.0F, 0.0F, 1.0F);
  shine(mesh, {1.0F, 2.0F, 3.0F});
  const Transfer seen = seen_from(baked(mesh, &kGlossyShadowed, 64, 2), kEyes.front());
  EXPECT_EQ(relight(seen, LightCoefficients::zero(2))[3], Eigen::Vector3f(1.0F, 2.0F, 3.0F));
}

TEST(FixedView, IsAFileOfDiffuseTransfer) {
  const TemporaryFolder folder;
  const Transfer seen = seen_from(baked(statue(12.0F), &kGlossyShadowed, 64, 2), kEyes.front());
  write_transfer(folder.file("seen"), seen);
  const Transfer read = read_transfer(folder.file("seen"));
  EXPECT_EQ(read.kind, &kInterreflected);
  EXPECT_EQ(read.bounces.solver, "fixed view");
  EXPECT_EQ(read.coefficients, seen.coefficients);
}

TEST(FixedView, NeedsGlossyTransfer) {
  const Transfer diffuse = baked(primitive_mesh("box"), &kShadowed, 16, 1);
  EXPECT_NE(message_of([&] { seen_from(diffuse, kEyes.front()); }).find("expected a glossy kind"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
