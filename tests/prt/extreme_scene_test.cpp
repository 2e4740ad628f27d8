// Meshes and lights at the edge of what can be stored: every number stays finite and right.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "prt/light/light.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// The part of the cosine that sees the sky.
double openness(const Transfer& transfer, std::size_t vertex) {
  return static_cast<double>(transfer.row(vertex)[0] * kRoot4Pi);
}

void expect_light(const Transfer& transfer) {
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    for (std::size_t i = 0; i < transfer.shape.length(); ++i) ASSERT_TRUE(std::isfinite(transfer.row(v)[i])) << v;
    ASSERT_GE(openness(transfer, v), 0.0) << v;
    ASSERT_LE(openness(transfer, v), 1.0 + 1e-6) << v;
  }
}

Mesh triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.normals.assign(3, (b - a).cross(c - a).normalized());
  mesh.albedo.assign(3, Eigen::Vector3f::Constant(0.5F));
  mesh.faces = {{0, 1, 2}};
  set_geometric_normals(mesh);
  return mesh;
}

Mesh floor_of(float size, float height = 0.0F) {
  Eigen::Affine3f map(Eigen::Translation3f(0.0F, 0.0F, height));
  map.scale(size);
  return primitive_mesh("plane", 8, map);
}

Mesh standing_box(float size = 1.0F) {
  Eigen::Affine3f map(Eigen::Translation3f(0.0F, 0.0F, 0.5F * size));
  map.scale(size);
  return primitive_mesh("box", 8, map);
}

TEST(ExtremeScenes, OneTriangleIsOpen) {
  const Mesh mesh = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(baked(mesh, &kShadowed).coefficients, baked(mesh, &kUnshadowed).coefficients);
  expect_light(baked(mesh, &kInterreflected));
}

// A floor whose one half is strips 1e-6 wide, under a roof: the strips see what the floor sees.
TEST(ExtremeScenes, SliversSeeWhatTheirNeighborsSee) {
  Mesh mesh = floor_of(1.0F, 0.4F);  // the roof
  turn_inside_out(mesh);
  const std::size_t roof = mesh.positions.size();
  for (int i = 0; i < 8; ++i) {
    const float y = 1e-6F * static_cast<float>(i);
    append(mesh, triangle({-0.5F, y, 0.0F}, {0.5F, y, 0.0F}, {0.5F, y + 1e-6F, 0.0F}));
    append(mesh, triangle({-0.5F, y, 0.0F}, {0.5F, y + 1e-6F, 0.0F}, {-0.5F, y + 1e-6F, 0.0F}));
  }
  const Transfer transfer = baked(mesh, &kInterreflected, 4096);
  expect_light(transfer);
  for (std::size_t v = roof; v < mesh.positions.size(); ++v) {
    ASSERT_NEAR(openness(transfer, v), openness(transfer, roof), 0.01) << v;  // of its middle line, by symmetry
  }
}

// The wall's foot lies on the floor's faces: it sees half of the sky.
TEST(ExtremeScenes, AVertexOnAnothersFaceSeesItsOwnSide) {
  Mesh mesh = standing_box();
  const std::size_t box = mesh.positions.size();
  append(mesh, floor_of(1000.0F));
  const Transfer transfer = baked(mesh, &kShadowed, 4096);
  expect_light(transfer);
  for (std::size_t v = 0; v < box; ++v) {
    const bool is_wall = std::abs(mesh.normals[v].z()) < 0.5F;
    if (is_wall) {
      EXPECT_NEAR(openness(transfer, v), 0.5, 0.01) << v;
    } else if (mesh.normals[v].z() > 0.5F) {
      EXPECT_NEAR(openness(transfer, v), 1.0, 1e-6) << v;
    }
  }
}

TEST(ExtremeScenes, CoplanarDoublesAreOpen) {
  Mesh mesh = floor_of(1.0F);
  append(mesh, floor_of(1.0F));
  append(mesh, floor_of(0.5F));
  const Transfer transfer = baked(mesh, &kShadowed);
  EXPECT_EQ(transfer.coefficients, baked(mesh, &kUnshadowed).coefficients);
  expect_light(baked(mesh, &kInterreflected));
}

TEST(ExtremeScenes, MeshesInsideOutAreDark) {
  Mesh mesh = standing_box();
  refine(mesh, 0.5F);
  turn_inside_out(mesh);
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Transfer transfer = baked(mesh, kind);
    expect_light(transfer);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(openness(transfer, v), 0.0) << v;
  }
}

// A box of 1e-3 on faces of 1e3: what it sees does not depend on where the faces end.
TEST(ExtremeScenes, AMillionFoldRangeOfSizesChangesNoLight) {
  const auto box_on = [](float floor) {
    Mesh mesh = standing_box(1e-3F);
    refine(mesh, 4e-4F);
    append(mesh, floor_of(floor));
    return baked(mesh, &kShadowed, 2048);
  };
  const Transfer near_end = box_on(1.0F);
  const Transfer far_end = box_on(1000.0F);
  expect_light(far_end);
  EXPECT_LT(rms_difference(near_end, far_end), 2e-3);
  EXPECT_LT(largest_difference(near_end, far_end), 2e-2);
}

TEST(ExtremeScenes, AStrongSunInADarkRoomStaysWhereItFalls) {
  Mesh mesh = standing_box();
  refine(mesh, 0.25F);
  turn_inside_out(mesh);
  std::erase_if(mesh.faces, [&](const Face& face) {  // an opening in the ceiling
    const Eigen::Vector3f middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0F;
    return middle.z() > 0.99F && middle.head<2>().norm() < 0.2F;
  });
  paint(mesh, Eigen::Vector3f::Constant(0.01F));
  const Transfer transfer = baked(mesh, &kInterreflected, 2048, 4);
  LightSpec sun{.type = LightType::kDirectional, .radiance = Eigen::Vector3f::Constant(1e5F)};
  const auto weak = project(load_lights({{.type = LightType::kDirectional}}, OnFlaw::kRefuse), 4);
  const auto strong = project(load_lights({sun}, OnFlaw::kRefuse), 4);
  const auto one = relight(transfer, weak);
  const auto many = relight(transfer, strong);
  for (std::size_t v = 0; v < one.size(); ++v) {
    ASSERT_TRUE(many[v].allFinite());
    ASSERT_LT((many[v] - 1e5F * one[v]).norm(), 1e-5F * 1e5F * 0.01F) << v;
    ASSERT_LT(many[v].cwiseAbs().maxCoeff(), 1e5F * 0.01F) << "at most albedo times irradiance, ringing included";
  }
}

TEST(ExtremeScenes, NumbersBeyondHalfStayFinite) {
  Mesh mesh = standing_box();
  turn_inside_out(mesh);
  paint(mesh, Eigen::Vector3f::Constant(0.9F));
  shine(mesh, Eigen::Vector3f::Constant(1e6F));
  const Transfer transfer = baked(mesh, &kInterreflected, 256);
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), transfer);
  const Transfer read = read_transfer(folder.file("a.transfer"));
  for (const Eigen::Vector3f& light : read.emitted) {
    ASSERT_NEAR(static_cast<double>(light.x()), 1e7, 10.0 + read.bounces.emitted_bound);
  }
  shine(mesh, Eigen::Vector3f::Constant(std::numeric_limits<float>::max()));
  const std::string said = message_of([&] { baked(mesh, &kInterreflected, 256); });
  EXPECT_NE(said.find("its light is too strong for single precision"), std::string::npos) << said;
}

TEST(ExtremeScenes, DenormalAlbedosAndLightsGiveNoNaN) {
  Mesh mesh = standing_box();
  append(mesh, floor_of(4.0F));
  paint(mesh, Eigen::Vector3f(1e-42F, 1e-38F, std::numeric_limits<float>::denorm_min()));
  shine(mesh, Eigen::Vector3f::Constant(1e-41F));
  const Transfer transfer = baked(mesh, &kInterreflected);
  expect_light(transfer);
  EXPECT_TRUE(transfer.bounces.certified);
  for (const Eigen::Vector3f& light : transfer.emitted) ASSERT_TRUE(light.allFinite());
}

}  // namespace
}  // namespace sh::prt::test
