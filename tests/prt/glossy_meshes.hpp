// Meshes with lobes.
#pragma once
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {

/// The mesh with one material.
inline Mesh finished(Mesh mesh, const Eigen::Vector3f& albedo, const Eigen::Vector3f& specular, float exponent) {
  paint(mesh, albedo);
  mesh.specular.assign(mesh.positions.size(), specular);
  mesh.exponent.assign(mesh.positions.size(), exponent);
  return mesh;
}

inline Mesh polished(Mesh mesh, float albedo, float specular, float exponent) {
  return finished(std::move(mesh), Eigen::Vector3f::Constant(albedo), Eigen::Vector3f::Constant(specular), exponent);
}

/// A torus over stairs: concave, with edges.
inline Mesh statue(float exponent) {
  Mesh mesh = primitive_mesh("stairs");
  append(mesh, primitive_mesh("torus", 14, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, 0.9F))));
  return polished(std::move(mesh), 0.3F, 0.6F, exponent);
}

}  // namespace sh::prt::test
