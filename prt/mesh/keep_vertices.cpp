#include "prt/mesh/keep_vertices.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/split_face.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

// The number of each middle among the places of middles; kNoVertex for other vertices.
std::vector<std::uint32_t> places_of_middles(const Mesh& mesh) {
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, WordsHash> places;
  std::vector<std::uint32_t> place_of(mesh.positions.size(), kNoVertex);
  for (std::size_t v = 0; v < place_of.size(); ++v) {
    if (!mesh.halving.is_middle(v)) continue;
    const auto next = static_cast<std::uint32_t>(places.size());
    place_of[v] = places.try_emplace(bits_of(mesh.positions[v]), next).first->second;
  }
  return place_of;
}

// The parts of faces that are halved at kept middles only.
class KeptParts {
 public:
  KeptParts(const Mesh& mesh, const std::vector<std::uint8_t>& kept) : mesh_(mesh) {
    for (std::uint32_t v = 0; v < kept.size(); ++v) {
      if (kept[v] != 0 && mesh.halving.is_middle(v)) middles_.emplace(edge(mesh.halving.ends[v]), v);
    }
  }

  // Appends the parts of a face, in the order in which tessellate() makes them, and its cuts. Returns its part.
  std::uint32_t append(const Face& corners, bool is_turned, std::vector<Face>& faces, Halving& halving) const {
    FaceParts parts;
    std::array<std::uint32_t, 6> points = {corners[0], corners[1], corners[2], kNoVertex, kNoVertex, kNoVertex};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto middle = middles_.find(edge({corners[k], corners[(k + 1) % 3]}));
      parts.is_split[k] = middle != middles_.end();
      if (parts.is_split[k]) points[3 + k] = middle->second;
    }
    split_face({mesh_.positions[corners[0]], mesh_.positions[corners[1]], mesh_.positions[corners[2]]}, parts);
    if (parts.form == CutForm::kNone) {
      faces.push_back(is_turned ? Face{corners[0], corners[2], corners[1]} : corners);
      return static_cast<std::uint32_t>(faces.size() - 1) | FaceCut::kIsFace;
    }
    const std::size_t cut = halving.cuts.size();
    halving.cuts.push_back({{}, parts.form, static_cast<std::uint8_t>(parts.first)});
    halving.middles.push_back({points[3], points[4], points[5]});
    for (std::size_t i = 0; i < parts.faces.size(); ++i) {
      const auto& [a, b, c] = parts.faces[i];
      const std::uint32_t part = append({points[a], points[b], points[c]}, is_turned, faces, halving);
      halving.cuts[cut].parts[i] = part;
    }
    return static_cast<std::uint32_t>(cut);
  }

 private:
  static std::array<std::uint32_t, 2> edge(const std::array<std::uint32_t, 2>& ends) {
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
  }

  const Mesh& mesh_;
  std::unordered_map<std::array<std::uint32_t, 2>, std::uint32_t, WordsHash> middles_;
};

// The node of each face; kNoFace without one.
std::vector<std::uint32_t> node_of_faces(const Mesh& mesh) {
  std::vector<std::uint32_t> node_of(mesh.faces.size(), kNoFace);
  for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
    for (const auto& [first, count] : mesh.nodes[n].faces) std::fill_n(node_of.begin() + first, count, n);
  }
  return node_of;
}

}  // namespace

std::vector<std::uint32_t> ends_first(const Halving& halving) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> is_done(halving.ends.size(), 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < is_done.size(); ++v) {
    open.assign(1, v);
    while (!open.empty()) {
      const std::uint32_t next = open.back();
      const std::size_t before = open.size();
      if (is_done[next] == 0 && halving.is_middle(next)) {
        for (const std::uint32_t end : halving.ends[next]) {
          if (is_done[end] == 0) open.push_back(end);
        }
      }
      if (open.size() > before) continue;
      open.pop_back();
      if (is_done[next] == 0) order.push_back(next);
      is_done[next] = 1;
    }
  }
  return order;
}

std::vector<Blend> blends_of(const Halving& halving, const std::vector<std::uint8_t>& kept,
                             const std::vector<std::uint32_t>& vertices) {
  const std::vector<std::uint32_t> order = ends_first(halving);
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Blend> blends;
  for (const std::uint32_t vertex : vertices) {
    Blend& blend = blends.emplace_back();
    std::map<std::uint32_t, double> open = {{place[vertex], 1.0}};  // by place
    while (!open.empty()) {
      const auto [last, part] = *open.rbegin();
      open.erase(std::prev(open.end()));
      const std::uint32_t v = order[last];
      if (kept[v] != 0) {
        blend.emplace_back(v, part);
      } else {
        for (const std::uint32_t end : halving.ends[v]) open[place[end]] += 0.5 * part;
      }
    }
  }
  return blends;
}

std::vector<std::uint8_t> with_ends(const Mesh& mesh, std::vector<std::uint8_t> kept) {
  const std::vector<std::uint32_t> place_of = places_of_middles(mesh);
  std::vector<std::vector<std::uint32_t>> at_place;
  for (std::uint32_t v = 0; v < place_of.size(); ++v) {
    if (place_of[v] == kNoVertex) continue;
    at_place.resize(std::max<std::size_t>(at_place.size(), place_of[v] + std::size_t{1}));
    at_place[place_of[v]].push_back(v);
  }
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < kept.size(); ++v) {
    if (!mesh.halving.is_middle(v)) {
      kept[v] = 1;
    } else if (kept[v] != 0) {
      open.push_back(v);
    }
  }
  const auto keep = [&](std::uint32_t v) {
    if (kept[v] == 0) open.push_back(v);
    kept[v] = 1;
  };
  while (!open.empty()) {
    const std::uint32_t v = open.back();
    open.pop_back();
    for (const std::uint32_t other : at_place[place_of[v]]) keep(other);
    for (const std::uint32_t end : mesh.halving.ends[v]) {
      if (mesh.halving.is_middle(end)) keep(end);
    }
  }
  return kept;
}

void keep_vertices(Mesh& mesh, const std::vector<std::uint8_t>& kept) {
  if (!mesh.atlases.heads.empty()) throw std::invalid_argument("vertices of a mesh with an atlas cannot be left out");
  if (kept.size() != mesh.positions.size()) throw std::invalid_argument("marks of another number of vertices");
  const bool is_any_left_out = std::find(kept.begin(), kept.end(), 0) != kept.end();
  if (mesh.halving.empty() && !is_any_left_out) return;
  if (mesh.halving.empty() || with_ends(mesh, kept) != kept)
    throw std::invalid_argument("vertices without the ends of their edges");
  mesh.reach = reaches(mesh);
  const KeptParts parts(mesh, kept);
  const std::vector<std::uint32_t> node_of = node_of_faces(mesh);
  std::vector<Face> faces;
  Halving halving;
  for (MeshNode& node : mesh.nodes) node.faces.clear();
  visit_wholes(mesh.halving, mesh.faces, [&](const Halving::Whole& face) {
    const std::size_t first = faces.size();
    const std::uint32_t part = parts.append(face.corners, face.is_turned, faces, halving);
    if ((part & FaceCut::kIsFace) == 0) halving.faces.push_back({face.corners, part, face.is_turned});
    const std::uint32_t node = node_of[mesh.halving.first_face(face.part)];
    for (std::size_t f = first; f < faces.size() && node != kNoFace; ++f) {
      take_face(mesh.nodes[node], static_cast<std::uint32_t>(f));
    }
  });
  halving.ends = std::move(mesh.halving.ends);
  std::vector<std::uint32_t> numbers(kept.size(), kNoVertex);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] != 0) numbers[v] = count++;
  }
  const auto compress = [&](auto& values) {
    if (values.empty()) return;
    for (std::size_t v = 0; v < kept.size(); ++v) {
      if (kept[v] != 0) values[numbers[v]] = values[v];
    }
    values.resize(count);
    values.shrink_to_fit();
  };
  visit_vertex_arrays(mesh, compress);
  compress(mesh.reach);
  compress(halving.ends);
  for (Face& face : faces) {
    for (std::uint32_t& corner : face) renumber(numbers, corner);
  }
  mesh.faces = std::move(faces);
  for (std::uint32_t& vertex : mesh.remap) renumber(numbers, vertex);
  for (auto& ends : halving.ends) {
    for (std::uint32_t& end : ends) renumber(numbers, end);
  }
  for (auto& middles : halving.middles) {
    for (std::uint32_t& middle : middles) renumber(numbers, middle);
  }
  for (Halving::Whole& face : halving.faces) {
    for (std::uint32_t& corner : face.corners) renumber(numbers, corner);
  }
  mesh.halving = halving.empty() ? Halving() : std::move(halving);
  set_geometric_normals(mesh);
}

}  // namespace sh::prt
