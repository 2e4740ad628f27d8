// Materials that vary over a surface: pictures of albedo, roughness and metallic part, sampled at the vertices.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// The steps from 0 to 1 of the roughness and of the metallic part of vertices: each pair in use is a table of the mesh.
inline constexpr int kRoughnessSteps = 32;
inline constexpr int kMetallicSteps = 8;

/// Gives the vertices of a mesh made from `soup` the albedo and the BRDFs of the pictures of their finish, bilinear at
/// their texture coordinates; then drops coordinates that no normal map needs. origins: for each face of the mesh, that of
/// the soup.
void vary_materials(const Soup& soup, const std::vector<std::uint32_t>& origins, Mesh& mesh);

}  // namespace sh::prt
