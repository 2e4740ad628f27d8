// Splits large faces, because a shadow needs vertices to fall on.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// The longest edge allowed around a point; positive.
using EdgeLimit = std::function<float(const Eigen::Vector3f&)>;

inline constexpr std::size_t kMaxFaces = std::size_t{1} << 27U;

/// Halves edges that are longer than `limit` at their middle until none is. Whether an edge is halved depends on its
/// two end points alone, so faces that share it agree, even where they share no vertex (at hard edges): no cracks open.
/// Old vertices keep their numbers. Returns which of the faces there were each face is a part of. Throws
/// std::runtime_error, one line that begins with `name`, past kMaxFaces.
std::vector<std::uint32_t> tessellate(Mesh& mesh, const EdgeLimit& limit, const std::string& name);

}  // namespace sh::prt
