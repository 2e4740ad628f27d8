// The mesh that all of prt/ uses: indexed triangles with the data that the baker needs at every vertex. World axes: z
// up, right-handed. Positions are in the mesh's frame, which for ordinary meshes is the world. Albedo is linear RGB in
// 0..1.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/material/lobe.hpp"
#include "prt/material/normal_map.hpp"
#include "prt/material/pictures.hpp"
#include "prt/material/reflectance.hpp"
#include "prt/material/translucence.hpp"
#include "prt/mesh/atlas.hpp"
#include "prt/mesh/frame.hpp"
#include "prt/mesh/halving.hpp"
#include "prt/mesh/node.hpp"

namespace sh::prt {

using Face = std::array<std::uint32_t, 3>;

/// Triangles, counterclockwise as seen from outside. All vertex arrays have one length, except that `emission`, `mirror`,
/// `specular` with `exponent`, `brdf`, `normal_map`, `albedo_map` with `tint`, `texture`, `translucence`, and `chart` with
/// `atlas`, are empty if the whole mesh has none. Vertices without faces are texels of an atlas.
/// `remap` has one entry for each vertex of the mesh files, in the order of the scene; several vertices of a file map
/// to one vertex here if position, normal, albedo and finish agree. It is empty for a mesh made in code. Code that moves, sorts,
/// turns or adds vertices or faces empties `halving`, by which rays are traced.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;          // in `frame`
  std::vector<Eigen::Vector3f> normals;            // unit; shading: weighs the cosine
  std::vector<Eigen::Vector3f> geometric_normals;  // unit; mean of the faces around: horizon and ray offset
  std::vector<Eigen::Vector3f> albedo;             // linear RGB, 0..1
  std::vector<Eigen::Vector3f> emission;           // linear RGB radiance, W m^-2 sr^-1, of the front
  std::vector<Eigen::Vector3f> mirror;             // linear RGB reflectance of the front, 0..1
  std::vector<Eigen::Vector3f> specular;           // linear RGB reflectance of the glossy lobe of the front, 0..1
  std::vector<float> exponent;                     // of this lobe [Phong75], 0..kMaxExponent
  std::vector<std::uint16_t> brdf;                 // 1 + number in `brdfs`: in place of the lobe and of diffuse
                                                   // reflection for glossy transfer; 0: none
  std::vector<Eigen::Vector2f> texture;            // coordinates (prt/material/normal_map.hpp)
  std::vector<std::uint16_t> normal_map;           // 1 + number in `normal_maps`, for glossy transfer; 0: none
  std::vector<std::uint16_t> albedo_map;           // 1 + number in `albedo_maps`; 0: none. `albedo` is then a mean
                                                   // of the picture around the vertex
  std::vector<Eigen::Vector3f> tint;               // linear RGB: the albedo of a place is this times the picture there
  std::vector<std::uint16_t> translucence;         // 1 + number in `translucences`, a face has one; 0: opaque
  std::vector<Eigen::Vector2f> chart;              // place in an atlas
  std::vector<std::uint16_t> atlas;                // 1 + number in `atlases`; 0: none
  std::vector<Face> faces;
  std::vector<std::uint32_t> remap;  // (vertices of the files) -> vertex, kNoVertex where no face used it
  Reflectances brdfs;
  NormalMaps normal_maps;
  Pictures albedo_maps;
  Translucences translucences;  // not in files
  Atlases atlases;
  std::vector<MeshNode> nodes;  // of the files and primitives; faces made in code, such as the ground, belong to none
  Halving halving;              // empty if no face was halved; not in files
  std::vector<float> reach;  // (vertices) reaches() of the mesh from which vertices were left out, else empty; not in
                             // files
  Frame frame;

  /// A vertex in the world, in the unit of the scene.
  [[nodiscard]] Eigen::Vector3d point(std::size_t vertex) const { return frame.world(positions[vertex]); }

  /// The BRDF of a vertex, or none.
  [[nodiscard]] BrdfTable brdf_of(std::size_t vertex) const {
    return brdf.empty() || brdf[vertex] == 0 ? BrdfTable() : brdfs.table(brdf[vertex] - std::size_t{1});
  }
};

/// Calls `visit` with every array that has an entry for each vertex, or is empty. `AnyMesh` is Mesh, const or not.
template <class AnyMesh, class Visit>
void visit_vertex_arrays(AnyMesh& mesh, const Visit& visit) {
  for (auto* vectors : {&mesh.positions, &mesh.normals, &mesh.geometric_normals, &mesh.albedo, &mesh.emission,
                        &mesh.mirror, &mesh.specular, &mesh.tint}) {
    visit(*vectors);
  }
  visit(mesh.exponent);
  for (auto* numbers : {&mesh.brdf, &mesh.normal_map, &mesh.albedo_map, &mesh.translucence, &mesh.atlas})
    visit(*numbers);
  for (auto* places : {&mesh.texture, &mesh.chart}) visit(*places);
}

template <class Scalar>
Eigen::AlignedBox<Scalar, 3> bounding_box(const std::vector<Eigen::Matrix<Scalar, 3, 1>>& positions) {
  Eigen::AlignedBox<Scalar, 3> box;
  for (const Eigen::Matrix<Scalar, 3, 1>& position : positions) box.extend(position);
  return box;
}

/// Leaves out what only glossy transfer shows: BRDFs, in whose place the albedo remains, and normal maps.
inline void leave_out_gloss(Mesh& mesh) {
  mesh.brdf.clear();
  mesh.brdfs = {};
  if (mesh.albedo_map.empty()) mesh.texture.clear();
  mesh.normal_map.clear();
  mesh.normal_maps = {};
}

/// The reach of the mesh around each vertex, by which ray starts and near hits are measured: the mean distance to the centers
/// of its faces, 0 without faces; Mesh::reach if there is one.
std::vector<float> reaches(const Mesh& mesh);

/// All vertices in the world.
std::vector<Eigen::Vector3d> points_of(const Mesh& mesh);

/// Puts the vertices at these points of the world, in the frame around them. Throws like frame_around.
void place(Mesh& mesh, const std::vector<Eigen::Vector3d>& points, const std::string& name);

}  // namespace sh::prt
