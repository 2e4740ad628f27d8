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

// A diffuse floor and a torus with a lobe: the vectors are those of the floor, and of the diffuse part of the torus.
Mesh floor_and_torus(float specular) {
  Mesh mesh = primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Scaling(3.0F)));
  refine(mesh, 0.3F);
  mesh = finished(mesh, {0.7F, 0.5F, 0.2F}, Eigen::Vector3f::Zero(), 0.0F);
  append(mesh, finished(primitive_mesh("torus", 10, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, 0.4F))),
                        {0.3F, 0.1F, 0.1F}, Eigen::Vector3f::Constant(specular), 9.0F));
  return mesh;
}

TEST(DiffuseVectors, AreThoseOfDiffuseSurfacesToEveryEye) {
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const Transfer glossy = baked(floor_and_torus(0.6F), kind, 256, 3);
    const Transfer vectors = diffuse_vectors(glossy);
    EXPECT_EQ(vectors.kind, &kInterreflected);
    const LightCoefficients light = random_light(3, 8);
    const TransferredRadiance reaching(glossy, light);
    const std::vector<Eigen::Vector3f> relit = relight(vectors, light);
    for (const Eigen::Vector3d& eye : kEyes) {
      const std::vector<Eigen::Vector3f> wanted = exit_radiance(glossy, reaching, eye, glossy.mesh.albedo);
      float apart = 0.0F;
      for (std::size_t v = 0; v < relit.size(); ++v) {
        const float off = (relit[v] - wanted[v]).cwiseAbs().maxCoeff();
        if (glossy.mesh.specular[v].isZero(0.0F)) {
          EXPECT_LT(off, 1e-5F) << kind->letters << " " << v;
        }
        apart = std::max(apart, off);
      }
      EXPECT_GT(apart, 0.05F) << "the torus has a lobe, too";
    }
  }
}

TEST(DiffuseVectors, MeetTheDiffuseBakeWhereNothingIsGlossy) {
  const Mesh mesh = floor_and_torus(0.0F);
  const LightCoefficients light = constant_light(4);
  const std::vector<Eigen::Vector3f> rows = relight(baked(mesh, &kInterreflected, 2048, 4), light);
  const std::vector<Eigen::Vector3f> vectors =
      relight(diffuse_vectors(baked(mesh, &kGlossyInterreflected, 2048, 4)), light);
  double squares = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    squares += static_cast<double>((vectors[v] - rows[v]).squaredNorm());
    all += static_cast<double>(rows[v].squaredNorm());
  }
  EXPECT_LT(std::sqrt(squares / all), 0.03) << "the clamped cosine to degree 4 is a little off";
}

TEST(DiffuseVectors, TakeTheAlbedoOfTheFitInPlaceOfABrdf) {
  Mesh mesh = finished(primitive_mesh("sphere", 8), {0.6F, 0.4F, 0.2F}, Eigen::Vector3f::Zero(), 0.0F);
  mesh.brdfs.number_of(microfacet_reflectance(0.5F, 0.0F));
  mesh.brdf.assign(mesh.positions.size(), 1);
  const Transfer vectors = diffuse_vectors(baked(mesh, &kGlossyShadowed, 64, 2));
  EXPECT_TRUE(vectors.mesh.brdf.empty());
  const std::vector<Eigen::Vector3f> relit = relight(vectors, constant_light(2));
  EXPECT_GT(relit[0].x(), 0.3F);
  EXPECT_LT(relit[0].x(), 0.6F) << "the coat takes its part";
}

TEST(FixedView, NeedsGlossyTransfer) {
  const Transfer diffuse = baked(primitive_mesh("box"), &kShadowed, 16, 1);
  EXPECT_NE(message_of([&] { seen_from(diffuse, kEyes.front()); }).find("expected a glossy kind"), std::string::npos);
  EXPECT_NE(message_of([&] { diffuse_vectors(diffuse); }).find("expected a glossy kind"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
