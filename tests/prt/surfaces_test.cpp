// Surfaces that shine, and surfaces with two sides, baked.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "prt/bake/bake.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// Every point of a closed sphere sees every other alike: B = E + albedo / (1 - albedo) mean E.
TEST(Emission, FillsAClosedSphereAtAnyAlbedo) {
  Mesh mesh = hollow_sphere(24);
  shine(mesh, {2.0F, 3.0F, 1000.0F});
  for (const float albedo : {0.0F, 0.5F, 0.9F, 0.99F, 0.999F}) {
    paint(mesh, Eigen::Vector3f::Constant(albedo));
    const Transfer transfer = baked(mesh, &kInterreflected);
    EXPECT_TRUE(transfer.bounces.certified);
    const double gain = 1.0 / (1.0 - static_cast<double>(albedo));
    for (const Eigen::Vector3f& emitted : transfer.emitted) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        // The sum of a row is a float's rounding off 1, which the room multiplies once more.
        const double expected = gain * static_cast<double>(mesh.emission[0][c]);
        ASSERT_NEAR(static_cast<double>(emitted[c]), expected, expected * (1e-4 + 2e-7 * gain)) << albedo;
      }
    }
  }
}

// A patch of the sphere emits light, which spreads evenly over the rest.
TEST(Emission, OfAPatchIsSpreadEvenlyOverAClosedSphere) {
  Mesh mesh = hollow_sphere(48);
  paint(mesh, Eigen::Vector3f(0.0F, 0.5F, 0.9F));
  shine(mesh, Eigen::Vector3f::Zero());
  double shining = 0.0;  // part of the area, by the barycentric share of the vertices
  const auto weight = vertex_areas(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z() < -0.5F) {
      mesh.emission[v] = Eigen::Vector3f::Constant(7.0F);
      shining += weight[v];
    }
  }
  const Transfer transfer = baked(mesh, &kInterreflected);
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto albedo = static_cast<double>(mesh.albedo[0][c]);
    const double expected = albedo / (1.0 - albedo) * 7.0 * shining;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto reflected = static_cast<double>(transfer.emitted[v][c] - mesh.emission[v][c]);
      ASSERT_NEAR(reflected, expected, 0.03 * expected) << mesh.positions[v].transpose();
    }
  }
}

// The middle of a disc of radius r at height h above a point that faces it: (r^2 / (r^2 + h^2)) of the cosine.
TEST(Emission, OfADiscLightsThePointBelowItAsInTheClosedForm) {
  for (const float height : {0.25F, 1.0F, 3.0F}) {
    Mesh mesh = disc_above_point(height);
    const Transfer transfer = baked(mesh, &kInterreflected, 4096);
    const double expected = 0.5 * 2.0 / (1.0 + static_cast<double>(height * height));  // albedo 1/2, emission 2
    EXPECT_NEAR(static_cast<double>(transfer.emitted[0].x()), expected, 0.01 * expected + 1e-3) << height;
  }
}

TEST(Emission, WithoutBouncesIsTheSurfacesOwnOnly) {
  Mesh mesh = hollow_sphere(8);
  shine(mesh, {1.0F, 2.0F, 3.0F});
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed}) {
    EXPECT_EQ(baked(mesh, kind).emitted, mesh.emission);
  }
  mesh.emission.clear();
  EXPECT_TRUE(baked(mesh, &kInterreflected).emitted.empty());
}

TEST(Emission, ChangesNoBitOfTheTransferAndIsKeptInTheFile) {
  Mesh mesh = hollow_sphere(16, 0.6F);
  const Transfer dark = baked(mesh, &kInterreflected);
  shine(mesh, {1e6F, 1e-6F, 0.0F});
  const Transfer lit = baked(mesh, &kInterreflected);
  EXPECT_TRUE(lit.bounces.certified);
  EXPECT_LE(lit.bounces.emitted_bound, 1e-4 * lit.bounces.emitted_largest);
  EXPECT_LE(largest_difference(dark, lit), dark.bounces.bound + lit.bounces.bound) << "another step or two at the most";
  const TemporaryFolder folder;
  write_transfer(folder.file("a.prt"), lit);
  const Transfer read = read_transfer(folder.file("a.prt"));
  EXPECT_EQ(read.emitted, lit.emitted);
  EXPECT_EQ(transfer_header(read), transfer_header(lit));
}

// A leaf: thin, both sides alike.
Mesh leaf() {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.3F);
  add_backs(mesh, std::vector<std::uint8_t>(mesh.faces.size(), 1));
  return mesh;
}

TEST(TwoSidedFaces, AreHitOnTheSideThatFacesTheRay) {
  Mesh mesh = leaf();
  const Eigen::Affine3f map(Eigen::AngleAxisf(0.3F, Eigen::Vector3f(1.0F, 2.0F, 0.5F).normalized()));
  for (Eigen::Vector3f& position : mesh.positions) position = map * position;
  append(mesh, primitive_mesh("torus", 8));  // further faces, without backs
  const Tracer tracer(mesh);
  int seen = 0;
  for (float x = -0.6F; x < 0.6F; x += 0.0371F) {
    for (float y = -0.6F; y < 0.6F; y += 0.0373F) {
      for (const float side : {-3.0F, 3.0F}) {
        const std::vector<Eigen::Vector3f> origin = {map * Eigen::Vector3f(x, y, side)};
        const std::vector<Eigen::Vector3f> direction = {map.linear() *
                                                        Eigen::Vector3f(0.01F, 0.02F, -side).normalized()};
        std::vector<Hit> hit(1);
        tracer.intersect(origin, direction, hit);
        if (hit[0].face == Hit::kNothing) continue;
        const Face& face = mesh.faces[hit[0].face];
        const Eigen::Vector3f point = interpolated(hit[0], mesh, mesh.positions);
        EXPECT_LT((point - origin[0] - hit[0].distance * direction[0]).norm(), 1e-5F);
        EXPECT_LT(face_normal(mesh.positions, face).dot(direction[0]), 0.0F);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

// Each side of a leaf sees the whole hemisphere before it, whatever lies behind.
TEST(TwoSidedFaces, GatherTheLightOfTheirOwnSide) {
  const Mesh mesh = leaf();
  const Transfer shadowed = baked(mesh, &kShadowed);
  EXPECT_EQ(shadowed.coefficients, baked(mesh, &kUnshadowed).coefficients);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_GT(shadowed.coefficients[v * 9 + 2] * mesh.normals[v].z(), 0.3F);
  }
}

// A floor under a leaf is lit by the leaf's lower side as by a one-sided one that looks down, and by nothing else.
TEST(TwoSidedFaces, ReflectAndShineFromBehindAsFromTheFront) {
  const auto floor_under = [](bool turned, bool two_sided) {
    Mesh sheet = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, 0.5F)));
    if (turned) turn_inside_out(sheet);
    shine(sheet, {1.0F, 0.0F, 0.0F});
    if (two_sided) add_backs(sheet, {1, 1});
    Mesh mesh = primitive_mesh("plane");
    append(mesh, sheet);
    return baked(mesh, &kInterreflected);
  };
  const Transfer up = floor_under(false, false);
  const Transfer down = floor_under(true, false);
  const Transfer both = floor_under(false, true);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(up.emitted[v].x(), 0.0F);
    EXPECT_GT(down.emitted[v].x(), 0.05F);
    EXPECT_NEAR(both.emitted[v].x(), down.emitted[v].x(), 1e-6F);
    for (std::size_t i = 0; i < 27; ++i) {
      EXPECT_NEAR(both.coefficients[v * 27 + i], down.coefficients[v * 27 + i], 1e-6F);
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
