#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/mesh/split_face.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

// An edge without a point between its ends is never halved, so that splitting ends at any limit.
bool is_long(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const EdgeLimit& limit) {
  const Eigen::Vector3f middle = middle_of(a, b);
  return (a - b).norm() > limit(middle) && middle != a && middle != b;
}

void split(const Triangle& corners, const EdgeLimit& limit, FaceParts& parts) {
  for (std::size_t k = 0; k < 3; ++k) parts.is_split[k] = is_long(corners[k], corners[(k + 1) % 3], limit);
  split_face(corners, parts);
}

Triangle corners_of(const Mesh& mesh, const Face& face) {
  return {mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
}

// Counts the faces that splitting would make, without making them; gives up past `most`.
std::size_t count_faces(const Mesh& mesh, const EdgeLimit& limit, std::size_t most) {
  std::size_t count = 0;
  std::vector<Triangle> open;
  FaceParts parts;
  for (const Face& face : mesh.faces) {
    open.assign(1, corners_of(mesh, face));
    while (!open.empty() && count + open.size() <= most) {
      output::check_interrupt();
      const Triangle t = open.back();
      open.pop_back();
      split(t, limit, parts);
      if (parts.faces.size() == 1) {
        ++count;
        continue;
      }
      const std::array<Eigen::Vector3f, 6> points = {
          t[0], t[1], t[2], middle_of(t[0], t[1]), middle_of(t[1], t[2]), middle_of(t[2], t[0])};
      for (const auto& part : parts.faces) open.push_back({points[part[0]], points[part[1]], points[part[2]]});
    }
    count += open.size();
    if (count > most) break;
  }
  return count;
}

EdgeLimit stretched(const EdgeLimit& limit, double factor) {
  return [&limit, factor](const Eigen::Vector3f& point) { return static_cast<float>(factor) * limit(point); };
}

// A factor on the limit, with two digits, that leaves at most kMaxFaces. Few faces are counted first; their number falls
// with the square of the factor.
double factor_that_fits(const Mesh& mesh, const EdgeLimit& limit) {
  const std::size_t few = std::max(std::size_t{1} << 16U, 4 * mesh.faces.size());
  const auto count = [&](double factor, std::size_t most) { return count_faces(mesh, stretched(limit, factor), most); };
  double coarse = 1.0;
  while (count(coarse, few) > few) coarse *= 2.0;
  double factor = coarse * std::sqrt(static_cast<double>(count(coarse, few)) / static_cast<double>(kMaxFaces));
  do {
    factor *= 1.2;
    const double digit = std::pow(10.0, std::floor(std::log10(factor)) - 1.0);
    factor = std::ceil(factor / digit) * digit;
  } while (count(factor, kMaxFaces) > kMaxFaces);
  return factor;
}

class Splitter {
 public:
  Splitter(Mesh& mesh, const EdgeLimit& limit)
      : mesh_(mesh), limit_(limit), origins_(mesh.faces.size()), owners_(mesh.faces.size()) {
    std::iota(origins_.begin(), origins_.end(), 0U);
    std::iota(owners_.begin(), owners_.end(), kIsRoot);
    mesh_.halving = {};
    mesh_.halving.ends.assign(mesh.positions.size(), {kNoVertex, kNoVertex});
    for (const Face& face : mesh.faces) mesh_.halving.faces.push_back({face, 0});
  }

  // Splits every face along its long edges once; false if there was none.
  bool split_once() {
    std::vector<Face> faces;
    faces.reserve(mesh_.faces.size() * 2);
    std::vector<std::uint32_t> origins;
    origins.reserve(faces.capacity());
    std::vector<std::uint32_t> owners;
    owners.reserve(faces.capacity());
    middles_.clear();
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      output::check_interrupt();
      split_face(mesh_.faces[f], owners_[f], faces, owners);
      origins.resize(faces.size(), origins_[f]);
    }
    origins_ = std::move(origins);
    owners_ = std::move(owners);
    const bool changed = faces.size() != mesh_.faces.size();
    mesh_.faces = std::move(faces);
    return changed;
  }

  /// The original face of each face. The parts of a face stand together.
  std::vector<std::uint32_t> finish() {
    for (std::uint32_t f = 0; f < owners_.size(); ++f) part_of(owners_[f]) = f | FaceCut::kIsFace;
    Halving& halving = mesh_.halving;
    std::erase_if(halving.faces, [](const Halving::Whole& face) { return (face.part & FaceCut::kIsFace) != 0; });
    if (halving.empty()) halving = {};
    halving.faces.shrink_to_fit();
    return std::move(origins_);
  }

 private:
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [entry, added] = middles_.try_emplace({std::min(a, b), std::max(a, b)}, next);
    if (added) {
      const Eigen::Vector3f normal = mesh_.normals[a] + mesh_.normals[b];
      mesh_.halving.ends.push_back({a, b});
      mesh_.positions.emplace_back(middle_of(mesh_.positions[a], mesh_.positions[b]));
      mesh_.normals.push_back(normal.norm() > 1e-3F ? normal.normalized() : mesh_.normals[a]);
      mesh_.albedo.emplace_back(0.5F * (mesh_.albedo[a] + mesh_.albedo[b]));
      if (!mesh_.texture.empty()) mesh_.texture.emplace_back(0.5F * (mesh_.texture[a] + mesh_.texture[b]));
      if (!mesh_.chart.empty()) mesh_.chart.emplace_back(0.5F * (mesh_.chart[a] + mesh_.chart[b]));
      repeat_finish(mesh_, a);  // both ends of an edge have one finish
    }
    return entry->second;
  }

  // Where the tree names a face: a part of a cut, or with kIsRoot a face before cuts.
  static constexpr std::uint32_t kIsRoot = 0x80000000U;
  std::uint32_t& part_of(std::uint32_t owner) {
    if ((owner & kIsRoot) != 0) return mesh_.halving.faces[owner ^ kIsRoot].part;
    return mesh_.halving.cuts[owner / 4].parts[owner % 4];
  }

  void split_face(const Face& face, std::uint32_t owner, std::vector<Face>& faces, std::vector<std::uint32_t>& owners) {
    split(corners_of(mesh_, face), limit_, parts_);
    std::array<std::uint32_t, 6> points = {face[0], face[1], face[2], kNoVertex, kNoVertex, kNoVertex};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (parts_.first + i) % 3;
      if (parts_.is_split[k]) points[3 + k] = middle(face[k], face[(k + 1) % 3]);
    }
    for (const auto& part : parts_.faces) faces.push_back({points[part[0]], points[part[1]], points[part[2]]});
    if (parts_.form == CutForm::kNone) {
      owners.push_back(owner);
      return;
    }
    const auto cut = static_cast<std::uint32_t>(mesh_.halving.cuts.size());
    part_of(owner) = cut;
    mesh_.halving.cuts.push_back({{}, parts_.form, static_cast<std::uint8_t>(parts_.first)});
    mesh_.halving.middles.push_back({points[3], points[4], points[5]});
    for (std::uint32_t i = 0; i < parts_.faces.size(); ++i) owners.push_back(4 * cut + i);
  }

  Mesh& mesh_;
  const EdgeLimit& limit_;
  std::vector<std::uint32_t> origins_;
  std::vector<std::uint32_t> owners_;
  FaceParts parts_;
  std::unordered_map<std::array<std::uint32_t, 2>, std::uint32_t, WordsHash> middles_;
};

}  // namespace

std::vector<std::uint32_t> tessellate(Mesh& mesh, const EdgeLimit& limit, const std::string& name) {
  if (count_faces(mesh, limit, kMaxFaces) > kMaxFaces) {
    throw std::runtime_error(
        fmt::format("{}: max_edge makes more than {} faces; expected one at least {:.2g} times as long", name,
                    kMaxFaces, factor_that_fits(mesh, limit)));
  }
  Splitter splitter(mesh, limit);
  while (splitter.split_once()) {
  }
  set_geometric_normals(mesh);
  return splitter.finish();
}

}  // namespace sh::prt
