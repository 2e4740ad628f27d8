// The ground of a scene, one quadrilateral that is split finely where shadows fall and coarsely far out; the scenes
// `disc` and `demo`.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/mesh/primitives.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr float kGroundGap = 1.0F / 10000.0F;
constexpr float kGroundWidth = 4.0F;
constexpr float kGroundEdge = 1.0F / 50.0F;
constexpr float kGroundGrowth = 0.25F;

constexpr Disc kDisc = {1.0F, 0.6F};
constexpr std::uint32_t kCorners = 256;

Mesh disc_mesh() {
  const double turn = 2.0 * std::numbers::pi / kCorners;
  const double corner = static_cast<double>(kDisc.radius) * std::sqrt(turn / std::sin(turn));  // equal areas
  Soup soup;
  soup.positions.emplace_back(0.0, 0.0, kDisc.height);
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    soup.positions.emplace_back(corner * std::cos(turn * k), corner * std::sin(turn * k), kDisc.height);
    soup.faces.push_back({0, 1 + k, 1 + (k + 1) % kCorners});
  }
  soup.normals.assign(soup.positions.size(), Eigen::Vector3f::UnitZ());
  soup.albedo.assign(soup.positions.size(), Eigen::Vector3f(0.62F, 0.24F, 0.16F));
  return weld(soup);
}

constexpr double kGap = 0.0005;  // between a shape and its support, so that no faces coincide
constexpr double kEdge = 0.09;

struct Piece {
  const char* primitive;
  Eigen::Vector3f size;
  Eigen::Vector3f foot;  // middle of its underside
  float turn_degrees;    // about z
  Eigen::Vector3f albedo;
};

Mesh make(const Piece& piece) {
  const float angle = piece.turn_degrees * (std::numbers::pi_v<float> / 180.0F);
  const Eigen::Quaternionf turn(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()));
  Soup soup = make_primitive(piece.primitive, 64);
  transform(soup, Eigen::Affine3d((turn.toRotationMatrix() * piece.size.asDiagonal()).cast<double>()));
  const double lowest = bounding_box(soup.positions).min().z();
  transform(soup, Eigen::Affine3d(
                      Eigen::Translation3d(piece.foot.cast<double>() + Eigen::Vector3d(0.0, 0.0, kGap - lowest))));
  soup.albedo.assign(soup.positions.size(), piece.albedo);
  return finish_mesh({.soup = std::move(soup), .max_edge = kEdge, .name = piece.primitive}, Frame(), OnFlaw::kRefuse);
}

}  // namespace

Ground default_ground(const Mesh& mesh) {
  const Eigen::AlignedBox3f box = bounding_box(mesh.positions);
  const float extent = box.sizes().maxCoeff();
  return {box.min().z() - kGroundGap * extent, kGroundWidth * extent, kGroundEdge * extent};
}

void add_ground(Mesh& mesh, const Ground& ground) {
  const Eigen::AlignedBox3f box = bounding_box(mesh.positions);
  const Eigen::Vector3f middle = box.center();
  const float half = 0.5F * ground.size;
  const auto corner = [&](float x, float y) {
    return Eigen::Vector3f(middle.x() + x * half, middle.y() + y * half, ground.height);
  };
  Soup soup;
  add_quad(soup, {corner(-1.0F, -1.0F), corner(1.0F, -1.0F), corner(1.0F, 1.0F), corner(-1.0F, 1.0F)});
  soup.albedo.assign(soup.positions.size(), ground.albedo);
  Mesh plane = weld(soup);
  const Eigen::Vector2f low = box.min().head<2>();
  const Eigen::Vector2f high = box.max().head<2>();
  tessellate(
      plane,
      [&](const Eigen::Vector3f& point) {
        const Eigen::Vector2f p = point.head<2>();
        const float distance = (p - p.cwiseMax(low).cwiseMin(high)).norm();
        return std::max(ground.max_edge, kGroundGrowth * distance);
      },
      "ground");
  append(mesh, plane);
}

Scene make_disc_scene() {
  Scene scene;
  scene.name = "disc";
  scene.mesh = disc_mesh();
  add_ground(scene.mesh, {0.0F, 40.0F, 0.07F, {0.58F, 0.57F, 0.54F}});
  scene.lights = {{.type = LightType::kCieOvercast},
                  {.type = LightType::kCap,
                   .radiance = {4.0F, 3.4F, 2.6F},
                   .direction = Eigen::Vector3d(-0.6, -0.4, 0.7).normalized(),
                   .one_minus_cos = 1.0 - std::cos(25.0 * std::numbers::pi / 180.0)}};
  scene.camera = {{2.4, -5.2, 2.6}, {0.0, 0.0, 0.2}, {0.0, 0.0, 1.0}, 34.0F};
  scene.disc = kDisc;
  return scene;
}

Scene make_embedded_scene() {
  const Eigen::Vector3f sandstone(0.68F, 0.56F, 0.41F);
  const Eigen::Vector3f chalk(0.74F, 0.72F, 0.68F);
  const Eigen::Vector3f slate(0.32F, 0.38F, 0.44F);
  const Eigen::Vector3f brick(0.62F, 0.24F, 0.16F);
  const Eigen::Vector3f moss(0.28F, 0.45F, 0.22F);
  const Eigen::Vector3f gold(0.78F, 0.56F, 0.18F);
  const std::vector<Piece> pieces = {
      {"arch", {2.2F, 0.6F, 1.9F}, {-0.7F, 0.75F, 0.0F}, -14.0F, sandstone},
      {"stairs", {1.3F, 1.0F, 0.8F}, {1.2F, 0.85F, 0.0F}, 0.0F, chalk},
      {"cylinder", {0.36F, 0.36F, 1.1F}, {0.75F, -0.55F, 0.0F}, 0.0F, chalk},
      {"sphere", {0.56F, 0.56F, 0.56F}, {0.75F, -0.55F, 1.1F + static_cast<float>(kGap)}, 0.0F, gold},
      {"torus", {1.0F, 1.0F, 1.0F}, {-0.55F, -0.65F, 0.0F}, 25.0F, brick},
      {"sphere", {0.43F, 0.43F, 0.43F}, {-0.55F, -0.65F, 0.0F}, 0.0F, slate},
      {"cone", {0.5F, 0.5F, 0.75F}, {1.5F, -0.25F, 0.0F}, 0.0F, moss},
      {"box", {0.5F, 0.5F, 0.5F}, {-1.6F, -0.35F, 0.0F}, 33.0F, slate},
      {"torus", {0.5F, 0.5F, 0.5F}, {-1.6F, -0.35F, 0.5F + static_cast<float>(kGap)}, 0.0F, moss}};
  Scene scene;
  scene.name = "demo";
  for (const Piece& piece : pieces) append(scene.mesh, make(piece));
  add_ground(scene.mesh, {0.0F, 150.0F, 0.06F, {0.58F, 0.57F, 0.54F}});
  scene.lights.emplace_back();  // the CIE overcast sky
  scene.camera = {{1.6, -5.6, 2.5}, {-0.05, 0.0, 0.6}, {0.0, 0.0, 1.0}, 32.0F};
  return scene;
}

}  // namespace sh::prt
