// Gray materials need one channel. With colored mirrors each channel is a scene of its own, in which everything is gray:
// the albedo of one channel and the mirrors of another may reflect more than 1 together.
#pragma once
#include <algorithm>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// True if the channels of every color are equal.
inline bool is_gray(const std::vector<Eigen::Vector3f>& colors) {
  return std::all_of(colors.begin(), colors.end(),
                     [](const Eigen::Vector3f& color) { return (color.array() == color.x()).all(); });
}

/// True if no BRDF has a color of its own.
inline bool is_gray(const Reflectances& brdfs) {
  return std::none_of(brdfs.heads.begin(), brdfs.heads.end(),
                      [](const Reflectances::Head& head) { return head.is_measured; });
}

inline bool has_colored_mirrors(const Mesh& mesh) { return !is_gray(mesh.mirror); }

/// The mesh as one channel has it.
inline Mesh in_gray(Mesh mesh, int channel) {
  for (auto* colors : {&mesh.albedo, &mesh.mirror, &mesh.emission}) {
    for (Eigen::Vector3f& color : *colors) color.setConstant(color[channel]);
  }
  return mesh;
}

}  // namespace sh::prt
