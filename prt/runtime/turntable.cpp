// prt/runtime/turntable.hpp
#include "prt/runtime/turntable.hpp"

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {
namespace {

/// Turned about the axis through its target.
Camera turned(const Camera& camera, const Eigen::Matrix3d& r) {
  Camera out = camera;
  const Eigen::Vector3d target = camera.target.cast<double>();
  out.position = (target + r * (camera.position.cast<double>() - target)).cast<float>();
  out.up = (r * camera.up.cast<double>()).cast<float>();
  return out;
}

}  // namespace

View view_at(Turntable turntable, const Camera& camera, double time) {
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d::UnitZ(), 360.0 * time);
  switch (turntable) {
    case Turntable::kNone:
      return {camera};
    case Turntable::kLight:
      return {camera, r};
    case Turntable::kCamera:
      return {turned(camera, r)};
    case Turntable::kObject:
      return {turned(camera, r.transpose()), r.transpose()};
  }
  return {camera};
}

}  // namespace sh::prt
