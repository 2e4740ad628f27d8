// Renders a mesh with exit radiance per vertex: primary rays, barycentric interpolation, and the light as background.
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

/// The radiance that a ray in this unit direction sees if it hits nothing.
using Background = std::function<Eigen::Vector3f(const Eigen::Vector3f& direction)>;

/// `vertex_radiance` (vertices) comes from relight(). Mirrors show the surface at which their paths end. The same bits
/// for any number of threads. Progress on standard error is labeled `what`. Throws std::invalid_argument for an
/// unusable camera or size.
Picture render(const Mesh& mesh, const Tracer& tracer, const std::vector<Eigen::Vector3f>& vertex_radiance,
               const Camera& camera, const PictureSize& size, const Background& background, const std::string& what);

}  // namespace sh::prt
