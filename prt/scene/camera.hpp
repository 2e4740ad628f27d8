// Cameras: the place of a picture, its size, a default for a mesh without a scene, and turns from picture to picture of
// a sequence.
#pragma once
#include <Eigen/Core>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// A pinhole camera; the field of view is vertical, in degrees.
struct Camera {
  Eigen::Vector3f position{4.0F, -4.0F, 3.0F};
  Eigen::Vector3f target{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f up{0.0F, 0.0F, 1.0F};
  float vertical_field_of_view = 40.0F;
};

/// Size of a picture and samples per pixel.
struct PictureSize {
  int width = 960;
  int height = 540;
  int samples = 16;
};

/// Looks at the middle of the mesh from the front (-y), right and above, from where its bounding sphere fits the
/// picture.
Camera default_camera(const Mesh& mesh, const PictureSize& size);

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
