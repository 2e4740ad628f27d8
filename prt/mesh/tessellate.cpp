#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

class Splitter {
 public:
  Splitter(Mesh& mesh, const EdgeLimit& limit) : mesh_(mesh), limit_(limit), origins_(mesh.faces.size()) {
    std::iota(origins_.begin(), origins_.end(), 0U);
  }

  // Splits every face along its long edges once; false if there was none.
  bool split_once() {
    std::vector<Face> faces;
    faces.reserve(mesh_.faces.size() * 2);
    std::vector<std::uint32_t> origins;
    origins.reserve(faces.capacity());
    middles_.clear();
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      split(mesh_.faces[f], faces);
      origins.resize(faces.size(), origins_[f]);
    }
    origins_ = std::move(origins);
    const bool changed = faces.size() != mesh_.faces.size();
    mesh_.faces = std::move(faces);
    return changed;
  }

  /// The original face of each face.
  std::vector<std::uint32_t> take_origins() { return std::move(origins_); }

 private:
  bool is_long(std::uint32_t a, std::uint32_t b) const {
    const Eigen::Vector3f& p = mesh_.positions[a];
    const Eigen::Vector3f& q = mesh_.positions[b];
    return (p - q).norm() > limit_(0.5F * (p + q));
  }

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [entry, added] = middles_.try_emplace({std::min(a, b), std::max(a, b)}, next);
    if (added) {
      const Eigen::Vector3f normal = mesh_.normals[a] + mesh_.normals[b];
      mesh_.positions.emplace_back(0.5F * (mesh_.positions[a] + mesh_.positions[b]));
      mesh_.normals.push_back(normal.norm() > 1e-3F ? normal.normalized() : mesh_.normals[a]);
      mesh_.albedo.emplace_back(0.5F * (mesh_.albedo[a] + mesh_.albedo[b]));
      repeat_finish(mesh_, a);  // both ends of an edge have one finish
    }
    return entry->second;
  }

  void split(const Face& face, std::vector<Face>& faces) {
    std::array<bool, 3> is_split{};  // edge k runs from corner k to corner k+1
    for (std::size_t k = 0; k < 3; ++k) is_split[k] = is_long(face[k], face[(k + 1) % 3]);
    const auto count = std::count(is_split.begin(), is_split.end(), true);
    if (count == 0) {
      faces.push_back(face);
    } else if (count == 3) {
      into_four(face, faces);
    } else {
      // Turn the face so that edge 0 is the only split one, or edge 2 the only whole one.
      std::size_t first = 0;
      while (count == 1 ? !is_split[first] : is_split[(first + 2) % 3]) ++first;
      const Face turned = {face[first], face[(first + 1) % 3], face[(first + 2) % 3]};
      count == 1 ? into_two(turned, faces) : into_three(turned, faces);
    }
  }

  void into_two(const Face& f, std::vector<Face>& faces) {
    const std::uint32_t m = middle(f[0], f[1]);
    faces.push_back({f[0], m, f[2]});
    faces.push_back({m, f[1], f[2]});
  }

  void into_three(const Face& f, std::vector<Face>& faces) {
    const std::uint32_t m = middle(f[0], f[1]);
    const std::uint32_t n = middle(f[1], f[2]);
    faces.push_back({m, f[1], n});
    // The quadrilateral f0 m n f2 is cut along its shorter diagonal.
    const auto length = [&](std::uint32_t a, std::uint32_t b) {
      return (mesh_.positions[a] - mesh_.positions[b]).norm();
    };
    if (length(f[0], n) <= length(m, f[2])) {
      faces.push_back({f[0], m, n});
      faces.push_back({f[0], n, f[2]});
    } else {
      faces.push_back({f[0], m, f[2]});
      faces.push_back({m, n, f[2]});
    }
  }

  void into_four(const Face& f, std::vector<Face>& faces) {
    const std::uint32_t m = middle(f[0], f[1]);
    const std::uint32_t n = middle(f[1], f[2]);
    const std::uint32_t o = middle(f[2], f[0]);
    faces.push_back({f[0], m, o});
    faces.push_back({m, f[1], n});
    faces.push_back({o, n, f[2]});
    faces.push_back({m, n, o});
  }

  Mesh& mesh_;
  const EdgeLimit& limit_;
  std::vector<std::uint32_t> origins_;
  std::unordered_map<std::array<std::uint32_t, 2>, std::uint32_t, WordsHash> middles_;
};

}  // namespace

std::vector<std::uint32_t> tessellate(Mesh& mesh, const EdgeLimit& limit, const std::string& name) {
  Splitter splitter(mesh, limit);
  while (splitter.split_once()) {
    if (mesh.faces.size() > kMaxFaces) {
      throw std::runtime_error(
          fmt::format("{}: max_edge is too small: more than {} faces, expected a longer edge", name, kMaxFaces));
    }
  }
  set_geometric_normals(mesh);
  return splitter.take_origins();
}

}  // namespace sh::prt
