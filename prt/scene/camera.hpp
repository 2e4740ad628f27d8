// Where a picture is taken from, and how large it is.
#pragma once
#include <Eigen/Core>

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

}  // namespace sh::prt
