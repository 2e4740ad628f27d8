// Primitives, welding, normals, splitting.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "prt/mesh/mend.hpp"
#include "prt/mesh/weld.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Soup two_triangles() {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
  soup.normals.assign(7, Eigen::Vector3f::UnitZ());
  soup.albedo.assign(7, Eigen::Vector3f::Constant(0.5F));
  soup.faces = {{0, 1, 2}, {3, 4, 5}};
  return soup;
}

TEST(Primitives, AreClosedSurfacesInTheUnitCubeTurnedOutwards) {
  for (const std::string_view name : primitive_names()) {
    const Mesh mesh = primitive_mesh(name);
    for (const Eigen::Vector3f& position : mesh.positions) {
      EXPECT_LE(position.cwiseAbs().maxCoeff(), 0.5F + 1e-6F) << name;
    }
    if (name != "plane" && name != "hills") {
      EXPECT_TRUE(is_closed_surface(mesh)) << name;
      EXPECT_GT(signed_volume(mesh), 0.0) << name;
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_GT(mesh.normals[v].dot(mesh.geometric_normals[v]), 0.9F) << name;
    }
  }
}

TEST(Primitives, HaveTheVolumesOfTheirShapes) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(signed_volume(primitive_mesh("box")), 1.0, 1e-6);
  EXPECT_NEAR(signed_volume(primitive_mesh("stairs")), 0.6, 1e-6);
  EXPECT_NEAR(signed_volume(primitive_mesh("sphere", 256)), kPi / 6.0, 1e-3);
  EXPECT_NEAR(signed_volume(primitive_mesh("cylinder", 256)), kPi / 4.0, 1e-3);
  EXPECT_NEAR(signed_volume(primitive_mesh("cone", 256)), kPi / 12.0, 1e-3);
  EXPECT_NEAR(signed_volume(primitive_mesh("ring", 256)), kPi * (0.25 - 0.43 * 0.43), 1e-3);
  EXPECT_NEAR(signed_volume(primitive_mesh("torus", 256)), 2.0 * kPi * kPi * 0.36 * 0.14 * 0.14, 1e-3);
  EXPECT_NEAR(signed_volume(primitive_mesh("wing", 512)), 8.0 / 6.0 * 0.012 * 0.65 * 5.0 / 12.0, 2e-6);
  EXPECT_NEAR(signed_volume(primitive_mesh("arch", 256)), 1.0 - 0.6 * 0.6 - 0.5 * kPi * 0.09, 1e-3);
}

TEST(Welding, JoinsVerticesOfOnePositionNormalAndAlbedoAndKeepsTheRemap) {
  const Soup soup = two_triangles();
  const Mesh mesh = weld(soup, soup.positions.size());
  EXPECT_EQ(mesh.positions.size(), 4U);
  ASSERT_EQ(mesh.remap.size(), 7U);
  EXPECT_EQ(mesh.remap[0], mesh.remap[3]);
  EXPECT_EQ(mesh.remap[2], mesh.remap[4]);
  EXPECT_EQ(mesh.remap[6], kNoVertex);
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_EQ(mesh.point(mesh.remap[v]), soup.positions[v]);
  }
}

TEST(Welding, KeepsApartWhatDiffersInNormalOrAlbedo) {
  Soup soup = two_triangles();
  soup.normals[3] = Eigen::Vector3f(1, 0, 1).normalized();
  soup.albedo[4] = Eigen::Vector3f::Zero();
  EXPECT_EQ(weld(soup, soup.positions.size()).positions.size(), 6U);
}

TEST(Welding, IgnoresTheSignOfZeroAndTheRoundingOfNormals) {
  Soup soup = two_triangles();
  soup.positions[3] = {-0.0, 0.0, -0.0};
  soup.normals[4] = Eigen::Vector3f(1e-6F, -1e-6F, 1.0F);
  EXPECT_EQ(weld(soup, soup.positions.size()).positions.size(), 4U);
}

TEST(Normals, FollowTheCreaseAngle) {
  Soup soup = make_primitive("box");
  soup.normals.clear();
  Soup smooth = soup;
  complete_normals(soup, 40.0F);
  EXPECT_EQ(weld(soup, soup.positions.size()).positions.size(), 24U);
  complete_normals(smooth, 120.0F);
  const Mesh mesh = weld(smooth, smooth.positions.size());
  EXPECT_EQ(mesh.positions.size(), 8U);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT((mesh.normals[v] - mesh.positions[v].normalized()).norm(), 1e-6F);
  }
}

TEST(Normals, ThatAreOfNoUseComeFromTheFaces) {
  Soup soup = two_triangles();
  soup.normals[1] = Eigen::Vector3f::Zero();
  soup.normals[2] = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(complete_normals(soup, 40.0F), 2U);
  const Mesh mesh = weld(soup, 7);
  EXPECT_EQ(mesh.positions.size(), 4U);
  for (const Eigen::Vector3f& normal : mesh.normals) {
    EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
  }
}

TEST(Soups, WithFacesWithoutAreaLoseThem) {
  Soup soup = two_triangles();
  soup.faces.push_back({0, 0, 1});
  soup.faces.push_back({0, 2, 4});
  EXPECT_EQ(drop_faces_without_area(soup), 2U);
  EXPECT_EQ(soup.faces.size(), 2U);
}

TEST(Soups, AreRefusedWithNaNInfinityFacesOutOfRangeOrNoFaces) {
  const auto said = [](const Soup& soup) { return message_of([&] { check(soup, "a.obj"); }); };
  EXPECT_EQ(said(two_triangles()), "");
  Soup soup = two_triangles();
  soup.positions[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(said(soup), "a.obj: vertex 5 has a coordinate that is not finite");
  soup.positions[5].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(said(soup), "a.obj: vertex 5 has a coordinate that is not finite");
  soup = two_triangles();
  soup.faces[1][2] = 7;
  EXPECT_EQ(said(soup), "a.obj: face 1 names vertex 7, but there are 7 vertices");
  soup.faces.clear();
  EXPECT_EQ(said(soup), "a.obj: the mesh has no faces, expected at least one triangle");
}

TEST(Transforms, ThatMirrorKeepTheOutsideOutside) {
  Soup soup = make_primitive("stairs");
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.scale(Eigen::Vector3d(-2.0, 1.0, 3.0));
  transform(soup, map);
  const Mesh mesh = weld(soup, soup.positions.size());
  EXPECT_NEAR(signed_volume(mesh), 3.6, 1e-5);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_GT(mesh.normals[v].dot(mesh.geometric_normals[v]), 0.99F);
  }
}

TEST(Splitting, RespectsTheLongestEdgeAndOpensNoCracks) {
  for (const std::string name : {"box", "stairs", "arch", "cylinder", "cone"}) {
    Mesh mesh = primitive_mesh(name);
    const double volume = signed_volume(mesh);
    const std::size_t vertices = mesh.positions.size();
    const std::vector<Eigen::Vector3f> before = mesh.positions;
    tessellate(
        mesh, [](const Eigen::Vector3f&) { return 0.13F; }, name);
    EXPECT_LE(longest_edge(mesh), 0.13F) << name;
    EXPECT_TRUE(is_closed_surface(mesh)) << name;
    EXPECT_NEAR(signed_volume(mesh), volume, 1e-5) << name;
    EXPECT_GT(mesh.positions.size(), vertices) << name;
    EXPECT_TRUE(std::equal(before.begin(), before.end(), mesh.positions.begin())) << name;
    EXPECT_EQ(mesh.geometric_normals.size(), mesh.positions.size()) << name;
  }
}

TEST(Splitting, MayBeFinerInOnePlaceThanInAnother) {
  Mesh mesh = primitive_mesh("box");
  tessellate(
      mesh, [](const Eigen::Vector3f& p) { return p.x() < 0.0F ? 0.05F : 0.4F; }, "box");
  EXPECT_TRUE(is_closed_surface(mesh));
  EXPECT_NEAR(signed_volume(mesh), 1.0, 1e-5);
}

TEST(Splitting, EndsAtAnyOffset) {
  for (const double offset : {1e5, 1e7, 1e9, 1e30}) {
    Mesh mesh = primitive_mesh("box");
    for (Eigen::Vector3f& p : mesh.positions) p += Eigen::Vector3f::Constant(static_cast<float>(offset));
    tessellate(
        mesh, [](const Eigen::Vector3f&) { return 0.1F; }, "box");  // without a frame, edges of 1e-8 of the coordinate
    EXPECT_LT(mesh.faces.size(), 100000U) << offset;
  }
}

TEST(Splitting, CountsAheadAndSaysWhatWouldDo) {
  Mesh mesh = primitive_mesh("box");
  const Mesh before = mesh;
  const std::string said = message_of([&] {
    tessellate(
        mesh, [](const Eigen::Vector3f&) { return 1e-9F; }, "box");
  });
  EXPECT_EQ(mesh.positions, before.positions);
  const std::string expected = "box: max_edge makes more than 33554432 faces; expected one at least ";
  ASSERT_EQ(said.substr(0, expected.size()), expected);
  const double factor = std::stod(said.substr(expected.size()));
  const double faces = 12.0 / std::pow(factor * 1e-9, 2.0);  // at least half as many as this, at most twice
  EXPECT_LT(faces, 2.0 * static_cast<double>(kMaxFaces));
  EXPECT_GT(faces, 0.1 * static_cast<double>(kMaxFaces));
}

TEST(Splitting, MakesUnitNormalsAlongSmoothEdges) {
  Mesh mesh = primitive_mesh("sphere");
  tessellate(
      mesh, [](const Eigen::Vector3f&) { return 0.05F; }, "sphere");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(mesh.normals[v].norm(), 1.0F, 1e-6F);
    EXPECT_GT(mesh.normals[v].dot(mesh.positions[v].normalized()), 0.999F);
  }
}

TEST(Flaw, QuotesNamesWithoutTheirControlCharacters) {
  testing::internal::CaptureStderr();
  report_flaw(OnFlaw::kMend, "a\n\x1b[2J.obj: 3 faces have no area (dropped)");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: a\\x0a\\x1b[2J.obj: 3 faces have no area (dropped)\n");
}

}  // namespace
}  // namespace sh::prt::test
