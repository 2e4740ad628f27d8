#include <Eigen/Geometry>
#include <numbers>

#include "prt/mesh/primitives.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/made_scenes.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

namespace {

constexpr float kGap = 0.0005F;  // between a shape and its support, so that no faces coincide
constexpr float kEdge = 0.09F;

struct Piece {
  const char* primitive;
  Eigen::Vector3f size;
  Eigen::Vector3f foot;  // middle of its underside
  float turn_degrees;    // about z
  float tilt_degrees;    // about x, first
  Eigen::Vector3f albedo;
};

Eigen::Affine3f placing(const Piece& piece) {
  constexpr float kDegree = std::numbers::pi_v<float> / 180.0F;
  const Eigen::Matrix3f turn = (Eigen::AngleAxisf(piece.turn_degrees * kDegree, Eigen::Vector3f::UnitZ()) *
                                Eigen::AngleAxisf(piece.tilt_degrees * kDegree, Eigen::Vector3f::UnitX()))
                                   .toRotationMatrix();
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.linear() = turn * piece.size.asDiagonal();
  return map;
}

Mesh make(const Piece& piece) {
  Soup soup = make_primitive(piece.primitive, 64);
  transform(soup, placing(piece));
  float lowest = soup.positions.front().z();
  for (const Eigen::Vector3f& position : soup.positions) lowest = std::min(lowest, position.z());
  Eigen::Affine3f lift = Eigen::Affine3f::Identity();
  lift.translate(piece.foot + Eigen::Vector3f(0.0F, 0.0F, kGap - lowest));
  transform(soup, lift);
  soup.albedo.assign(soup.positions.size(), piece.albedo);
  const std::size_t vertices = soup.positions.size();
  Mesh mesh = finish_mesh(std::move(soup), vertices, 0.0F, kEdge, piece.primitive, OnFlaw::kRefuse);
  mesh.remap.clear();  // no file has these vertices
  return mesh;
}

}  // namespace

Scene make_embedded_scene() {
  const Eigen::Vector3f sandstone(0.68F, 0.56F, 0.41F);
  const Eigen::Vector3f chalk(0.74F, 0.72F, 0.68F);
  const Eigen::Vector3f slate(0.32F, 0.38F, 0.44F);
  const Eigen::Vector3f brick(0.62F, 0.24F, 0.16F);
  const Eigen::Vector3f moss(0.28F, 0.45F, 0.22F);
  const Eigen::Vector3f gold(0.78F, 0.56F, 0.18F);
  const std::vector<Piece> pieces = {{"arch", {2.2F, 0.6F, 1.9F}, {-0.7F, 0.75F, 0.0F}, -14.0F, 0.0F, sandstone},
                                     {"stairs", {1.3F, 1.0F, 0.8F}, {1.2F, 0.85F, 0.0F}, 0.0F, 0.0F, chalk},
                                     {"cylinder", {0.36F, 0.36F, 1.1F}, {0.75F, -0.55F, 0.0F}, 0.0F, 0.0F, chalk},
                                     {"sphere", {0.56F, 0.56F, 0.56F}, {0.75F, -0.55F, 1.1F + kGap}, 0.0F, 0.0F, gold},
                                     {"torus", {1.0F, 1.0F, 1.0F}, {-0.55F, -0.65F, 0.0F}, 25.0F, 0.0F, brick},
                                     {"sphere", {0.43F, 0.43F, 0.43F}, {-0.55F, -0.65F, 0.0F}, 0.0F, 0.0F, slate},
                                     {"cone", {0.5F, 0.5F, 0.75F}, {1.5F, -0.25F, 0.0F}, 0.0F, 0.0F, moss},
                                     {"box", {0.5F, 0.5F, 0.5F}, {-1.6F, -0.35F, 0.0F}, 33.0F, 0.0F, slate},
                                     {"torus", {0.5F, 0.5F, 0.5F}, {-1.6F, -0.35F, 0.5F + kGap}, 0.0F, 0.0F, moss}};
  Scene scene;
  scene.name = "demo";
  for (const Piece& piece : pieces) append(scene.mesh, make(piece));
  add_ground(scene.mesh, {0.0F, 150.0F, 0.06F, {0.58F, 0.57F, 0.54F}});
  scene.lights.emplace_back();  // the CIE overcast sky
  scene.camera = {{1.6F, -5.6F, 2.5F}, {-0.05F, 0.0F, 0.6F}, {0.0F, 0.0F, 1.0F}, 32.0F};
  return scene;
}

}  // namespace sh::prt
