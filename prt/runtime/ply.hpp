// A mesh with numbers at its vertices as the bytes of a PLY file (Greg Turk, "The PLY Polygon File Format", 1994).
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// Properties of a vertex, and the function that writes their values for one vertex.
struct PlyColumns {
  std::vector<std::string> names;
  std::function<void(std::size_t vertex, float* values)> write;
};

/// The properties of one vector a vertex; the vectors must outlive them.
PlyColumns ply_columns(std::vector<std::string> names, const std::vector<Eigen::Vector3f>& vectors);

/// Little-endian; positions in the world, double where the mesh has a frame of its own, normals, then the columns.
/// Comments are lines without a line break.
std::string ply_bytes(const Mesh& mesh, const std::vector<std::string>& comments,
                      const std::vector<PlyColumns>& columns);

}  // namespace sh::prt
