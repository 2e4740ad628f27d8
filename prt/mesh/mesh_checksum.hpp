// What results of a mesh depend on, as checksums, so that a file made for another mesh is known.
#pragma once
#include <string>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

struct MeshChecksums {
  std::string rays;   // of what rays and their sums depend on
  std::string whole;  // of what a plan or a bake depends on
};

/// 16 hexadecimal digits each.
MeshChecksums checksums_of(const Mesh& mesh);

}  // namespace sh::prt
