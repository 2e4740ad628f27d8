// `prt probes SUBJECT --counts X,Y,Z -o FILE`: light probes on a grid in a lit scene, for engines.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/lit_place.hpp"
#include "prt/formats/formats.hpp"
#include "prt/mesh/frame.hpp"
#include "prt/runtime/probe_grid.hpp"
#include "prt/say.hpp"
#include "prt/scene/coefficients_json.hpp"

namespace sh::prt {
namespace {

struct ProbesCommand {
  LitPlaceOptions place;
  std::string output;
  std::vector<std::uint32_t> counts = {8, 8, 4};
  std::vector<double> box;  // empty: around the meshes
  std::string format;       // empty: the project's coefficients
  std::size_t check = 64;   // points
  int threads = 0;
};

// The box of the options. Around meshes, half a spacing inside of their bounds: no probe lies in a wall.
PointGrid grid_of(const ProbesCommand& options, const Mesh& mesh) {
  PointGrid grid;
  for (const std::uint32_t count : options.counts) {
    if (count >= kFewestAlong && count <= kMostAlong) continue;
    throw std::invalid_argument(fmt::format("--counts {}: expected {} to {} along each axis",
                                            fmt::join(options.counts, ","), kFewestAlong, kMostAlong));
  }
  std::copy_n(options.counts.begin(), grid.counts.size(), grid.counts.begin());
  const std::vector<double>& box = options.box;
  if (!box.empty()) {
    grid.box = {Eigen::Vector3d(box[0], box[1], box[2]), Eigen::Vector3d(box[3], box[4], box[5])};
    return grid;
  }
  grid.box = bounding_box(points_of(mesh));
  const Eigen::Vector3d margin =
      0.5 * grid.box.sizes().cwiseQuotient(Eigen::Vector3d(grid.counts[0], grid.counts[1], grid.counts[2]));
  grid.box = {grid.box.min() + margin, grid.box.max() - margin};
  return grid;
}

// Formats that are JSON: a probe is then what `prt export` writes.
const formats::LightFormat* format_of(const ProbesCommand& options) {
  if (options.format.empty()) return nullptr;
  std::vector<std::string_view> names;
  for (const formats::LightFormat& format : formats::light_formats()) {
    if (format.ending != ".json") continue;
    names.push_back(format.name);
    if (format.name != options.format) continue;
    if (options.place.degree > format.degree) {
      throw std::invalid_argument(
          fmt::format("--degree {}: {} holds degrees up to {}", options.place.degree, format.name, format.degree));
    }
    return &format;
  }
  throw std::invalid_argument(fmt::format("--to {}: expected a format of {}", options.format, fmt::join(names, ", ")));
}

Json probe_json(const LightCoefficients& light, const formats::LightFormat* format) {
  if (format == nullptr) return coefficients_json(light)["coefficients"];
  return Json::parse(format->write({format->convention.to(light), &format->convention, &light}));
}

Json grid_json(const ProbeGrid& probes) {
  return {{"low", json_of(probes.grid.box.min())},
          {"high", json_of(probes.grid.box.max())},
          {"counts", probes.grid.counts},
          {"order", "x fastest, then y, then z; the first probe is at low, the last at high"},
          {"filled", probes.grid.filled}};
}

Json errors_json(const ProbeErrors& errors) {
  return {{"points", errors.points}, {"rms", errors.rms}, {"largest", errors.largest}, {"at", json_of(errors.where)}};
}

void run_probes(const ProbesCommand& options) {
  const Stopwatch stopwatch;
  require_output(options.output, {".json"});
  const formats::LightFormat* format = format_of(options);
  const LitPlace place(options.place);
  place.subject().require_no_input(options.output);
  const LightSampler sampler = place.sampler(options.place.size);
  const ProbeGrid probes = sample_probes(sampler, grid_of(options, place.mesh()), options.place.degree);
  Json out = {{"type", "probes"}, {"degree", options.place.degree}};
  if (format == nullptr) {
    Json meaning = coefficients_json(probes.light.front());
    for (const char* key : {"type", "degree", "coefficients"}) meaning.erase(key);
    out.update(meaning);
  } else {
    out["format"] = format->name;
  }
  out["grid"] = grid_json(probes);
  out["valid"] = probes.valid;
  if (options.check > 0) {
    const ProbeErrors errors = measure_probes(sampler, probes, options.check, 1);
    out["errors_between_probes"] = errors_json(errors);
    say(
        fmt::format("between probes, at {} points outside of solids, the light is off by {:.2g} (root mean square) and "
                    "{:.2g} (largest, at {:.3g} {:.3g} {:.3g})",
                    errors.points, errors.rms, errors.largest, errors.where.x(), errors.where.y(), errors.where.z()));
  }
  for (const LightCoefficients& light : probes.light) out["probes"].push_back(probe_json(light, format));
  output::write_file(options.output, out.dump(1) + "\n");
  const auto valid = std::count(probes.valid.begin(), probes.valid.end(), 1);
  report_time(stopwatch,
              fmt::format("sampled {} probes of degree {}, {} outside of solids, {} filled, into {}",
                          probes.light.size(), options.place.degree, valid, probes.grid.filled, options.output));
}

}  // namespace

void add_probes_command(CLI::App& tool) {
  auto options = std::make_shared<ProbesCommand>();
  CLI::App& command = *tool.add_subcommand("probes", "write light probes on a grid in a lit scene, for engines");
  options->place.add_to(command);
  command.add_option("-o,--output", options->output, "JSON file to write")->required();
  command.add_option("--counts", options->counts, "X,Y,Z: probes along each axis")->delimiter(',')->expected(3);
  command.add_option("--box", options->box, "x,y,z,X,Y,Z: the first and the last probe; default: within the meshes")
      ->default_str("")
      ->delimiter(',')
      ->expected(6);
  command.add_option("--to", options->format,
                     "format of an engine for each probe; default: as `prt project` prints it");
  command
      .add_option("--check", options->check, "points at which interpolated probes are compared with the light; 0: none")
      ->check(CLI::Range(0, 1'000'000));
  run_with_threads(command, options, run_probes);
}

}  // namespace sh::prt
