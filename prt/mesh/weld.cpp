#include "prt/mesh/weld.hpp"

#include <cmath>
#include <unordered_map>

#include "prt/mesh/corner_angle.hpp"
#include "prt/mesh/vertex_key.hpp"

namespace sh::prt {

namespace {

constexpr float kNormalSteps = 8192.0F;

Eigen::Vector3f rounded(const Eigen::Vector3f& normal) { return (normal * kNormalSteps).array().round().matrix(); }

template <class T>
void append_all(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Mesh weld(const Soup& soup, std::size_t source_vertices) {
  Mesh mesh;
  mesh.remap.assign(source_vertices, kNoVertex);
  std::unordered_map<std::array<std::uint32_t, 9>, std::uint32_t, WordsHash> welded;
  welded.reserve(soup.positions.size());
  for (const Face& face : soup.faces) {
    Face indices{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = face[k];
      Eigen::Matrix<float, 9, 1> key;
      key << soup.positions[v], rounded(soup.normals[v]), soup.albedo[v];
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [entry, added] = welded.try_emplace(bits_of(key), next);
      if (added) {
        mesh.positions.push_back(soup.positions[v]);
        mesh.normals.push_back(soup.normals[v]);
        mesh.albedo.push_back(soup.albedo[v]);
      }
      indices[k] = entry->second;
      std::uint32_t& made = mesh.remap.at(soup.source.empty() ? v : soup.source[v]);
      made = made == kNoVertex ? entry->second : made;
    }
    mesh.faces.push_back(indices);
  }
  set_geometric_normals(mesh);
  return mesh;
}

void set_geometric_normals(Mesh& mesh) {
  mesh.geometric_normals.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f normal = face_normal(mesh.positions, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const float side = normal.dot(mesh.normals[face[k]]) < 0.0F ? -1.0F : 1.0F;
      mesh.geometric_normals[face[k]] += normal * (side * corner_angle(mesh.positions, face, k));
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Eigen::Vector3f& normal = mesh.geometric_normals[v];
    normal = normal.norm() > 1e-6F ? normal.normalized() : mesh.normals[v];
  }
}

void append(Mesh& mesh, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  append_all(mesh.positions, part.positions);
  append_all(mesh.normals, part.normals);
  append_all(mesh.geometric_normals, part.geometric_normals);
  append_all(mesh.albedo, part.albedo);
  for (const Face& face : part.faces) {
    mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  }
  for (const std::uint32_t vertex : part.remap) {
    mesh.remap.push_back(vertex == kNoVertex ? kNoVertex : vertex + first);
  }
}

}  // namespace sh::prt
