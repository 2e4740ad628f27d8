#include "prt/mesh/mesh_checksum.hpp"

#include <array>
#include <vector>

#include "prt/transfer/checksum.hpp"

namespace sh::prt {

namespace {

template <class... Vectors>
std::string sum_of_all(const Vectors&... vectors) {
  const std::array<std::uint64_t, sizeof...(Vectors)> parts = {checksum_of(vectors)...};
  return checksum_text(checksum(parts.data(), sizeof parts));
}

}  // namespace

// A new member of Mesh does not compile here until somebody decides what depends on it.
MeshChecksums checksums_of(const Mesh& mesh) {
  [[maybe_unused]] const auto& [positions, normals, geometric_normals, albedo, emission, mirror, specular, exponent,
                                brdf, texture, normal_map, albedo_map, tint, translucence, chart, atlas, faces, remap,
                                brdfs, normal_maps, albedo_maps, translucences, atlases, nodes, halving, reach, frame] =
      mesh;
  const std::vector<double> place = {frame.origin.x(), frame.origin.y(), frame.origin.z(), frame.unit};
  return {sum_of_all(positions, normals, geometric_normals, mirror, faces, atlases.reach),
          sum_of_all(positions, normals, geometric_normals, albedo, emission, mirror, specular, exponent, brdf, texture,
                     normal_map, albedo_map, tint, chart, atlas, faces, brdfs.rows, normal_maps.texels,
                     albedo_maps.bytes, atlases.reach, place)};
}

}  // namespace sh::prt
