// A camera for a mesh without a scene: prt/scene/default_camera.hpp.
#include "prt/scene/default_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sh::prt {

Camera default_camera(const Mesh& mesh, const PictureSize& size) {
  Eigen::Vector3f low = mesh.positions.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Camera camera;
  camera.target = 0.5F * (low + high);
  const float narrow = std::min(1.0F, static_cast<float>(size.width) / static_cast<float>(size.height));
  const float half_angle = 0.5F * camera.vertical_field_of_view * std::numbers::pi_v<float> / 180.0F * narrow;
  const float distance = 0.5F * (high - low).norm() / std::sin(half_angle);
  camera.position = camera.target + distance * Eigen::Vector3f(0.5F, -0.75F, 0.45F).normalized();
  return camera;
}

}  // namespace sh::prt
