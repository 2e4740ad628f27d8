// The mesh everything in prt/ works on: indexed triangles with what the baker needs at every vertex.
// World axes: z up, right-handed; unit: whatever the scene uses (nothing here depends on it). Albedo is linear RGB in
// 0..1.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sh::prt {

using Face = std::array<std::uint32_t, 3>;

/// Triangles, counter-clockwise seen from outside. The vertex arrays have one length, but that emission
/// and mirror are empty where there is none of it in the whole mesh; `remap` has one entry per
/// vertex of the files the mesh came from, in the order of the scene (vertices a file repeats for other reasons than
/// position and normal share one entry here); it is empty for a mesh made in code.
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

}  // namespace sh::prt
