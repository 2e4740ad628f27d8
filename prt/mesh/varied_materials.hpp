// Materials that vary over a surface: pictures of albedo, emission, roughness and metallic part.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// The steps from 0 to 1 of the roughness and of the metallic part of vertices: each pair in use is a table of the mesh.
inline constexpr int kRoughnessSteps = 32;
inline constexpr int kMetallicSteps = 8;

/// The most samples of a picture along the side of a face, or of a texel of an atlas.
inline constexpr int kMostSamplesAlong = 64;

/// Gives the receivers of a mesh made from `soup` the albedo, the emission and the BRDFs of the pictures of their finish:
/// the mean of the picture over the place that is nearest to the vertex on each face around it, or over the texel; then
/// drops coordinates that no picture needs any more. origins: for each face of the mesh, that of the soup; texels: the
/// faces of the texels of its atlas.
void vary_materials(const Soup& soup, const std::vector<std::uint32_t>& origins,
                    const std::vector<std::uint32_t>& texels, Mesh& mesh);

}  // namespace sh::prt
