// Splits large faces, because a shadow is visible only at vertices.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// The longest edge allowed around a point; positive.
using EdgeLimit = std::function<float(const Eigen::Vector3f&)>;

inline constexpr std::size_t kMaxFaces = std::size_t{1} << 27U;

/// Halves edges until none is longer than `limit` at its middle. The two end points alone decide whether an edge is
/// halved. Faces on both sides therefore agree, even at hard edges where they share no vertex, and no cracks open. Old
/// vertices keep their numbers. Returns, for each new face, the old face that it is a part of. Throws
/// std::runtime_error, one line that begins with `name`, past kMaxFaces.
std::vector<std::uint32_t> tessellate(Mesh& mesh, const EdgeLimit& limit, const std::string& name);

}  // namespace sh::prt
