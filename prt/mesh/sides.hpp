// Two-sided surfaces: leaves, cloth, walls without thickness.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// Gives every face with is_two_sided (faces) != 0 a back: the same triangle turned around, with its own vertices and
/// reversed normals. Each side then gathers, sends out and shows its own light, like the sides of a thin surface. All
/// other code handles one-sided faces only; rays distinguish the two sides (prt/rays/tracer.hpp).
void add_backs(Mesh& mesh, const std::vector<std::uint8_t>& is_two_sided);

}  // namespace sh::prt
