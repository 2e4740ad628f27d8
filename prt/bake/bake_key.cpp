#include "prt/bake/bake_key.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer_names.hpp"

namespace sh::prt {

namespace {

template <class T>
std::uint64_t checksum_of(const std::vector<T>& values) {
  return checksum(values.data(), values.size() * sizeof(T));
}

// A member added to Mesh does not compile here until it is decided whether rays depend on it.
std::string mesh_checksum(const Mesh& mesh) {
  [[maybe_unused]] const auto& [positions, normals, geometric_normals, albedo, emission, mirror, faces, remap] = mesh;
  const std::array<std::uint64_t, 5> parts = {checksum_of(positions), checksum_of(normals),
                                              checksum_of(geometric_normals), checksum_of(mirror), checksum_of(faces)};
  return fmt::format("{:016x}", checksum(parts.data(), sizeof parts));
}

}  // namespace

std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open) {
  [[maybe_unused]] const auto& [degree, directions, sampler, seed, kind, bounces] = scene.bake;  // as above
  const nlohmann::ordered_json key = {{"vertices", scene.mesh.positions.size()},
                                      {"faces", scene.mesh.faces.size()},
                                      {"mesh", mesh_checksum(scene.mesh)},
                                      {"open_vertices", std::count(open.begin(), open.end(), 1)},
                                      {"open", fmt::format("{:016x}", checksum_of(open))},
                                      {"transfer", name_of(kind).scene},
                                      {"degree", degree},
                                      {"directions", directions},
                                      {"sampler", name_of(sampler)},
                                      {"seed", seed},
                                      {"instruction_set", instruction_set}};
  return key.dump();
}

}  // namespace sh::prt
