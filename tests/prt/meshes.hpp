// Small meshes made in code, and properties of meshes.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/primitives.hpp"
#include "prt/mesh/soup.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt::test {

inline Mesh primitive_mesh(std::string_view name, int segments = 24,
                           const Eigen::Affine3f& map = Eigen::Affine3f::Identity()) {
  Soup soup = make_primitive(name, segments);
  transform(soup, map.cast<double>());
  return weld(soup, soup.positions.size());
}

/// Each edge between two positions (not vertices, so that hard edges count once), with the number of faces that run
/// along it one way and the other.
using Edge = std::array<std::uint32_t, 6>;
inline std::map<Edge, std::pair<int, int>> edges_by_position(const Mesh& mesh) {
  std::map<Edge, std::pair<int, int>> edges;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = bits_of(mesh.positions[face[k]]);
      const auto b = bits_of(mesh.positions[face[(k + 1) % 3]]);
      const bool forward = a < b;
      Edge edge{};
      std::copy(b.begin(), b.end(), std::copy(a.begin(), a.end(), edge.begin()));
      if (!forward) std::rotate(edge.begin(), edge.begin() + 3, edge.end());
      ++(forward ? edges[edge].first : edges[edge].second);
    }
  }
  return edges;
}

/// Every edge has one face on each side: a closed surface without cracks, faces all turned the same way.
inline bool is_closed_surface(const Mesh& mesh) {
  const auto edges = edges_by_position(mesh);
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == std::pair(1, 1); });
}

inline float longest_edge(const Mesh& mesh) {
  float longest = 0.0F;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (mesh.positions[face[k]] - mesh.positions[face[(k + 1) % 3]]).norm());
    }
  }
  return longest;
}

/// Six times the volume, positive when the faces are counterclockwise as seen from outside.
inline double signed_volume(const Mesh& mesh) {
  double volume = 0.0;
  for (const Face& face : mesh.faces) {
    volume += mesh.positions[face[0]].cast<double>().dot(
        mesh.positions[face[1]].cast<double>().cross(mesh.positions[face[2]].cast<double>()));
  }
  return volume / 6.0;
}

}  // namespace sh::prt::test
