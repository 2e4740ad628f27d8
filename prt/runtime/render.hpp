// A picture of a mesh whose vertices have exit radiances: primary rays, barycentric interpolation, the light behind.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "prt/rays/tracer.hpp"
#include "prt/runtime/primary_rays.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// A rendered picture: linear radiance, box-filtered over the samples of a pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Eigen::Vector3f> radiance;  // (height, width), row-major, top row first
  std::vector<float> coverage;            // (height, width): the part of a pixel's samples that hit the mesh

  /// The radiance of the pixels that the mesh covers completely.
  [[nodiscard]] std::vector<Eigen::Vector3f> covered() const;
};

/// What a ray that hits nothing sees: radiance towards a unit direction.
using Background = std::function<Eigen::Vector3f(const Eigen::Vector3f& direction)>;

/// `vertex_radiance` (vertices) comes from relight(). Mirrors show what their paths end on. The same bits for any
/// number of threads. `what` is shown as progress on standard error. Throws std::invalid_argument for a camera or size
/// that cannot be used.
Picture render(const Mesh& mesh, const Tracer& tracer, const std::vector<Eigen::Vector3f>& vertex_radiance,
               const Camera& camera, const PictureSize& size, const Background& background, const std::string& what);

}  // namespace sh::prt
