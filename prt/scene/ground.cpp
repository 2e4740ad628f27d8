// The ground of a scene: one quadrilateral, split finely where shadows fall and coarsely far out.
#include <Eigen/Geometry>
#include <algorithm>

#include "prt/mesh/solids.hpp"
#include "prt/mesh/tessellate.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

namespace {

constexpr float kGap = 1.0F / 10000.0F;
constexpr float kWidth = 4.0F;
constexpr float kEdge = 1.0F / 50.0F;
constexpr float kGrowth = 0.25F;

Eigen::AlignedBox3f box_of(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  return box;
}

}  // namespace

Ground default_ground(const Mesh& mesh) {
  const Eigen::AlignedBox3f box = box_of(mesh);
  const float extent = box.sizes().maxCoeff();
  return {box.min().z() - kGap * extent, kWidth * extent, kEdge * extent};
}

void add_ground(Mesh& mesh, const Ground& ground) {
  const Eigen::AlignedBox3f box = box_of(mesh);
  const Eigen::Vector3f middle = box.center();
  const float half = 0.5F * ground.size;
  const auto corner = [&](float x, float y) {
    return Eigen::Vector3f(middle.x() + x * half, middle.y() + y * half, ground.height);
  };
  Soup soup;
  add_quad(soup, {corner(-1.0F, -1.0F), corner(1.0F, -1.0F), corner(1.0F, 1.0F), corner(-1.0F, 1.0F)});
  soup.albedo.assign(soup.positions.size(), ground.albedo);
  Mesh plane = weld(soup, soup.positions.size());
  plane.remap.clear();  // no file has these vertices
  const Eigen::Vector2f low = box.min().head<2>();
  const Eigen::Vector2f high = box.max().head<2>();
  tessellate(
      plane,
      [&](const Eigen::Vector3f& point) {
        const Eigen::Vector2f p = point.head<2>();
        const float distance = (p - p.cwiseMax(low).cwiseMin(high)).norm();
        return std::max(ground.max_edge, kGrowth * distance);
      },
      "ground");
  append(mesh, plane);
}

}  // namespace sh::prt
