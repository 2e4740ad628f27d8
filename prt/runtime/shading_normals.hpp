// The normal of a surface at any place: interpolated between the vertices and, where the mesh has a normal map, turned
// by the map (prt/material/normal_map.hpp) in a frame of the surface. The frame's x is the tangent along the texture
// coordinate u, a mean over the faces around each vertex, made perpendicular to the normal there; its y is
// perpendicular to both, on the side towards which v grows. So do most tools, within a few degrees [Mikkelsen08].
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/sheets.hpp"

namespace sh::prt {

class ShadingNormals {
 public:
  /// The mesh must outlive the result.
  explicit ShadingNormals(const Mesh& mesh);

  /// Unit. Where the coordinates of no face around give a direction, or texels have no length, the map does not turn it.
  [[nodiscard]] Eigen::Vector3f at(const Hit& hit) const;
  /// Of the vertices, from the faces around that show the picture, or that mirror it: unit, or zero where none does. Empty
  /// without normal maps.
  [[nodiscard]] const std::vector<Eigen::Vector3f>& tangents(bool is_mirrored) const {
    return tangents_[is_mirrored ? 1 : 0];
  }

 private:
  [[nodiscard]] Eigen::Vector3f mapped(const Hit& hit, const Eigen::Vector3f& normal, std::size_t map) const;

  const Mesh& mesh_;
  std::array<std::vector<Eigen::Vector3f>, 2> tangents_;  // (vertices) of the faces that show the picture, or mirror it
};

}  // namespace sh::prt
