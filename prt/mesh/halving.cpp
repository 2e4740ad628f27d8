#include "prt/mesh/halving.hpp"

#include <algorithm>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

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
  const std::array<std::uint32_t, 2> none = {kNoVertex, kNoVertex};
  mesh.halving.ends.resize(mesh.positions.size(), none);
  Halving own = part.halving;
  own.ends.resize(part.positions.size(), none);
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

std::uint32_t end_of_faces(const std::vector<FaceCut>& cuts, std::uint32_t part) {
  while ((part & FaceCut::kIsFace) == 0) part = cuts[part].parts[part_count(cuts[part].form) - 1];
  return (part ^ FaceCut::kIsFace) + 1;
}

std::uint32_t first_face(const std::vector<FaceCut>& cuts, std::uint32_t part) {
  while ((part & FaceCut::kIsFace) == 0) part = cuts[part].parts[0];
  return part ^ FaceCut::kIsFace;
}

}  // namespace sh::prt
