// Shapes made in code. Each fits the unit cube centered at the origin, z up; faces are counterclockwise as seen from
// outside. Curved parts have smooth normals, flat parts have flat normals.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// The names that make_primitive accepts: arch box cone cylinder plane sphere stairs torus.
const std::vector<std::string>& primitive_names();

/// The shape with linear RGB albedo 0.5, ready for transform() and weld(). `segments` is the number of sides of a full
/// turn of a curved shape, at least 3. Throws std::invalid_argument for an unknown name.
Soup make_primitive(std::string_view name, int segments = 48);

}  // namespace sh::prt
