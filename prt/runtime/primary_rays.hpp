// Rays from a pinhole camera through the pixels of a picture, and their hits.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/rays/tracer.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// Throws std::invalid_argument unless every number is positive and the picture at most kMaxPixels.
void require_picture_size(const PictureSize& size);

/// Unit directions through pixels, x to the right and y downwards in the picture.
class CameraFrame {
 public:
  /// Throws std::invalid_argument for a camera that looks at its own place, along its own up, or has no field of view.
  CameraFrame(const Camera& camera, const PictureSize& size);
  /// Continuous pixel coordinates; a pixel's centre is at column + 1/2, row + 1/2.
  [[nodiscard]] Eigen::Vector3f direction(float column, float row) const;

 private:
  Eigen::Vector3f forward_;
  Eigen::Vector3f right_;  // from the middle of the picture to its right edge, at distance 1
  Eigen::Vector3f down_;
  float width_;
  float height_;
};

/// One row of pixels: samples_per_pixel rays for each, pixel by pixel, at the places of a fixed low-discrepancy pattern
/// (the R2 sequence), the same in every pixel. One sample goes through the centre.
struct RowOfRays {
  std::vector<Eigen::Vector3f> directions;
  std::vector<Hit> hits;
};
void trace_row(const Tracer& tracer, const Camera& camera, const PictureSize& size, int row, RowOfRays& rays);

/// Value at a hit: (1-u-v) a + u b + v c of the face's corners.
Eigen::Vector3f interpolated(const Hit& hit, const Mesh& mesh, const std::vector<Eigen::Vector3f>& vertex_values);

}  // namespace sh::prt
