// A node of a model file: what a viewer or an engine needs to find a part of a scene again.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

/// One instance of a mesh with one material.
struct MeshNode {
  std::string name;                                        // of the node, or of a primitive
  std::string material;                                    // its name, empty if it has none
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();  // from the axes of its own vertices
  std::vector<std::array<std::uint32_t, 2>> faces = {};    // first and count of each run of faces, in their order
};

/// Adds a face to a node that has those before it.
inline void take_face(MeshNode& node, std::uint32_t face) {
  if (node.faces.empty() || node.faces.back()[0] + node.faces.back()[1] != face) node.faces.push_back({face, 0});
  ++node.faces.back()[1];
}

}  // namespace sh::prt
