// Bakes with bounces against a path tracer.
#include <gtest/gtest.h>

#include <cmath>

#include "prt/angles.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/study/path_render.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/reference_render.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

// A room without its front, with a red wall and a green one.
Mesh room(float longest = 0.06F) {
  Mesh mesh = primitive_mesh("box");
  refine(mesh, longest);
  turn_inside_out(mesh);
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t v) { return mesh.normals[v].y() > 0.5F; });
  });
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float x = mesh.normals[v].x();
    mesh.albedo[v] = x > 0.5F    ? Eigen::Vector3f(0.8F, 0.1F, 0.1F)
                     : x < -0.5F ? Eigen::Vector3f(0.1F, 0.7F, 0.1F)
                                 : Eigen::Vector3f::Constant(0.75F).eval();
  }
  return mesh;
}

// A square that faces `normal`, one of the axes, at distance 1/2 of the middle.
Mesh wall_facing(const Eigen::Vector3f& normal, float longest) {
  Mesh wall = primitive_mesh("plane", 24, Eigen::Translation3f(-0.5F * normal) * frame_about(normal));
  refine(wall, longest);
  return wall;
}

Mesh ball_in_corner(float longest = 0.04F, int segments = 32) {
  Mesh mesh = wall_facing(Eigen::Vector3f::UnitZ(), longest);
  append(mesh, wall_facing(Eigen::Vector3f::UnitX(), longest));
  append(mesh, wall_facing(-Eigen::Vector3f::UnitY(), longest));
  paint(mesh, {0.7F, 0.6F, 0.3F});
  Eigen::Affine3f map(Eigen::Translation3f(0.05F, -0.05F, -0.2F));
  map.scale(0.4F);
  append(mesh, primitive_mesh("sphere", segments, map));
  return mesh;
}

// Picture and mean of the paths, in units of the picture's root mean square.
// A pixel exactly on an edge would start its paths on both sides of a wall; the cameras look a little aside.
void expect_within_noise(const Mesh& mesh, const Camera& camera, const LightCoefficients& light, double discretization,
                         const TransferKind& kind = kInterreflected) {
  constexpr PictureSize kSize{48, 32, 1};
  const Tracer tracer(mesh);
  const Background sky = [&](const Eigen::Vector3f& direction) {
    return Eigen::Vector3f(radiance(light, direction.cast<double>()).cast<float>());
  };
  const PathPictures paths = path_render(mesh, tracer, sky, camera, kSize, 128);
  const Transfer transfer = baked(mesh, &kind, kind.is_glossy() ? 512 : 1024, kind.is_glossy() ? 4 : light.degree);
  const Surface surface = kind.is_glossy() ? glossy_surface(transfer, TransferredRadiance(transfer, light), mesh.albedo)
                                           : diffuse_surface(mesh, relight(transfer, light));
  const Background black = [](const Eigen::Vector3f&) { return Eigen::Vector3f::Zero().eval(); };
  const Picture baked = render(mesh, tracer, surface, camera, kSize, black, "baked");
  Picture mean = paths.first;
  for (std::size_t i = 0; i < mean.radiance.size(); ++i) {
    mean.radiance[i] = 0.5F * (paths.first.radiance[i] + paths.second.radiance[i]);
  }
  const double noise = path_noise(paths);
  const PictureDifference found = difference(baked, mean);
  ASSERT_GT(found.pixels, 700U);
  EXPECT_LT(noise, 0.08);
  EXPECT_LT(found.relative_rms, std::hypot(1.1 * noise, discretization)) << noise;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < mean.radiance.size(); ++i) {
    bias += (baked.radiance[i] - mean.radiance[i]).cast<double>();
    sum += mean.radiance[i].cast<double>();
  }
  const double per_pixel = noise / std::sqrt(static_cast<double>(found.pixels));
  EXPECT_LT(std::abs(bias.sum() / sum.sum()), 4.0 * per_pixel + 0.5 * discretization);
}

// The sky of degree 2 that shines from in front of the room.
LightCoefficients frontal_light() {
  LightCoefficients light = constant_light(2);
  for (int c = 0; c < 3; ++c) light.at(c, numeric::coefficient_index(1, -1)) = -1.5 + 0.3 * c;
  return light;
}

// Gray, for one channel. Degree 4 holds all of a lobe of exponent 3 but 1e-4.
Mesh shiny(Mesh mesh) { return polished(std::move(mesh), 0.35F, 0.5F, 3.0F); }

TEST(Paths, AgreeWithTheBakeOfAGlossyRoom) {
  const Camera camera{{0.03, -2.2, 0.05}, {0.013, 0.0, 0.007}, {0.0, 0.0, 1.0}, 34.0F};
  expect_within_noise(shiny(room(0.12F)), camera, frontal_light(), 0.03, kGlossyInterreflected);
}

TEST(Paths, AgreeWithTheBakeOfAGlossyBallInACorner) {
  const Camera camera{{1.6, -1.6, 1.0}, {-0.1, 0.1, -0.2}, {0.0, 0.0, 1.0}, 34.0F};
  expect_within_noise(shiny(ball_in_corner(0.08F, 20)), camera, frontal_light(), 0.03, kGlossyInterreflected);
}

// Degree 4 holds nearly all of a rough surface.
TEST(Paths, AgreeWithTheBakeOfBrdfs) {
  Mesh mesh = ball_in_corner(0.08F, 20);
  mesh.brdfs.number_of(microfacet_reflectance(0.9F, 0.4F));
  mesh.brdf.assign(mesh.positions.size(), 1);
  const Camera camera{{1.6, -1.6, 1.0}, {-0.1, 0.1, -0.2}, {0.0, 0.0, 1.0}, 34.0F};
  expect_within_noise(mesh, camera, frontal_light(), 0.03, kGlossyInterreflected);
}

TEST(Paths, AgreeWithTheBakeOfAColoredRoom) {
  const Camera camera{{0.03, -2.2, 0.05}, {0.013, 0.0, 0.007}, {0.0, 0.0, 1.0}, 34.0F};
  expect_within_noise(room(), camera, frontal_light(), 0.01);
}

TEST(Paths, AgreeWithTheBakeOfACurvedShapeInACorner) {
  const Camera camera{{1.6, -1.6, 1.0}, {-0.1, 0.1, -0.2}, {0.0, 0.0, 1.0}, 34.0F};
  expect_within_noise(ball_in_corner(), camera, frontal_light(), 0.01);
}

// A closed room, lit by its ceiling alone.
TEST(Paths, AgreeWithTheBakeOfALampInAClosedRoom) {
  Mesh mesh = primitive_mesh("box");
  refine(mesh, 0.06F);
  turn_inside_out(mesh);
  paint(mesh, {0.6F, 0.5F, 0.3F});
  shine(mesh, Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.normals[v].z() < -0.5F) mesh.emission[v] = {2.0F, 1.5F, 1.0F};
  }
  const Camera camera{{0.03, -0.45, 0.05}, {0.013, 0.5, 0.007}, {0.0, 0.0, 1.0}, 80.0F};
  expect_within_noise(mesh, camera, LightCoefficients::zero(2), 0.01);
}

}  // namespace
}  // namespace sh::prt::test
