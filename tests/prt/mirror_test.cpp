// Mirrors inside a scene, against images: a plane mirror is a window into the same scene on its other side.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "prt/bake/bake.hpp"
#include "prt/rays/mirror_paths.hpp"
#include "prt/runtime/render.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/cosine_integral.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Mesh as_mirror(Mesh mesh, const Eigen::Vector3f& reflectance) {
  mesh.mirror.assign(mesh.positions.size(), reflectance);
  paint(mesh, Eigen::Vector3f::Zero());
  return mesh;
}

// A square in the plane x = 0 that faces +x, then moved.
Mesh wall(float size, const Eigen::Vector3f& reflectance, const Eigen::Affine3f& turn = Eigen::Affine3f::Identity()) {
  Eigen::Affine3f map(turn);
  map.rotate(Eigen::AngleAxisf(0.5F * std::numbers::pi_v<float>, Eigen::Vector3f::UnitY()));
  map.scale(size);
  return as_mirror(primitive_mesh("plane", 24, map), reflectance);
}

// Ground of x = 0 to 1, before the wall.
Mesh ground(float albedo) {
  Mesh mesh = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.5F, 0.0F, 0.0F)));
  refine(mesh, 0.4F);
  paint(mesh, Eigen::Vector3f::Constant(albedo));
  return mesh;
}

Mesh ground_before_mirror(const Eigen::Vector3f& reflectance, float albedo = 0.5F) {
  Mesh mesh = ground(albedo);
  append(mesh, wall(2e4F, reflectance));
  return mesh;
}

// The light of x < 0 is that of x > 0 once more, times the reflectance.
TEST(Mirrors, BesideAVertexShowItTheMirroredLight) {
  for (const float reflectance : {0.25F, 0.9F, 1.0F}) {
    const Mesh mesh = ground_before_mirror(Eigen::Vector3f::Constant(reflectance));
    const Transfer transfer = baked(mesh, &kShadowed, 2048, 4);
    std::vector<double> expected = transfer_before_wall(4);
    for (double& value : expected) value *= 1.0 + static_cast<double>(reflectance);
    for (std::size_t v = 0; v + 4 < mesh.positions.size(); ++v) {
      ASSERT_LT(row_error(transfer, v, expected), 4e-3) << mesh.positions[v].transpose();
    }
  }
}

TEST(Mirrors, OfAColorGiveEachChannelItsOwnTransferWithBouncesAndAreRefusedWithout) {
  const Eigen::Vector3f reflectance(1.0F, 0.5F, 0.0F);
  const Mesh mesh = ground_before_mirror(reflectance);
  const Transfer transfer = baked(mesh, &kInterreflected, 2048, 2);
  const std::vector<double> quarter = transfer_before_wall(2);
  for (std::size_t c = 0; c < 3; ++c) {
    const double part = 0.5 * (1.0 + static_cast<double>(reflectance[c]));
    for (std::size_t i = 0; i < 9; ++i) {
      ASSERT_NEAR(static_cast<double>(transfer.coefficients[c * 9 + i]), part * quarter[i], 2e-3) << c;
    }
  }
  EXPECT_EQ(
      message_of([&] { baked(mesh, &kShadowed); }),
      "test: its mirrors have colors, which shadowed transfer cannot hold; expected gray mirrors, or interreflected");
}

// What is not a mirror in a channel is diffuse there; a mirror of one channel beside the albedo of another would reflect
// up to 1.75 of the light.
TEST(Mirrors, OfAColorAreSolvedInEachChannelWithItsOwnAlbedo) {
  const Eigen::Vector3f reflectance(0.9F, 0.5F, 0.05F);
  const Eigen::Vector3f albedo(0.05F, 0.45F, 0.85F);
  Scene scene = scene_of(hollow_sphere(16, 0.7F), &kInterreflected, 512);
  scene.mesh.mirror.assign(scene.mesh.positions.size(), reflectance);
  paint(scene.mesh, albedo);
  shine(scene.mesh, {0.5F, 1.0F, 2.0F});
  testing::internal::CaptureStderr();
  const Transfer colored = bake(scene);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(said.find("did not converge"), std::string::npos) << said;
  EXPECT_LE(colored.bounces.largest * static_cast<double>(kRoot4Pi), 1.0) << "more than the light that comes in";
  EXPECT_EQ(colored.mesh.albedo, scene.mesh.albedo);
  EXPECT_EQ(colored.mesh.mirror, scene.mesh.mirror);
  EXPECT_EQ(colored.mesh.emission, scene.mesh.emission);
  for (int c = 0; c < 3; ++c) {
    Scene gray = scene;
    std::fill(gray.mesh.mirror.begin(), gray.mesh.mirror.end(), Eigen::Vector3f::Constant(reflectance[c]));
    paint(gray.mesh, Eigen::Vector3f::Constant(albedo[c]));
    const Transfer alone = bake(gray);
    for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
      for (std::size_t i = 0; i < 9; ++i) {
        const std::size_t at = static_cast<std::size_t>(c) * 9 + i;
        ASSERT_NEAR(colored.row(v)[at], alone.row(v)[at], 1e-4F) << "channel " << c << ", vertex " << v;
      }
      ASSERT_NEAR(colored.emitted[v][c], alone.emitted[v][c], 1e-3F) << "channel " << c << ", vertex " << v;
    }
  }
}

// A lamp before a perfect mirror is two lamps, and the ground before it a ground twice as wide.
TEST(Mirrors, ShowALampToTheGroundAsASecondLamp) {
  const auto lamp = [](float x) {
    Mesh mesh = primitive_mesh("sphere", 48, Eigen::Translation3f(x, 0.1F, 0.8F) * Eigen::Scaling(0.6F));
    paint(mesh, Eigen::Vector3f::Zero());
    shine(mesh, {5.0F, 1.0F, 0.0F});
    return mesh;
  };
  Mesh mirrored = ground_before_mirror(Eigen::Vector3f::Ones());
  const std::size_t vertices = mirrored.positions.size() - 4;
  append(mirrored, lamp(0.6F));
  Mesh twice = ground(0.5F);
  append(twice, lamp(0.6F));
  append(twice, lamp(-0.6F));
  const Transfer image = baked(mirrored, &kInterreflected, 16384, 1);
  const Transfer plain = baked(twice, &kInterreflected, 16384, 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_GT(plain.emitted[v].x(), 0.1F);
    EXPECT_NEAR(image.emitted[v].x(), plain.emitted[v].x(), 0.01F * plain.emitted[v].x())
        << mirrored.positions[v].transpose();
    EXPECT_NEAR(image.emitted[v].y(), 0.2F * image.emitted[v].x(), 1e-5F);
  }
}

// Four mirrors around a floor: every path finally reaches the sky.
TEST(Mirrors, AroundAFloorShowItTheWholeSky) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.3F);
  const std::size_t floor = mesh.positions.size();
  for (int k = 0; k < 4; ++k) {
    Eigen::Affine3f map(
        Eigen::AngleAxisf(0.5F * std::numbers::pi_v<float> * static_cast<float>(k), Eigen::Vector3f::UnitZ()));
    map.translate(Eigen::Vector3f(-0.5F, 0.0F, 0.0F));
    append(mesh, wall(1.0F, Eigen::Vector3f::Ones(), map));
  }
  testing::internal::CaptureStderr();
  const Transfer transfer = baked(mesh, &kShadowed);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(said.find("warning"), std::string::npos) << said;
  for (std::size_t v = 0; v < floor; ++v) {
    EXPECT_NEAR(transfer.coefficients[v * 9] * kRoot4Pi, 1.0F, 2e-3F) << mesh.positions[v].transpose();
  }
  EXPECT_LT(baked(mesh, &kInterreflected, 1024, 0).bounces.between_vertices, 0.01) << "between vertices, too";
}

// Nothing leaves a closed room of mirrors, and no path in it ends by itself.
TEST(Mirrors, AllAroundAreCutAndReported) {
  Mesh room = as_mirror(hollow_sphere(12), Eigen::Vector3f::Constant(1.0F));
  append(room, primitive_mesh("box"));
  const std::size_t box = room.positions.size() - 24;
  testing::internal::CaptureStderr();
  const Transfer transfer = baked(room, &kInterreflected, 64);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("warning: test: paths were cut after 64 mirrors: up to "), std::string::npos) << said;
  for (const float value : transfer.coefficients) {
    EXPECT_EQ(value, 0.0F);
  }
  std::fill_n(room.mirror.begin(), box, Eigen::Vector3f::Constant(0.8F));  // these lose all of it before
  testing::internal::CaptureStderr();
  baked(room, &kInterreflected, 64);
  EXPECT_EQ(testing::internal::GetCapturedStderr().find("cut"), std::string::npos);
}

// A furnace: in light that is the same from everywhere a perfect mirror cannot be seen.
TEST(Mirrors, OfAnyShapeCannotBeSeenInAFurnace) {
  for (const float albedo : {0.3F, 0.9F}) {
    Mesh mesh = hollow_sphere(24);
    paint(mesh, Eigen::Vector3f::Constant(albedo));
    shine(mesh, Eigen::Vector3f::Ones());
    const std::size_t room = mesh.positions.size();
    append(mesh, as_mirror(primitive_mesh("torus", 32), Eigen::Vector3f::Ones()));
    const Transfer transfer = baked(mesh, &kInterreflected);
    for (std::size_t v = 0; v < room; ++v) {
      ASSERT_NEAR(transfer.emitted[v].x(), 1.0F / (1.0F - albedo), 2e-3F / (1.0F - albedo)) << albedo;
    }
  }
}

TEST(Mirrors, FromBehindAreBlack) {
  Mesh mesh = ground(0.5F);
  Mesh back = wall(2e4F, Eigen::Vector3f::Ones());
  for (Face& face : back.faces) std::swap(face[1], face[2]);
  append(mesh, back);
  Mesh black = mesh;
  black.mirror.clear();
  EXPECT_EQ(baked(mesh, &kShadowed).coefficients, baked(black, &kShadowed).coefficients);
}

TEST(Mirrors, GiveTheSameBitsForAnyNumberOfThreadsAndAnyMemory) {
  Mesh mesh = ground_before_mirror(Eigen::Vector3f::Constant(0.7F));
  append(mesh, as_mirror(primitive_mesh("torus", 16), Eigen::Vector3f::Constant(0.9F)));
  const Scene scene = scene_of(mesh, &kInterreflected);
  const Transfer one = bake({scene, {1, "", OnFlaw::kMend}});
  for (const std::size_t memory : {SIZE_MAX, std::size_t{0}}) {
    EXPECT_EQ(bake({scene, {3, "", OnFlaw::kMend, memory}}).coefficients, one.coefficients) << memory;
  }
}

TEST(Mirrors, AreKeptInTheFile) {
  const Transfer written = baked(ground_before_mirror(Eigen::Vector3f::Constant(0.7F)), &kShadowed, 64);
  const TemporaryFolder folder;
  write_transfer(folder.file("a.prt"), written);
  EXPECT_EQ(read_transfer(folder.file("a.prt")).mesh.mirror, written.mesh.mirror);
}

// The camera looks at the wall from +x; where it is one of two walls in a corner, light comes back after both.
TEST(Mirrors, ShowThePictureWhatTheirPathsEndOn) {
  Mesh mesh = wall(100.0F, {1.0F, 0.5F, 0.25F});
  const Camera camera{{3.0, 0.0, 0.0}, {0.0, 0.3, 0.2}, {0.0, 0.0, 1.0}, 20.0F};
  const PictureSize size{8, 8, 1};
  const Background direction_itself = [](const Eigen::Vector3f& direction) { return direction; };
  const auto picture_of = [&](const Mesh& scene) {
    const Tracer tracer(scene);
    const std::vector<Eigen::Vector3f> own(scene.positions.size(), Eigen::Vector3f::Constant(0.125F));
    return render(scene, tracer, diffuse_surface(scene, own), camera, size, direction_itself, "mirror");
  };
  Mesh none = mesh;
  none.mirror.clear();
  const Picture plain = picture_of(none);
  const Picture picture = picture_of(mesh);
  const CameraFrame frame(camera, size);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      Eigen::Vector3f d = frame.direction(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
      d.x() *= -1.0F;
      const std::size_t pixel = static_cast<std::size_t>(row) * 8 + static_cast<std::size_t>(column);
      const Eigen::Vector3f expected =
          Eigen::Vector3f::Constant(0.125F) + Eigen::Vector3f(1.0F, 0.5F, 0.25F).cwiseProduct(d);
      EXPECT_LT((picture.radiance[pixel] - expected).norm(), 1e-5F);
      EXPECT_LT((plain.radiance[pixel] - Eigen::Vector3f::Constant(0.125F)).norm(), 1e-6F);
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
