// Two-sided surfaces: leaves, cloth, walls without thickness.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// Gives every face with is_two_sided (faces) != 0 a back: the same triangle turned around, on vertices of its own
/// whose normals are turned as well. Each side then gathers, sends out and shows its own light, as sides of a thin
/// surface do, and everything else knows only one-sided faces; rays tell the two apart (prt/rays/tracer.hpp).
void add_backs(Mesh& mesh, const std::vector<std::uint8_t>& is_two_sided);

}  // namespace sh::prt
