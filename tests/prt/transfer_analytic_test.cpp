// Baked transfer with known results, and with the worst input.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "prt/bake/bake.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

void move(Mesh& mesh, float scale, const Eigen::Vector3f& by = Eigen::Vector3f::Zero()) {
  for (Eigen::Vector3f& position : mesh.positions) position = scale * position + by;
}

// White surfaces under an even light: all reflected light is as bright as the sky, for any shape.
TEST(WhiteFurnace, ShowsSolidsAsBrightAsTheSky) {
  for (const std::string_view name : {"sphere", "torus", "stairs", "arch"}) {
    Mesh mesh = with_one_normal(name);
    paint(mesh, Eigen::Vector3f::Ones());
    Scene scene = scene_of(mesh, &kInterreflected);
    scene.bake.bounces.tolerance = 1e-6;
    const Transfer transfer = bake(scene);
    float worst = 0.0F;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_LE(transfer.coefficients[v * 27] * kRoot4Pi, 1.0F + 1e-5F);
      worst = std::max(worst, 1.0F - transfer.coefficients[v * 27] * kRoot4Pi);
    }
    EXPECT_LT(worst, 2e-3F) << name;
  }
}

// A hole that is the part a of the sphere: B = E + albedo (1 - a) B inside; and a plate before the hole, d above its
// rim of radius r, sees B through the part r^2 / (r^2 + d^2) of its cosine.
TEST(Emission, LeavesASphereThroughAHole) {
  Mesh mesh = hollow_sphere(48, 0.93F);
  const float rim = rim_of(mesh);
  const double a = 0.5 * (1.0 - static_cast<double>(rim));
  const double r2 = 1.0 - static_cast<double>(rim * rim);
  shine(mesh, Eigen::Vector3f::Ones());
  const std::size_t plate = mesh.positions.size();
  Mesh speck = primitive_mesh("plane", 24, Eigen::Translation3f(0.0F, 0.0F, rim + 0.3F) * Eigen::Scaling(1e-3F));
  turn_inside_out(speck);
  append(mesh, speck);
  for (const float albedo : {0.0F, 0.5F, 0.95F}) {
    paint(mesh, Eigen::Vector3f::Constant(albedo));
    std::fill(mesh.albedo.begin() + static_cast<std::ptrdiff_t>(plate), mesh.albedo.end(), Eigen::Vector3f::Ones());
    const Transfer transfer = baked(mesh, &kInterreflected, 4096, 0);
    const double inside = 1.0 / (1.0 - static_cast<double>(albedo) * (1.0 - a));
    double mean = 0.0;
    double count = 0.0;
    for (std::size_t v = 0; v < plate; ++v) {
      if (mesh.positions[v].z() < rim) {
        mean += static_cast<double>(transfer.emitted[v].x());
        count += 1.0;
      }
    }
    EXPECT_NEAR(mean / count, inside, 0.01 * inside) << albedo;
    for (std::size_t v = plate; v < mesh.positions.size(); ++v) {
      const double through = inside * r2 / (r2 + 0.09);
      EXPECT_NEAR(static_cast<double>(transfer.emitted[v].x()), through, 0.02 * through) << albedo;
    }
  }
}

TEST(Emission, ReturnsNoMoreThanTheSurfacesSendOut) {
  Mesh mesh = with_one_normal("stairs");
  append(mesh, with_one_normal("torus"));
  paint(mesh, Eigen::Vector3f(0.2F, 0.9F, 1.0F));
  shine(mesh, Eigen::Vector3f::Ones());
  const Transfer transfer = baked(mesh, &kInterreflected);
  for (const Eigen::Vector3f& emitted : transfer.emitted) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const float albedo = mesh.albedo[0][c];
      EXPECT_GE(emitted[c], 1.0F);
      EXPECT_LE(emitted[c], albedo < 1.0F ? 1.0F / (1.0F - albedo) * (1.0F + 1e-5F) : 1e3F);
    }
  }
}

// Turning the light is turning the object the other way.
TEST(Rotation, OfTheLightEqualsThatOfTheObject) {
  Mesh mesh = primitive_mesh("stairs");
  append(mesh, primitive_mesh("torus"));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.7).normalized()).toRotationMatrix();
  Mesh turned_mesh = mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    turned_mesh.positions[v] = turn.cast<float>() * mesh.positions[v];
    turned_mesh.normals[v] = turn.cast<float>() * mesh.normals[v];
    turned_mesh.geometric_normals[v] = turn.cast<float>() * mesh.geometric_normals[v];
  }
  const LightCoefficients light = random_light(4, 5);
  const LightCoefficients turned_light = turned(light, turn);
  const auto difference = [&](const TransferKind* kind) {
    const std::vector<Eigen::Vector3f> a = relight(baked(mesh, kind, 4096, 4), light);
    const std::vector<Eigen::Vector3f> b = relight(baked(turned_mesh, kind, 4096, 4), turned_light);
    double squares = 0.0;
    double all = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      squares += (a[v] - b[v]).cast<double>().squaredNorm();
      all += a[v].cast<double>().squaredNorm();
    }
    return std::sqrt(squares / all);
  };
  EXPECT_LT(difference(&kUnshadowed), 1e-6);
  EXPECT_LT(difference(&kShadowed), 0.01);
  EXPECT_LT(difference(&kInterreflected), 0.01);
}

// Lengths have no unit: powers of two change no bit, and a ray never meets the faces that it starts from.
TEST(Extremes, MeshesOfAnySizeHaveTheSameTransfer) {
  Mesh mesh = primitive_mesh("stairs");
  append(mesh, primitive_mesh("torus", 16));
  const Transfer one = baked(mesh, &kInterreflected, 256);
  for (const float scale : {0x1p-20F, 0x1p20F, 1e-6F, 1e6F}) {
    Mesh other = mesh;
    move(other, scale);
    EXPECT_LT(rms_difference(baked(other, &kInterreflected, 256), one), 1e-3) << scale;
  }
}

TEST(Extremes, SolidsOfAnySizeDoNotHitThemselves) {
  for (const std::string_view name : {"sphere", "box", "cone"}) {
    for (const float scale : {1e-6F, 1.0F, 1e6F}) {
      Mesh mesh = with_one_normal(name, 48);
      move(mesh, scale);
      EXPECT_EQ(baked(mesh, &kShadowed).coefficients, baked(mesh, &kUnshadowed).coefficients)
          << name << " of size " << scale;
    }
  }
}

TEST(Extremes, SolidsFarFromTheOriginKeepNearlyAllOfTheirLight) {
  Mesh mesh = with_one_normal("sphere", 48);
  move(mesh, 1.0F, {1e4F, -1e4F, 1e4F});  // coordinates are rounded to 1/1000 of its size
  const Transfer transfer = baked(mesh, &kShadowed);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_GT(transfer.coefficients[v * 9] * kRoot4Pi, 0.95F);
  }
}

TEST(Extremes, DuplicateFacesAndFacesWithoutAreaChangeNoBit) {
  Mesh mesh = primitive_mesh("stairs");
  const Transfer once = baked(mesh, &kShadowed);
  const std::vector<Face> faces = mesh.faces;
  mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({2, 2, 2});
  EXPECT_EQ(baked(mesh, &kShadowed).coefficients, once.coefficients);
  const Transfer bounced = baked(mesh, &kInterreflected);
  EXPECT_TRUE(bounced.bounces.certified);
}

TEST(Extremes, CoplanarFacesShadowEachOtherNot) {
  Mesh mesh = primitive_mesh("plane");
  Mesh small = primitive_mesh("plane");
  move(small, 0.25F, {0.1F, 0.05F, 0.0F});
  append(mesh, small);
  append(mesh, small);
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Transfer transfer = baked(mesh, kind);
    const std::vector<float> open = baked(mesh, &kUnshadowed).coefficients;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const float gain = kind == &kShadowed ? 1.0F : 0.5F;
      EXPECT_EQ(transfer.coefficients[v * transfer.shape.length()], gain * open[v * 9]);
    }
  }
}

// A box without thickness: not a ray gets in, and outside it is a solid.
TEST(Extremes, ThinWallsLetNoLightThrough) {
  Mesh mesh = with_one_normal("box");
  const std::size_t outside = mesh.positions.size();
  add_backs(mesh, std::vector<std::uint8_t>(mesh.faces.size(), 1));
  const std::vector<float> open = baked(mesh, &kUnshadowed).coefficients;
  const Transfer shadowed = baked(mesh, &kShadowed);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(shadowed.coefficients[v * 9], v < outside ? open[v * 9] : 0.0F);
  }
  shine(mesh, Eigen::Vector3f::Zero());
  std::fill(mesh.emission.begin() + static_cast<std::ptrdiff_t>(outside), mesh.emission.end(),
            Eigen::Vector3f::Constant(3.0F));
  const Transfer lit = baked(mesh, &kInterreflected);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(lit.emitted[v].x(), v < outside ? 0.0F : 6.0F, 1e-3F) << "albedo 1/2";
  }
}

TEST(Extremes, AMeshTurnedInsideOutIsDarkAndReported) {
  Mesh mesh = with_one_normal("torus");
  turn_inside_out(mesh);
  testing::internal::CaptureStderr();
  baked(mesh, &kShadowed);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("see no sky and nothing shines"), std::string::npos) << said;
}

TEST(Extremes, ASingleTriangleSeesTheSkyAndAnEmptyMeshIsRefused) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
  mesh.albedo.assign(3, Eigen::Vector3f::Ones());
  mesh.faces = {{0, 1, 2}};
  set_geometric_normals(mesh);
  const Transfer transfer = baked(mesh, &kInterreflected);
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_NEAR(transfer.coefficients[v * 27] * kRoot4Pi, 1.0F, 1e-6F);
  }
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    EXPECT_EQ(message_of([&] { baked(Mesh(), kind); }), "test: the mesh has no faces, expected at least one triangle");
  }
}

}  // namespace
}  // namespace sh::prt::test
