// Mesh files through assimp: OBJ, PLY, STL, glTF, Collada, 3DS, FBX, Quick3D and what else it reads.
// Every instance of every mesh lands in one Soup, node transforms applied, triangulated; points and lines are dropped.
#pragma once
#include <string>
#include <vector>

#include "prt/mesh/material.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

inline constexpr float kDefaultAlbedo = 0.5F;

enum class UpAxis { kY, kZ };

/// A file as it is read: in its own axes, unchecked but for what the importer needs.
struct ImportedMesh {
  Soup soup;
  UpAxis up = UpAxis::kZ;              // the file's, or the custom of its format: STL and PLY z, all others y
  std::size_t file_vertices = 0;       // soup.source counts these
  std::vector<std::string> materials;  // their names
};

/// Albedo: glTF base colour factor (linear), else the material's diffuse colour (sRGB, decoded), times the vertex
/// colour; kDefaultAlbedo for meshes without a material. Emission: the material's emissive colour as it stands, times
/// its strength, if any. Two sides: glTF doubleSided and its like. `changes` go before all of these; mirrors come only
/// from there. Textures are not read. Throws std::runtime_error, one line
/// that begins with the path, for a file that is missing, of no known format, damaged, or whose faces name missing
/// vertices.
ImportedMesh import_mesh(const std::string& path, const MaterialChanges& changes = {});

}  // namespace sh::prt
