// The choice of the studied vertices, their weights, and the differences of radiances on them.
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

/// Area of every vertex, a third of its faces', over the squared distance to the camera.
std::vector<double> seen_areas(const Mesh& mesh, const Camera& camera);

/// Every step-th vertex, about `count` of them, but those for which `leave_out` says so.
StudiedVertices choose_vertices(const Mesh& mesh, const Camera& camera, std::size_t count,
                                const std::function<bool(std::uint32_t)>& leave_out);

/// Radiances of the studied vertices, in their order.
using Radiances = std::vector<Eigen::Vector3d>;

/// Root mean square of the channels of a reference, what errors are relative to; 1 where it is black.
double radiance_unit(const StudiedVertices& vertices, const Radiances& reference);

RadianceError radiance_error(const StudiedVertices& vertices, const Radiances& values, const Radiances& reference);

/// (vertices of the mesh): the largest |a - b| of a channel over radiance_unit, and all of it in numbers, vertices
/// weighing what the camera sees of them. Both (vertices). Throws std::invalid_argument for other lengths.
struct VertexErrors {
  std::vector<float> relative;
  RadianceError error;
};
VertexErrors vertex_errors(const Mesh& mesh, const Camera& camera, const Radiances& values, const Radiances& reference);

}  // namespace sh::prt
