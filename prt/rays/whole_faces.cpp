#include "prt/rays/whole_faces.hpp"

#include <algorithm>
#include <utility>

#include "prt/mesh/split_face.hpp"

namespace sh::prt {

namespace {
constexpr std::uint32_t kLeastGap = 64;  // faces that nobody halved between two runs
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

WholeFaces::WholeFaces(const Mesh& mesh) {
  const Halving& halving = mesh.halving;
  cuts_.reserve(halving.cuts.size());
  for (Halving::Whole whole : faces_for_rays(halving)) {
    const std::uint32_t first = halving.first_face(whole.part);
    if (runs_.empty() || first - runs_.back().end >= kLeastGap) {
      runs_.push_back({runs_.empty() ? first : runs_.back().behind(first), wholes_.size(), 0, first, first});
    }
    Run& run = runs_.back();
    for (std::uint32_t f = run.end; f < first; ++f) wholes_.push_back({mesh.faces[f], f | FaceCut::kIsFace});
    run.end = end_of_faces(halving.cuts, whole.part);
    whole.part = copy(halving.cuts, whole.part);
    wholes_.push_back(whole);
    run.count = static_cast<std::uint32_t>(wholes_.size() - run.whole);
  }
}

std::uint32_t WholeFaces::copy(const std::vector<FaceCut>& from, std::uint32_t part) {
  if ((part & FaceCut::kIsFace) != 0) return part;
  const auto cut = static_cast<std::uint32_t>(cuts_.size());
  cuts_.push_back(from[part]);
  for (std::size_t i = 0; i < part_count(from[part].form); ++i) {
    const std::uint32_t copied = copy(from, from[part].parts[i]);
    cuts_[cut].parts[i] = copied;
  }
  return cut;
}

std::vector<Face> WholeFaces::traced(const std::vector<Face>& faces) const {
  std::vector<Face> traced;
  std::uint32_t next = 0;
  const auto take_uncut = [&](std::size_t end) {
    traced.insert(traced.end(), faces.begin() + next, faces.begin() + static_cast<std::ptrdiff_t>(end));
  };
  for (const Run& run : runs_) {
    take_uncut(run.face);
    for (std::size_t w = run.whole; w < run.whole + run.count; ++w) {
      const auto& [a, b, c] = wholes_[w].corners;
      traced.push_back(wholes_[w].is_turned ? Face{a, c, b} : Face{a, b, c});
    }
    next = run.end;
  }
  take_uncut(faces.size());
  return traced;
}

std::uint32_t WholeFaces::count_before(std::uint32_t face) const {
  const auto later = std::partition_point(runs_.begin(), runs_.end(), [&](const Run& run) { return run.face <= face; });
  if (later == runs_.begin()) return face;
  const Run& run = *std::prev(later);
  if (face >= run.end) return run.behind(face);
  const auto first = wholes_.begin() + static_cast<std::ptrdiff_t>(run.whole);
  const auto place = std::partition_point(
      first, first + run.count, [&](const Halving::Whole& whole) { return first_face(cuts_, whole.part) < face; });
  return run.traced + static_cast<std::uint32_t>(place - first);
}

Hit WholeFaces::hit_of_mesh(const Hit& hit) const {
  const auto later =
      std::partition_point(runs_.begin(), runs_.end(), [&](const Run& run) { return run.traced <= hit.face; });
  if (later == runs_.begin()) return hit;
  const Run& run = *std::prev(later);
  const std::uint32_t place = hit.face - run.traced;
  if (place >= run.count) return {run.end + (place - run.count), hit.u, hit.v, hit.distance, hit.from_behind};
  const Halving::Whole& whole = wholes_[run.whole + place];
  const auto u = static_cast<double>(hit.u);
  const auto v = static_cast<double>(hit.v);
  std::array<double, 3> weights = {1.0 - u - v, u, v};
  if (whole.is_turned) std::swap(weights[1], weights[2]);
  PlaceInFace found = located(cuts_, whole.part, weights);
  if (whole.is_turned) std::swap(found.weights[1], found.weights[2]);
  return {found.face, static_cast<float>(found.weights[1]), static_cast<float>(found.weights[2]), hit.distance,
          hit.from_behind};
}

}  // namespace sh::prt
