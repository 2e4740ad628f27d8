// Chooses the studied vertices and their weights, and compares radiances on them.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/scene/camera.hpp"
#include "prt/study/study.hpp"

namespace sh::prt {

struct StudiedVertices {
  std::size_t step = 1;
  std::vector<std::uint32_t> index;
  std::vector<double> weight;  // sums to 1
};

/// The area of every vertex (a third of the area of its faces) over the squared distance to the camera.
std::vector<double> seen_areas(const Mesh& mesh, const Camera& camera);

/// Every step-th vertex, about `count` in total, without those for which `leave_out` is true.
StudiedVertices choose_vertices(const Mesh& mesh, const Camera& camera, std::size_t count,
                                const std::function<bool(std::uint32_t)>& leave_out);

/// Radiances of the studied vertices, in their order.
using Radiances = std::vector<Eigen::Vector3d>;

/// The unit of relative errors: the root mean square of the channels of a reference, or 1 if it is black.
double radiance_unit(const StudiedVertices& vertices, const Radiances& reference);

RadianceError radiance_error(const StudiedVertices& vertices, const Radiances& values, const Radiances& reference);

/// The errors of all vertices of the mesh. `relative` (vertices) is the largest |a - b| of a channel over
/// radiance_unit; `error` summarizes them, with seen_areas as weights. `values` and `reference` are (vertices); other
/// lengths throw std::invalid_argument.
struct VertexErrors {
  std::vector<float> relative;
  RadianceError error;
};
VertexErrors vertex_errors(const Mesh& mesh, const Camera& camera, const Radiances& values, const Radiances& reference);

}  // namespace sh::prt
