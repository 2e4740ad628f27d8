#include <cmath>
#include <numbers>

#include "prt/mesh/weld.hpp"
#include "prt/scene/made_scenes.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

namespace {

constexpr Disc kDisc = {1.0F, 0.6F};
constexpr std::uint32_t kCorners = 256;

Mesh disc_mesh() {
  const double turn = 2.0 * std::numbers::pi / kCorners;
  const double corner = static_cast<double>(kDisc.radius) * std::sqrt(turn / std::sin(turn));  // equal areas
  Soup soup;
  soup.positions.emplace_back(0.0F, 0.0F, kDisc.height);
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    soup.positions.emplace_back(static_cast<float>(corner * std::cos(turn * k)),
                                static_cast<float>(corner * std::sin(turn * k)), kDisc.height);
    soup.faces.push_back({0, 1 + k, 1 + (k + 1) % kCorners});
  }
  soup.normals.assign(soup.positions.size(), Eigen::Vector3f::UnitZ());
  soup.albedo.assign(soup.positions.size(), Eigen::Vector3f(0.62F, 0.24F, 0.16F));
  Mesh mesh = weld(soup, soup.positions.size());
  mesh.remap.clear();  // no file has these vertices
  return mesh;
}

LightSpec side_light() {
  LightSpec light;
  light.type = LightType::kCap;
  light.direction = Eigen::Vector3d(-0.6, -0.4, 0.7).normalized();
  light.one_minus_cos = 1.0 - std::cos(25.0 * std::numbers::pi / 180.0);
  light.radiance = Eigen::Vector3f(4.0F, 3.4F, 2.6F);
  return light;
}

}  // namespace

Scene make_disc_scene() {
  Scene scene;
  scene.name = "disc";
  scene.mesh = disc_mesh();
  add_ground(scene.mesh, {0.0F, 40.0F, 0.07F, {0.58F, 0.57F, 0.54F}});
  scene.lights = {LightSpec(), side_light()};  // the first is the CIE overcast sky
  scene.camera = {{2.4F, -5.2F, 2.6F}, {0.0F, 0.0F, 0.2F}, {0.0F, 0.0F, 1.0F}, 34.0F};
  scene.disc = kDisc;
  return scene;
}

}  // namespace sh::prt
