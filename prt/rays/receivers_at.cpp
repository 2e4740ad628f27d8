#include "prt/rays/receivers_at.hpp"

#include <algorithm>
#include <cmath>

namespace sh::prt {

namespace {

// Fills pixels without a vertex from their neighbors, ring by ring.
void spread(int width, int height, std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint32_t> edge;
  for (std::uint32_t pixel = 0; pixel < vertices.size(); ++pixel) {
    if (vertices[pixel] != kNoVertex) edge.push_back(pixel);
  }
  while (!edge.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t pixel : edge) {
      const int column = static_cast<int>(pixel) % width;
      const int row = static_cast<int>(pixel) / width;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x) {
          std::uint32_t& vertex =
              vertices[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
          if (vertex != kNoVertex) continue;
          vertex = vertices[pixel];
          next.push_back(static_cast<std::uint32_t>(y * width + x));
        }
      }
    }
    edge = std::move(next);
  }
}

}  // namespace

SurfaceReceivers::SurfaceReceivers(const Mesh& mesh) : mesh_(mesh) {
  for (std::size_t a = 0; a < mesh.atlases.heads.size(); ++a) {
    const Atlases::Head& head = mesh.atlases.heads[a];
    const std::size_t entry = mesh.atlases.entry(a);
    std::vector<std::uint32_t>& vertices =
        vertices_.emplace_back(static_cast<std::size_t>(head.width) * static_cast<std::size_t>(head.height), kNoVertex);
    for (std::uint32_t i = 0; i < head.count; ++i) vertices[mesh.atlases.pixels[entry + i]] = head.first + i;
    spread(head.width, head.height, vertices);
  }
}

ReceiversAt SurfaceReceivers::in_atlas(std::size_t atlas, const Eigen::Vector2f& place) const {
  const Atlases::Head& head = mesh_.atlases.heads[atlas];
  const double x = static_cast<double>(place.x()) * head.width - 0.5;
  const double y = (1.0 - static_cast<double>(place.y())) * head.height - 0.5;
  const auto u = static_cast<float>(x - std::floor(x));
  const auto v = static_cast<float>(y - std::floor(y));
  const auto vertex = [&](double column, double row) {
    const int c = std::clamp(static_cast<int>(column), 0, head.width - 1);
    const int r = std::clamp(static_cast<int>(row), 0, head.height - 1);
    return vertices_[atlas]
                    [static_cast<std::size_t>(r) * static_cast<std::size_t>(head.width) + static_cast<std::size_t>(c)];
  };
  const double left = std::floor(x);
  const double top = std::floor(y);
  return {{vertex(left, top), vertex(left + 1, top), vertex(left, top + 1), vertex(left + 1, top + 1)},
          {(1.0F - u) * (1.0F - v), u * (1.0F - v), (1.0F - u) * v, u * v},
          4};
}

ReceiversAt SurfaceReceivers::at(const Hit& hit) const {
  const Face& face = mesh_.faces[hit.face];
  const std::uint16_t atlas = mesh_.atlas.empty() ? std::uint16_t{0} : mesh_.atlas[face[0]];
  if (atlas > 0) return in_atlas(atlas - std::size_t{1}, interpolated(hit, mesh_, mesh_.chart));
  const std::array<float, 3> part = hit.parts();
  return {{face[0], face[1], face[2], 0}, {part[0], part[1], part[2], 0.0F}, 3};
}

}  // namespace sh::prt
