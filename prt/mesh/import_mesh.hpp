// Reads mesh files with assimp: OBJ, PLY, STL, glTF, Collada, 3DS, FBX, Quick3D and its other formats. All instances of
// all meshes go into one Soup, triangulated and with their node transforms; points and lines are dropped.
#pragma once
#include <string>
#include <vector>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

inline constexpr float kDefaultAlbedo = 0.5F;

enum class UpAxis { kY, kZ };

/// The content of a file in its own axes. Only the checks that the importer needs are done.
struct ImportedMesh {
  Soup soup;
  UpAxis up = UpAxis::kZ;              // of the file, else usual for its format: z for STL and PLY, y for all others
  std::size_t file_vertices = 0;       // soup.source counts these
  std::vector<std::string> materials;  // their names
  std::vector<std::string> unread;     // what the file has and this importer leaves out, a line for each kind
};

/// Whether the name ends like that of a mesh file.
bool has_mesh_name(const std::string& path);

/// Albedo: the glTF base color factor (linear), else the material's diffuse color (decoded from sRGB), times the vertex
/// color; kDefaultAlbedo for meshes without a material. Emission: the material's emissive color, taken as linear, times
/// its strength if it has one. BRDF: the roughness and metallic factors of glTF (prt/material/microfacet.hpp).
/// Pictures: those of base color, emission, roughness, metallic part and normals in glTF, that of the diffuse color in other
/// formats (Finish::varied, Finish::normal_map). Soup::chart: the second set of texture coordinates, else the first.
/// Two sides: glTF doubleSided and similar entries. Soup::nodes: an entry for each mesh of each node. `changes` replace all
/// of these; mirrors and lobes come only from `changes`. Other textures are not read; `unread` says so. Throws std::runtime_error, one line that begins with the
/// path, for a file that is missing, of no known format, damaged, or whose faces name missing vertices.
ImportedMesh import_mesh(const std::string& path, const MaterialChanges& changes = {});

}  // namespace sh::prt
