// What turns from picture to picture of a sequence.
#pragma once
#include <Eigen/Core>

#include "prt/scene/camera.hpp"

namespace sh::prt {

/// The light about +z; the camera about the vertical through its target; or everything that is seen about that
/// vertical, under a light at rest.
enum class Turntable { kNone, kLight, kCamera, kObject };

/// The camera and the rotation of the light, both in the axes of what is seen: that never moves itself.
struct View {
  Camera camera;
  Eigen::Matrix3d light_turn = Eigen::Matrix3d::Identity();
};

/// After a part of a full turn, right-handed about +z. At time 0 the camera is the given one, the light as it is.
View view_at(Turntable turntable, const Camera& camera, double time);

}  // namespace sh::prt
