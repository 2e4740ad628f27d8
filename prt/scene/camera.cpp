#include "prt/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

namespace {

/// The camera, turned about the vertical axis through its target.
Camera turned(const Camera& camera, const Eigen::Matrix3d& r) {
  Camera out = camera;
  out.position = camera.target + r * (camera.position - camera.target);
  out.up = r * camera.up;
  return out;
}

/// A camera that looks at the middle of a box with this diagonal, in this unit, which fits the picture.
Camera camera_at(const Eigen::Vector3d& middle, float diagonal, double unit, const PictureSize& size) {
  Camera camera;
  camera.target = middle;
  const float narrow = std::min(1.0F, static_cast<float>(size.width) / static_cast<float>(size.height));
  const float half_angle = 0.5F * camera.vertical_field_of_view * std::numbers::pi_v<float> / 180.0F * narrow;
  const auto distance = static_cast<double>(0.5F * diagonal / std::sin(half_angle)) * unit;
  camera.position = camera.target + distance * Eigen::Vector3d(0.5, -0.75, 0.45).normalized();
  return camera;
}

}  // namespace

Camera default_camera(const Mesh& mesh, const PictureSize& size) {
  const Eigen::AlignedBox3f box = bounding_box(mesh.positions);
  return camera_at(mesh.frame.world(box.center()), box.diagonal().norm(), mesh.frame.unit, size);
}

Camera default_camera(const Eigen::AlignedBox3d& box, const PictureSize& size) {
  return camera_at(box.center(), 1.0F, box.diagonal().norm(), size);
}

View view_at(Turntable turntable, const Camera& camera, double time) {
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d::UnitZ(), 360.0 * time);
  if (turntable == Turntable::kLight) return {camera, r};
  if (turntable == Turntable::kCamera) return {turned(camera, r)};
  if (turntable == Turntable::kObject) return {turned(camera, r.transpose()), r.transpose()};
  return {camera};
}

}  // namespace sh::prt
