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

// The maps and faces of nodes, which tell what copies rays find.
std::vector<double> numbers_of(const std::vector<MeshNode>& nodes) {
  std::vector<double> numbers;
  for (const MeshNode& node : nodes) {
    const Eigen::Matrix<double, 3, 4> map = node.to_world.affine();
    numbers.insert(numbers.end(), map.data(), map.data() + map.size());
    numbers.push_back(static_cast<double>(node.faces.size()));
    for (const auto& run : node.faces) numbers.insert(numbers.end(), run.begin(), run.end());
  }
  return numbers;
}

}  // namespace

// A new member of Mesh does not compile here until somebody decides what depends on it.
MeshChecksums checksums_of(const Mesh& mesh) {
  [[maybe_unused]] const auto& [positions, normals, geometric_normals, albedo, emission, mirror, specular, exponent,
                                brdf, texture, normal_map, albedo_map, tint, translucence, chart, atlas, faces, remap,
                                brdfs, normal_maps, albedo_maps, translucences, atlases, nodes, halving, reach, frame] =
      mesh;
  const std::vector<double> place = {frame.origin.x(), frame.origin.y(), frame.origin.z(), frame.unit};
  const std::vector<double> copies = numbers_of(nodes);
  return {sum_of_all(positions, normals, geometric_normals, mirror, faces, atlases.reach, copies),
          sum_of_all(positions, normals, geometric_normals, albedo, emission, mirror, specular, exponent, brdf, texture,
                     normal_map, albedo_map, tint, chart, atlas, faces, brdfs.rows, normal_maps.texels,
                     albedo_maps.bytes, atlases.reach, place, copies)};
}

}  // namespace sh::prt
