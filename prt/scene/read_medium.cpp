// Reads the medium of a scene file.
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

#include "prt/medium/density_file.hpp"
#include "prt/medium/made_density.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

Counts read_counts(const JsonReader& reader) {
  const std::vector<JsonReader> items = reader.items();
  if (items.size() != 3) reader.expected(flaw_of(Counts{0, 0, 0}));
  Counts counts{};
  for (std::size_t a = 0; a < 3; ++a) counts[a] = items[a].integer(1, kMostVoxelsAlong);
  if (const std::string flaw = flaw_of(counts); !flaw.empty()) reader.expected(flaw);
  return counts;
}

// {"made", "counts", "seed"} or {"file", "counts"}
DensityValues read_values(const JsonReader& reader, const std::string& folder, std::string& file) {
  reader.allow({"made", "file", "counts", "seed"});
  std::optional<Counts> counts;
  if (const auto given = reader.find("counts")) counts = read_counts(*given);
  if (const auto name = reader.find("file")) {
    if (reader.find("made") || reader.find("seed"))
      reader.expected("either `file`, or `made` with `counts` and `seed`");
    file = beside(folder, name->text());
    return read_density(file, counts);
  }
  MadeDensity made{};
  static_cast<void>(reader.at("made"));
  reader.take_word("made", made, kMadeDensityNames);
  int seed = 0;
  reader.take("seed", seed, &JsonReader::integer, 0, kMaxSeed);
  if (!counts) counts = read_counts(reader.at("counts"));
  return {*counts, make_density(made, *counts, static_cast<std::uint32_t>(seed))};
}

Eigen::AlignedBox3d read_box(const JsonReader& reader) {
  constexpr double kFarthest = 1e15;
  const std::vector<JsonReader> corners = reader.items();
  const std::string what = "two corners [[x, y, z], [x, y, z]], the second beyond the first along each axis";
  if (corners.size() != 2) reader.expected(what);
  const Eigen::AlignedBox3d box(corners[0].point(), corners[1].point());
  const Eigen::Vector3d sizes = box.sizes();
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(sizes.minCoeff() > 0.0) || farthest > kFarthest || sizes.minCoeff() < 1e-6 * farthest) {
    reader.expected(
        fmt::format("{}, within {:g} of the origin and not thinner than a millionth of that", what, kFarthest));
  }
  return box;
}

// {"henyey_greenstein": g} or "isotropic"
double read_phase(const JsonReader& reader) {
  if (reader.is("string")) {
    static_cast<void>(reader.one_of({"isotropic"}));
    return 0.0;
  }
  reader.allow({"henyey_greenstein"});
  return reader.at("henyey_greenstein").number(-0.95, 0.95, "a mean cosine from -0.95 to 0.95");
}

}  // namespace

Medium read_medium(const JsonReader& reader, const std::string& folder) {
  reader.allow({"density", "box", "extinction", "albedo", "phase"});
  Medium medium;
  reader.take("albedo", medium.albedo, &JsonReader::vector_within, 0.0F, 1.0F);
  reader.take("phase", medium.anisotropy, read_phase);
  const Eigen::AlignedBox3d box = read_box(reader.at("box"));
  const JsonReader extinction = reader.at("extinction");
  const float factor = extinction.positive();
  DensityValues read = read_values(reader.at("density"), folder, medium.file);
  for (float& value : read.values) value *= factor;
  medium.extinction = Density::in_box(read.counts, box, std::move(read.values));
  if (!flaw_of(medium.extinction).empty()) {
    extinction.expected("a factor that with every density makes an extinction below 3.4e38");
  }
  return medium;
}

}  // namespace sh::prt
