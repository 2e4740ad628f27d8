// Renders a mesh whose exit radiance is known: rays from a pinhole camera, mirrors, and the light as background.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "prt/rays/tracer.hpp"
#include "prt/runtime/surface_colors.hpp"
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
  /// Those of one row of a picture of that size, pixel by pixel. Every pixel has the same number of rays, at the points of
  /// one fixed low-discrepancy pattern (the R2 sequence). A single sample goes through the center.
  [[nodiscard]] std::vector<Eigen::Vector3f> directions(int row, const PictureSize& size) const;

 private:
  Eigen::Vector3f forward_;
  Eigen::Vector3f right_;  // from the middle of the picture to its right edge, at distance 1
  Eigen::Vector3f down_;
  float width_;
  float height_;
};

/// The rays of one row of pixels.
struct RowOfRays {
  std::vector<Eigen::Vector3f> directions;
  std::vector<Hit> hits;
};
void trace_row(const Tracer& tracer, const Camera& camera, const PictureSize& size, int row, RowOfRays& rays);

/// A rendered picture: linear radiance, box-filtered over the samples of a pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Eigen::Vector3f> radiance;  // (height, width), row-major, top row first
  std::vector<float> coverage;            // (height, width): the part of a pixel's samples that hit the mesh

  /// The radiance of the pixels that are covered by no less than this part.
  [[nodiscard]] std::vector<Eigen::Vector3f> covered(float least = 1.0F) const;
};

/// The radiance that a ray in this unit direction sees if it hits nothing.
using Background = std::function<Eigen::Vector3f(const Eigen::Vector3f& direction)>;

/// What a ray gets on its way through a medium.
struct Marched {
  Eigen::Vector3f radiance = Eigen::Vector3f::Zero();  // of the medium
  float transmittance = 1.0F;                          // of the light behind
};

/// The same of a ray from the eye in a unit direction to a distance in the world.
using Veil = std::function<Marched(const Eigen::Vector3f& direction, double distance)>;

/// The radiance that leaves a surface at a hit, against the direction of the ray.
using Surface = std::function<Eigen::Vector3f(const Hit& hit, const Eigen::Vector3f& direction)>;

/// Interpolates exit radiance between the receivers of a mesh; `radiance` (vertices) comes from relight(), and `emitted`
/// (vertices, or empty) is the part of it that the surfaces emit. Where `colors` has pictures, the light is interpolated
/// and meets the albedo of the picture. The mesh must outlive the result.
Surface diffuse_surface(const Mesh& mesh, std::vector<Eigen::Vector3f> radiance,
                        const std::vector<Eigen::Vector3f>& emitted, SurfaceColors colors);
/// The same without pictures.
Surface diffuse_surface(const Mesh& mesh, std::vector<Eigen::Vector3f> radiance);

/// Mirrors show the surface at which their paths end. veil: empty, or media before the surfaces that the eye sees, which
/// mirrors do not show. The same bits for any number of threads. Progress on standard error is labeled `what`. Throws
/// std::invalid_argument for an unusable camera or size.
Picture render(const Mesh& mesh, const Tracer& tracer, const Surface& surface, const Camera& camera,
               const PictureSize& size, const Background& background, const std::string& what, const Veil& veil = {});

}  // namespace sh::prt
