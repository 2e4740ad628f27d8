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
  const Eigen::Vector3d target = camera.target.cast<double>();
  out.position = (target + r * (camera.position.cast<double>() - target)).cast<float>();
  out.up = (r * camera.up.cast<double>()).cast<float>();
  return out;
}

}  // namespace

Camera default_camera(const Mesh& mesh, const PictureSize& size) {
  const Eigen::AlignedBox3f box = bounding_box(mesh.positions);
  Camera camera;
  camera.target = box.center();
  const float narrow = std::min(1.0F, static_cast<float>(size.width) / static_cast<float>(size.height));
  const float half_angle = 0.5F * camera.vertical_field_of_view * std::numbers::pi_v<float> / 180.0F * narrow;
  const float distance = 0.5F * box.diagonal().norm() / std::sin(half_angle);
  camera.position = camera.target + distance * Eigen::Vector3f(0.5F, -0.75F, 0.45F).normalized();
  return camera;
}

View view_at(Turntable turntable, const Camera& camera, double time) {
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d::UnitZ(), 360.0 * time);
  if (turntable == Turntable::kLight) return {camera, r};
  if (turntable == Turntable::kCamera) return {turned(camera, r)};
  if (turntable == Turntable::kObject) return {turned(camera, r.transpose()), r.transpose()};
  return {camera};
}

}  // namespace sh::prt
