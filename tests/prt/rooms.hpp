// Meshes whose light is known, and helpers that bake them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/mesh/corners.hpp"
#include "tests/prt/meshes.hpp"

namespace sh::prt::test {

inline const auto kRoot4Pi = static_cast<float>(std::sqrt(4.0 * std::numbers::pi));

inline void paint(Mesh& mesh, const Eigen::Vector3f& albedo) { mesh.albedo.assign(mesh.positions.size(), albedo); }
inline void shine(Mesh& mesh, const Eigen::Vector3f& radiance) {
  mesh.emission.assign(mesh.positions.size(), radiance);
}

inline Scene scene_of(Mesh mesh, const BakeOptions& options) {
  Scene scene;
  scene.name = "test";
  scene.mesh = std::move(mesh);
  scene.bake = options;
  return scene;
}

inline Scene scene_of(Mesh mesh, const TransferKind* kind, int directions = 1024, int degree = 2) {
  return scene_of(std::move(mesh), BakeOptions{.degree = degree, .directions = directions, .kind = kind});
}

/// A primitive whose shading normals are its geometric normals: else the horizon of a vertex would cut its view.
inline Mesh with_one_normal(std::string_view primitive, int segments = 24) {
  Mesh mesh = primitive_mesh(primitive, segments);
  mesh.normals = mesh.geometric_normals;
  return mesh;
}

/// Halves edges until none is longer.
inline void refine(Mesh& mesh, float longest) {
  tessellate(
      mesh, [longest](const Eigen::Vector3f&) { return longest; }, "test");
}

/// Turns all faces and normals around.
inline void turn_inside_out(Mesh& mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  mesh.halving = {};
  for (Eigen::Vector3f& normal : mesh.normals) normal = -normal;
  set_geometric_normals(mesh);
}

/// The largest difference between the numbers of a vertex and others.
template <class Numbers>
double row_error(const Transfer& transfer, std::size_t vertex, const Numbers& expected) {
  double worst = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(transfer.row(vertex)[i]) - static_cast<double>(expected[i])));
  }
  return worst;
}

/// The largest and the root mean square difference of two bakes.
inline double largest_difference(const Transfer& a, const Transfer& b) { return row_error(a, 0, b.coefficients); }
inline double rms_difference(const Transfer& a, const Transfer& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
    squares += std::pow(static_cast<double>(a.coefficients[i] - b.coefficients[i]), 2);
  }
  return std::sqrt(squares / static_cast<double>(a.coefficients.size()));
}

inline Transfer baked(const Mesh& mesh, const TransferKind* kind, int directions = 1024, int degree = 2) {
  return bake(scene_of(mesh, kind, directions, degree));
}

/// A sphere of radius 1 seen from inside; without the faces whose corners all lie higher than `opening`.
inline Mesh hollow_sphere(int segments, float opening = 2.0F) {
  Mesh mesh = primitive_mesh("sphere", segments);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] *= 2.0F;
    mesh.geometric_normals[v] *= -1.0F;
  }
  mesh.normals = mesh.geometric_normals;  // a different horizon would cut the view of the shading normal
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t v) { return mesh.positions[v].z() > opening; });
  });
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

/// The height of the highest vertex of a face: the rim of an open sphere.
inline float rim_of(const Mesh& mesh) {
  float rim = -1.0F;
  for (const Face& face : mesh.faces) {
    for (const std::uint32_t v : face) rim = std::max(rim, mesh.positions[v].z());
  }
  return rim;
}

/// The part of the mesh's area that belongs to each vertex; they sum to 1.
inline std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.positions.size(), 0.0);
  double sum = 0.0;
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
    const double area =
        (mesh.positions[face[1]].cast<double>() - a).cross(mesh.positions[face[2]].cast<double>() - a).norm();
    sum += area;
    for (const std::uint32_t v : face) areas[v] += area / 3.0;
  }
  for (double& area : areas) area /= sum;
  return areas;
}

/// A speck at the origin that faces up, with vertex 0 in its center, and a disc of radius 1 at `height` above it that
/// faces down and emits radiance 2. The albedos are 1/2 and 0.
inline Mesh disc_above_point(float height) {
  constexpr int kCorners = 256;
  Soup soup;
  const auto fan = [&soup](float radius, float z, float side) {
    const auto middle = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.emplace_back(0.0, 0.0, z);
    for (int i = 0; i < kCorners; ++i) {
      const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kCorners;
      soup.positions.emplace_back(radius * std::cos(angle), radius * side * std::sin(angle), z);
      const std::uint32_t corner = middle + 1 + static_cast<std::uint32_t>(i);
      soup.faces.push_back({middle, corner, i + 1 < kCorners ? corner + 1 : middle + 1});
    }
    soup.normals.resize(soup.positions.size(), Eigen::Vector3f(0.0F, 0.0F, side));
  };
  fan(1e-3F, 0.0F, 1.0F);
  const std::size_t speck = soup.positions.size();
  fan(1.0F, height, -1.0F);
  soup.albedo.assign(soup.positions.size(), Eigen::Vector3f::Zero());
  std::fill_n(soup.albedo.begin(), speck, Eigen::Vector3f::Constant(0.5F));
  Mesh mesh = weld(soup, soup.positions.size());
  shine(mesh, Eigen::Vector3f::Zero());
  std::fill(mesh.emission.begin() + static_cast<std::ptrdiff_t>(speck), mesh.emission.end(),
            Eigen::Vector3f::Constant(2.0F));
  return mesh;
}

}  // namespace sh::prt::test
