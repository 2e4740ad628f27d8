// Scenes so small that a plan for them takes a moment: every vertex is in the probe of its measurements.
#pragma once
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {

/// A box deep in a square: vertices that see all of the sky, a part of it, or nothing since they are inside of the other.
inline Mesh box_in_square(float longest_edge = 0.6F) {
  Mesh mesh = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(1.5F)));
  Mesh box = primitive_mesh("box", 24, Eigen::Translation3f(0.2F, -0.1F, 0.2F) * Eigen::Scaling(0.9F));
  paint(mesh, {0.5F, 0.25F, 0.75F});
  paint(box, {0.25F, 0.5F, 0.125F});
  append(mesh, box);
  refine(mesh, longest_edge);
  return mesh;
}

/// A room that is open above. No vertex is closed.
inline Mesh bowl(const Eigen::Vector3f& albedo) {
  Mesh mesh = hollow_sphere(8, 0.3F);
  paint(mesh, albedo);
  return mesh;
}

}  // namespace sh::prt::test
