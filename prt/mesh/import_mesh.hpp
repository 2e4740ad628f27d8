// Mesh files through assimp: OBJ, PLY, STL, glTF, Collada, 3DS, FBX, Quick3D and what else it reads.
// Every instance of every mesh lands in one Soup, node transforms applied, triangulated; points and lines are dropped.
#pragma once
#include <string>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

enum class UpAxis { kY, kZ };

/// A file as it is read: in its own axes, unchecked but for what the importer needs.
struct ImportedMesh {
  Soup soup;
  UpAxis up = UpAxis::kZ;         // the file's, or the custom of its format: STL and PLY z, all others y
  std::size_t file_vertices = 0;  // soup.source counts these
};

/// Albedo: glTF base colour factor (linear), else the material's diffuse colour (sRGB, decoded), times the vertex
/// colour; `default_albedo` for meshes without a material. Textures are not read. Throws std::runtime_error, one line
/// that begins with the path, for a file that is missing, of no known format, damaged, or whose faces name missing
/// vertices.
ImportedMesh import_mesh(const std::string& path, const Eigen::Vector3f& default_albedo);

}  // namespace sh::prt
