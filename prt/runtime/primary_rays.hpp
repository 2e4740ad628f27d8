// Rays from a pinhole camera through the pixels of a picture, and their hits.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/rays/tracer.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// Throws std::invalid_argument unless every number is positive and the picture at most kMaxPixels.
void require_picture_size(const PictureSize& size);

/// Unit directions through pixels; x points to the right and y downwards in the picture.
class CameraFrame {
 public:
  /// Throws std::invalid_argument for a camera whose target is its position, that looks along its up vector, or that
  /// has no field of view.
  CameraFrame(const Camera& camera, const PictureSize& size);
  /// Continuous pixel coordinates; the center of a pixel is at column + 1/2, row + 1/2.
  [[nodiscard]] Eigen::Vector3f direction(float column, float row) const;

 private:
  Eigen::Vector3f forward_;
  Eigen::Vector3f right_;  // from the middle of the picture to its right edge, at distance 1
  Eigen::Vector3f down_;
  float width_;
  float height_;
};

/// The rays of one row of pixels, pixel by pixel. Every pixel has the same number of rays, at the points of one fixed
/// low-discrepancy pattern (the R2 sequence). A single sample goes through the center.
struct RowOfRays {
  std::vector<Eigen::Vector3f> directions;
  std::vector<Hit> hits;
};
void trace_row(const Tracer& tracer, const Camera& camera, const PictureSize& size, int row, RowOfRays& rays);

/// The value at a hit: (1-u-v) a + u b + v c, where a, b, c are the values at the corners of the face.
Eigen::Vector3f interpolated(const Hit& hit, const Mesh& mesh, const std::vector<Eigen::Vector3f>& vertex_values);

}  // namespace sh::prt
