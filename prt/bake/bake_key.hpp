// What decides the bytes that rays bring: the key of a checkpoint.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/scene/scene.hpp"

namespace sh::prt {

/// A JSON object: counts and checksum of the mesh and of `open` (see BakeSettings), kind, degree, directions, sampler,
/// seed, instruction set. What only the bounces use (albedo, tolerance, solver) is not in it: traced again they are the
/// same.
std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open);

}  // namespace sh::prt
