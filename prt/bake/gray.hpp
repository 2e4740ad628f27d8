// Colored mirrors: each channel is a scene of its own, in which everything is gray. The albedo of one channel and the
// mirrors of another may reflect more than 1 together.
#pragma once
#include <algorithm>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

inline bool has_colored_mirrors(const Mesh& mesh) {
  return std::any_of(mesh.mirror.begin(), mesh.mirror.end(),
                     [](const Eigen::Vector3f& mirror) { return (mirror.array() != mirror.x()).any(); });
}

/// The mesh as one channel has it.
inline Mesh in_gray(Mesh mesh, int channel) {
  for (auto* colors : {&mesh.albedo, &mesh.mirror, &mesh.emission}) {
    for (Eigen::Vector3f& color : *colors) color.setConstant(color[channel]);
  }
  return mesh;
}

}  // namespace sh::prt
