// Shapes made in code. Each fits the unit cube centred at the origin, z up; faces counter-clockwise seen from outside.
// Curved parts carry smooth normals, flat parts flat ones.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// The names make_primitive knows: arch box cone cylinder plane sphere stairs torus.
const std::vector<std::string>& primitive_names();

/// The shape with linear RGB albedo 0.5, ready for transform() and weld(). `segments` is the number of sides of a full
/// turn of the curved ones, at least 3. Throws std::invalid_argument for a name it does not know.
Soup make_primitive(std::string_view name, int segments = 48);

}  // namespace sh::prt
