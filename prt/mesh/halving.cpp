#include "prt/mesh/halving.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/split_face.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

// That of a mesh, also of one in which no face was halved.
Halving whole(const Mesh& mesh) {
  if (!mesh.halving.empty()) return mesh.halving;
  Halving halving;
  halving.ends.assign(mesh.positions.size(), {kNoVertex, kNoVertex});
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    halving.faces.push_back({mesh.faces[f], f | FaceCut::kIsFace});
  }
  return halving;
}

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

void renumber(const std::vector<std::uint32_t>& numbers, std::uint32_t& vertex) {
  if (vertex != kNoVertex) vertex = numbers[vertex];
}

}  // namespace

void add_backs(Halving& halving, const std::vector<std::uint32_t>& backs,
               const std::vector<std::uint32_t>& back_faces) {
  if (halving.empty()) return;
  const std::size_t added = backs.size() - static_cast<std::size_t>(std::count(backs.begin(), backs.end(), kNoVertex));
  halving.ends.resize(backs.size() + added);
  for (std::size_t v = 0; v < backs.size(); ++v) {
    if (backs[v] == kNoVertex) continue;
    halving.ends[backs[v]] = halving.ends[v];
    for (std::uint32_t& end : halving.ends[backs[v]]) renumber(backs, end);
  }
  const std::vector<Halving::Whole> fronts = halving.faces;
  const auto cuts = static_cast<std::uint32_t>(halving.cuts.size());
  std::vector<std::uint32_t> back_cuts(cuts, 0);
  for (std::uint32_t c = 0; c < cuts; ++c) {
    if (back_faces[halving.first_face(c)] == kNoFace) continue;
    back_cuts[c] = static_cast<std::uint32_t>(halving.cuts.size());
    halving.cuts.push_back(halving.cuts[c]);
    halving.middles.push_back(halving.middles[c]);
    for (std::uint32_t& middle : halving.middles.back()) renumber(backs, middle);
  }
  const auto back_of = [&](std::uint32_t part) {
    return (part & FaceCut::kIsFace) != 0 ? back_faces[part ^ FaceCut::kIsFace] | FaceCut::kIsFace : back_cuts[part];
  };
  for (std::size_t c = cuts; c < halving.cuts.size(); ++c) {
    for (std::size_t i = 0; i < part_count(halving.cuts[c].form); ++i) {
      halving.cuts[c].parts[i] = back_of(halving.cuts[c].parts[i]);
    }
  }
  for (Halving::Whole face : fronts) {
    if (back_faces[halving.first_face(face.part)] == kNoFace) continue;
    for (std::uint32_t& corner : face.corners) renumber(backs, corner);
    halving.faces.push_back({face.corners, back_of(face.part), true});
  }
}

void append_halving(Mesh& mesh, const Mesh& part) {
  if (mesh.halving.empty() && part.halving.empty()) return;
  mesh.halving = whole(mesh);
  Halving own = whole(part);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto first_face = static_cast<std::uint32_t>(mesh.faces.size());
  const auto first_cut = static_cast<std::uint32_t>(mesh.halving.cuts.size());
  const auto move = [first](std::uint32_t& vertex) { vertex += vertex == kNoVertex ? 0 : first; };
  const auto moved = [&](std::uint32_t one) { return one + ((one & FaceCut::kIsFace) != 0 ? first_face : first_cut); };
  for (auto& ends : own.ends) std::for_each(ends.begin(), ends.end(), move);
  for (auto& middles : own.middles) std::for_each(middles.begin(), middles.end(), move);
  for (Halving::Whole& face : own.faces) {
    std::for_each(face.corners.begin(), face.corners.end(), move);
    face.part = moved(face.part);
  }
  for (FaceCut& cut : own.cuts) {
    for (std::size_t i = 0; i < part_count(cut.form); ++i) cut.parts[i] = moved(cut.parts[i]);
  }
  const auto append_all = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append_all(mesh.halving.ends, own.ends);
  append_all(mesh.halving.middles, own.middles);
  append_all(mesh.halving.faces, own.faces);
  append_all(mesh.halving.cuts, own.cuts);
}

std::uint32_t Halving::first_face(std::uint32_t part) const {
  while ((part & FaceCut::kIsFace) == 0) part = cuts[part].parts[0];
  return part ^ FaceCut::kIsFace;
}

PlaceInFace located(const std::vector<FaceCut>& cuts, std::uint32_t part, std::array<double, 3> weights) {
  while ((part & FaceCut::kIsFace) == 0) {
    const FaceCut& cut = cuts[part];
    const double a = weights[cut.first];
    const double b = weights[(cut.first + 1) % 3];
    const double c = weights[(cut.first + 2) % 3];
    std::size_t next = 0;
    if (cut.form == CutForm::kHalves) {
      next = a >= b ? 0 : 1;
      weights = a >= b ? std::array{a - b, 2.0 * b, c} : std::array{2.0 * a, b - a, c};
    } else if (cut.form == CutForm::kQuarters) {
      next = 2.0 * a >= 1.0 ? 0 : 2.0 * b >= 1.0 ? 1 : 2.0 * c >= 1.0 ? 2 : 3;
      weights = next == 0   ? std::array{a - b - c, 2.0 * b, 2.0 * c}
                : next == 1 ? std::array{2.0 * a, b - a - c, 2.0 * c}
                : next == 2 ? std::array{2.0 * a, 2.0 * b, c - a - b}
                            : std::array{a + b - c, b + c - a, c + a - b};
    } else if (2.0 * b >= 1.0) {
      weights = {2.0 * a, b - a - c, 2.0 * c};
    } else if (cut.form == CutForm::kEarFromStart) {
      next = b >= c ? 1 : 2;
      weights = b >= c ? std::array{a - b + c, 2.0 * (b - c), 2.0 * c} : std::array{a, 2.0 * b, c - b};
    } else {
      next = a >= b ? 1 : 2;
      weights = a >= b ? std::array{a - b, 2.0 * b, c} : std::array{2.0 * a, 2.0 * (b - a), a - b + c};
    }
    part = cut.parts[next];
  }
  return {part ^ FaceCut::kIsFace, weights};
}

std::vector<Halving::Whole> faces_for_rays(const Halving& halving) {
  std::vector<std::uint8_t> depth(halving.cuts.size(), 1);
  for (std::size_t c = halving.cuts.size(); c-- > 0;) {
    for (std::size_t i = 0; i < part_count(halving.cuts[c].form); ++i) {
      const std::uint32_t part = halving.cuts[c].parts[i];
      if ((part & FaceCut::kIsFace) == 0) {
        depth[c] = static_cast<std::uint8_t>(std::max<int>(depth[c], std::min(depth[part] + 1, 255)));
      }
    }
  }
  std::vector<Halving::Whole> traced;
  std::vector<Halving::Whole> open;
  for (const Halving::Whole& face : halving.faces) {
    open.assign(1, face);
    while (!open.empty()) {
      const Halving::Whole next = open.back();
      open.pop_back();
      if ((next.part & FaceCut::kIsFace) != 0 || depth[next.part] <= kDeepestCut) {
        traced.push_back(next);
        continue;
      }
      const FaceCut& cut = halving.cuts[next.part];
      const auto& middles = halving.middles[next.part];
      const std::array<std::uint32_t, 6> points = {next.corners[0], next.corners[1], next.corners[2],
                                                   middles[0],      middles[1],      middles[2]};
      const auto faces = faces_of_cut(cut.form, cut.first);
      for (std::size_t i = part_count(cut.form); i-- > 0;) {
        open.push_back({{points[faces[i][0]], points[faces[i][1]], points[faces[i][2]]}, cut.parts[i], next.is_turned});
      }
    }
  }
  return traced;
}

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
  mesh.halving = whole(mesh);
  if (with_ends(mesh, kept) != kept) throw std::invalid_argument("vertices without the ends of their edges");
  mesh.reach = reaches(mesh);
  const KeptParts parts(mesh, kept);
  const std::vector<std::uint32_t> node_of = node_of_faces(mesh);
  std::vector<Face> faces;
  Halving halving;
  for (MeshNode& node : mesh.nodes) node.faces.clear();
  for (const Halving::Whole& face : mesh.halving.faces) {
    const std::size_t first = faces.size();
    halving.faces.push_back({face.corners, parts.append(face.corners, face.is_turned, faces, halving), face.is_turned});
    const std::uint32_t node = node_of[mesh.halving.first_face(face.part)];
    for (std::size_t f = first; f < faces.size() && node != kNoFace; ++f) {
      take_face(mesh.nodes[node], static_cast<std::uint32_t>(f));
    }
  }
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
