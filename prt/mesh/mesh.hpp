// The mesh that all of prt/ uses: indexed triangles with the data that the baker needs at every vertex. World axes: z
// up, right-handed. Lengths have the unit of the scene (nothing here depends on it). Albedo is linear RGB in 0..1.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sh::prt {

using Face = std::array<std::uint32_t, 3>;

/// Triangles, counterclockwise as seen from outside. All vertex arrays have one length, except that `emission` and
/// `mirror` are empty if the whole mesh has none. `remap` has one entry for each vertex of the mesh files, in the order
/// of the scene; several vertices of a file map to one vertex here if position, normal, albedo and finish agree. It is
/// empty for a mesh made in code.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;            // unit; shading: weighs the cosine
  std::vector<Eigen::Vector3f> geometric_normals;  // unit; mean of the faces around: horizon and ray offset
  std::vector<Eigen::Vector3f> albedo;             // linear RGB, 0..1
  std::vector<Eigen::Vector3f> emission;           // linear RGB radiance, W m^-2 sr^-1, of the front
  std::vector<Eigen::Vector3f> mirror;             // linear RGB reflectance of the front, 0..1
  std::vector<Face> faces;
  std::vector<std::uint32_t> remap;  // (vertices of the files) -> vertex, kNoVertex where no face used it
};

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;

inline Eigen::AlignedBox3f bounding_box(const std::vector<Eigen::Vector3f>& positions) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : positions) box.extend(position);
  return box;
}

}  // namespace sh::prt
