#include "prt/bake/traced_part.hpp"

#include <algorithm>
#include <utility>

namespace sh::prt {

namespace {

// The vertices that share an edge with each vertex, in order.
std::vector<std::vector<std::uint32_t>> neighbors_of_all(const Mesh& mesh) {
  std::vector<std::vector<std::uint32_t>> neighbors(mesh.positions.size());
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      neighbors[face[k]].push_back(face[(k + 1) % 3]);
      neighbors[face[k]].push_back(face[(k + 2) % 3]);
    }
  }
  for (const auto& [a, b] : neighboring_texels(mesh)) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  for (std::vector<std::uint32_t>& around : neighbors) {
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }
  return neighbors;
}

}  // namespace

TracedPart::TracedPart(const Mesh& mesh, std::vector<std::uint32_t> wanted,
                       const std::function<bool(std::uint32_t)>& is_closed, std::size_t most_sources)
    : vertices_(std::move(wanted)), wanted_(vertices_.size()) {
  constexpr std::uint32_t kAbsent = 0xFFFFFFFFU;
  const std::vector<std::vector<std::uint32_t>> neighbors = neighbors_of_all(mesh);
  std::vector<std::uint32_t> place(mesh.positions.size(), kAbsent);
  for (std::uint32_t i = 0; i < wanted_; ++i) place[vertices_[i]] = i;
  for (std::size_t i = 0; i < vertices_.size() && vertices_.size() < (1 + most_sources) * wanted_; ++i) {
    if (!is_closed(vertices_[i])) continue;
    for (const std::uint32_t u : neighbors[vertices_[i]]) {
      if (place[u] != kAbsent) continue;
      place[u] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(u);
    }
  }
  for (const std::uint32_t v : vertices_) {
    std::vector<std::uint32_t>& within = neighbors_.emplace_back();
    for (const std::uint32_t u : neighbors[v]) {
      if (place[u] != kAbsent) within.push_back(place[u]);
    }
  }
}

Fill TracedPart::fill(const std::vector<Sight>& sight) const {
  std::vector<ClosedVertex> closed;
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    if (sight[i].closed() > 0.0F && !neighbors_[i].empty()) closed.push_back({i, sight[i].closed(), neighbors_[i]});
  }
  return Fill(std::move(closed));
}

}  // namespace sh::prt
