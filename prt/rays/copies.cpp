#include "prt/rays/copies.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace sh::prt {

namespace {

// How far a corner may be from where the map puts it: a quarter of the distance by which rays start above a face (2e-3 of
// its size), or a few roundings of its coordinates.
constexpr float kOfEdge = 5e-4F;
constexpr float kOfCoordinate = 4.0F * static_cast<float>(kSingleRounding);
constexpr std::size_t kMostCompared = 64;  // originals with one number of faces

class Corners {
 public:
  Corners(const std::vector<Eigen::Vector3f>& positions, const std::vector<Face>& faces)
      : positions_(positions), faces_(faces) {}

  [[nodiscard]] std::array<Eigen::Vector3f, 3> of(std::uint32_t face) const {
    return {positions_[faces_[face][0]], positions_[faces_[face][1]], positions_[faces_[face][2]]};
  }

  [[nodiscard]] Eigen::Vector3f center(const FaceRun& run) const {
    Eigen::AlignedBox3f box;
    for (std::uint32_t f = run.first; f < run.first + run.count; ++f) {
      for (const Eigen::Vector3f& corner : of(f)) box.extend(corner);
    }
    return box.center();
  }

 private:
  const std::vector<Eigen::Vector3f>& positions_;
  const std::vector<Face>& faces_;
};

// The map from the original around `center` to its copy, if it is one. The ray tracer takes rays back by the inverse.
std::optional<Eigen::Affine3f> map_to_copy(const Corners& corners, const RunOfNode& original,
                                           const Eigen::Vector3f& center, const RunOfNode& copy) {
  const Eigen::Affine3d exact = copy.map * original.map.inverse() * Eigen::Translation3d(center.cast<double>());
  if (!(exact.linear().determinant() > 0.0)) return std::nullopt;
  const Eigen::Affine3f map = exact.cast<float>();
  const Eigen::Affine3f back = map.inverse();
  for (std::uint32_t f = 0; f < original.run.count; ++f) {
    const std::array<Eigen::Vector3f, 3> from = corners.of(original.run.first + f);
    const std::array<Eigen::Vector3f, 3> to = corners.of(copy.run.first + f);
    const float edge = ((to[1] - to[0]).norm() + (to[2] - to[1]).norm() + (to[0] - to[2]).norm()) / 3.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      const float most = std::max(kOfEdge * edge, kOfCoordinate * to[k].cwiseAbs().maxCoeff());
      const auto is_near = [&](const Eigen::Vector3f& point) { return (point - to[k]).cwiseAbs().maxCoeff() <= most; };
      if (!is_near(map * (from[k] - center)) || !is_near(map * (back * to[k]))) return std::nullopt;
    }
  }
  return map;
}

struct Original {
  const RunOfNode* node;
  CopiedRun copied;
};

}  // namespace

std::vector<CopiedRun> find_copies(const std::vector<Eigen::Vector3f>& positions, const std::vector<Face>& faces,
                                   const std::vector<RunOfNode>& nodes, std::uint32_t least) {
  const Corners corners(positions, faces);
  std::map<std::uint32_t, std::vector<Original>> by_count;
  for (const RunOfNode& node : nodes) {
    if (node.run.count < least) continue;
    std::vector<Original>& originals = by_count[node.run.count];
    const auto is_original = [&](Original& original) {
      const auto map = map_to_copy(corners, *original.node, original.copied.center, node);
      if (map) original.copied.places.push_back({node.run.first, *map});
      return map.has_value();
    };
    if (std::any_of(originals.begin(), originals.end(), is_original) || originals.size() == kMostCompared) continue;
    const Eigen::Vector3f center = corners.center(node.run);
    const Eigen::Affine3f itself(Eigen::Translation3f{center});
    originals.push_back({&node, {node.run, center, {{node.run.first, itself}}}});
  }
  std::vector<CopiedRun> copied;
  for (auto& [count, originals] : by_count) {
    for (Original& original : originals) {
      if (original.copied.places.size() > 1) copied.push_back(std::move(original.copied));
    }
  }
  return copied;
}

std::size_t Parts::choose(const FaceRun& run) {
  for (const std::uint32_t vertex : vertices_) numbers_[vertex] = kNoVertex;
  vertices_.clear();
  run_ = run;
  for (std::uint32_t f = run.first; f < run.first + run.count; ++f) {
    for (const std::uint32_t corner : faces_[f]) {
      if (numbers_[corner] != kNoVertex) continue;
      numbers_[corner] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(corner);
    }
  }
  return vertices_.size();
}

void Parts::write(const Eigen::Vector3f& center, Eigen::Vector3f* positions, Face* faces) const {
  for (std::size_t v = 0; v < vertices_.size(); ++v) positions[v] = positions_[vertices_[v]] - center;
  for (std::uint32_t f = 0; f < run_.count; ++f) {
    for (std::size_t k = 0; k < 3; ++k) faces[f][k] = numbers_[faces_[run_.first + f][k]];
  }
}

}  // namespace sh::prt
