// Cameras: position, picture size, a default camera for a mesh without a scene, and turntables for sequences of
// pictures.
#pragma once
#include <Eigen/Core>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// A pinhole camera in the world; the field of view is vertical, in degrees.
struct Camera {
  Eigen::Vector3d position{4.0, -4.0, 3.0};
  Eigen::Vector3d target{0.0, 0.0, 0.0};
  Eigen::Vector3d up{0.0, 0.0, 1.0};
  float vertical_field_of_view = 40.0F;
};

/// Size of a picture and samples per pixel.
struct PictureSize {
  int width = 960;
  int height = 540;
  int samples = 16;
};

/// A camera that looks at the center of the mesh from the front (-y), right and above, at a distance at which the
/// bounding sphere fits the picture.
Camera default_camera(const Mesh& mesh, const PictureSize& size);
/// The same of a box.
Camera default_camera(const Eigen::AlignedBox3d& box, const PictureSize& size);

/// What turns in a sequence. kLight: the light, about +z. kCamera: the camera, about the vertical through its target.
/// kObject: all visible objects, about that vertical, under a light at rest.
enum class Turntable { kNone, kLight, kCamera, kObject };

/// The camera and the rotation of the light, both in the axes of the mesh; the mesh itself never moves.
struct View {
  Camera camera;
  Eigen::Matrix3d light_turn = Eigen::Matrix3d::Identity();
};

/// The view after the part `time` of a full turn, right-handed about +z. At time 0 camera and light are unchanged.
View view_at(Turntable turntable, const Camera& camera, double time);

}  // namespace sh::prt
