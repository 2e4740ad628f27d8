// `prt volume SCENE -o FILE`: the transfer of the space around an object or a medium, at the points of a grid.
#include <fmt/format.h>

#include "numeric/output/atomic_file.hpp"
#include "prt/bake/bake_volume.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/scene_options.hpp"
#include "prt/commands/shard_jobs.hpp"
#include "prt/commands/shared_rays.hpp"
#include "prt/medium/medium_volume.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

struct VolumeCommand {
  std::string scene;
  std::string output;
  std::vector<std::uint32_t> counts = {64, 64, 8};
  std::vector<double> box;  // empty: the default
  VolumeOptions volume;
  std::string sampler = std::string(name_of(Sampler::kFibonacci));
  std::string element = std::string(word_of(Element::kSingle, kElementNames));
  std::size_t memory = 0;  // MiB; 0: the machine's
  std::string instruction_set;
  bool strict = false;
  SharedOptions rays;
  JobOptions job;                  // its count is 0: bake here
  std::vector<std::string> words;  // of a command that makes the whole
  int threads = 0;
};

VolumeOptions volume_options(const VolumeCommand& command) {
  VolumeOptions options = command.volume;
  std::copy_n(command.counts.begin(), options.counts.size(), options.counts.begin());
  options.sampler = value_called<Sampler>(command.sampler, kSamplerNames).value();
  options.element = value_called<Element>(command.element, kElementNames).value();
  options.memory = static_cast<double>(command.memory) * 1048576.0;
  const std::vector<double>& box = command.box;
  if (!box.empty())
    options.box.emplace(Eigen::Vector3d(box[0], box[1], box[2]), Eigen::Vector3d(box[3], box[4], box[5]));
  return options;
}

void report_volume(const Transfer& volume, const VolumeReport& report) {
  if (report.inside > 0) {
    say(fmt::format(
        "{} of {} points are inside solids: {} take the numbers of points outside, {} beside no other stay dark",
        report.inside, volume.receivers(), volume.grid->filled, report.inside - volume.grid->filled));
  }
  const Eigen::AlignedBox3d& box = volume.grid->box;
  say(fmt::format(
      "the box is from {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g}; at its sides the object blocks at "
      "most {:.2g} of the directions, and outside nothing",
      box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z(), report.border));
  say(fmt::format("{} rays traced, {:.0f} MiB at the most", report.bake.rays,
                  static_cast<double>(peak_memory()) / 1048576.0));
}

// A medium is not traced by the ray tracer, and is quick enough to begin again.
void require_medium_options(const VolumeCommand& command, const std::string& name) {
  std::vector<std::string> given = command.rays.given();
  if (!command.instruction_set.empty()) given.emplace_back("--instruction-set");
  if (command.job.count > 0) given.emplace_back("--shards");
  if (given.empty()) return;
  throw std::invalid_argument(
      fmt::format("{}: {}: is for meshes; this scene has a medium: expected no such option", name, given.front()));
}

Transfer medium_volume_to_file(const VolumeCommand& command, const Scene& scene, VolumeReport& report) {
  Transfer volume = bake_medium_volume(scene, volume_options(command), say);
  report.border = blocked_at_border(volume);
  report.bake.rays = volume.receivers() * static_cast<std::size_t>(command.volume.directions);
  write_transfer(command.output, volume);
  return volume;
}

void run_volume(const VolumeCommand& command) {
  const Stopwatch stopwatch;
  require_output(command.output);
  const BakeSettings settings{.threads = command.threads,
                              .instruction_set = command.instruction_set,
                              .on_flaw = on_flaw(command.strict),
                              .checkpoint = command.rays.settings(command.output)};
  const Scene scene = load_scene(command.scene, settings.on_flaw);
  if (scene.medium) require_medium_options(command, scene.name);
  output::require_no_input(command.output, scene.files);
  output::require_no_input(settings.checkpoint.path, scene.files);
  output::require_no_input(command.output, command.rays.parts);
  if (command.job.count > 0) {
    if (command.volume.reflects) say("the merge also bakes what the object reflects, which no estimate holds");
    return print_jobs(command.job, command.words, command.output,
                      estimate_volume(scene, volume_options(command), settings));
  }
  VolumeReport report;
  if (!command.rays.shard.empty()) {
    bake_volume_shard(scene, volume_options(command), settings, &report, say);
    return report_time(stopwatch, fmt::format("traced {} rays of shard {}, into {}", report.bake.rays,
                                              command.rays.shard, command.output));
  }
  const Transfer volume =
      scene.medium ? medium_volume_to_file(command, scene, report)
                   : bake_volume_to_file(command.output, scene, volume_options(command), settings, &report, say);
  report_volume(volume, report);
  report_time(stopwatch, fmt::format("baked {} points, light of degree {}, result of degree {}, {} directions, into {}",
                                     volume.receivers(), volume.degree(), volume.shape.result_degree, volume.directions,
                                     command.output));
}

}  // namespace

void add_volume_command(CLI::App& tool) {
  auto options = std::make_shared<VolumeCommand>();
  CLI::App& command =
      *tool.add_subcommand("volume", "compute what an object or a medium leaves of the light in the space around it");
  command.add_option("SCENE", options->scene, "a scene's JSON file, `demo`, or a mesh file: the object")->required();
  command.add_option("-o,--output", options->output, "transfer file to write")->required();
  command.add_option("--counts", options->counts, "NX,NY,NZ: points of the grid along the axes")
      ->delimiter(',')
      ->expected(3);
  command
      .add_option("--box", options->box,
                  "X,Y,Z,X,Y,Z: lowest and highest corner of the grid; default: as far as the scene's lights cast "
                  "shadows or, without lights, twice the radius of its bounding sphere on every side of the object")
      ->default_str("")
      ->delimiter(',')
      ->expected(6);
  command.add_option("--faintest-shadow", options->volume.faintest_shadow,
                     "the faintest shadow that the default box holds, as a part of the largest irradiance");
  command.add_option("--degree", options->volume.degree, "SH degree of the light, 0 to 5");
  command.add_option("--result-degree", options->volume.result_degree,
                     "SH degree of the radiance that reaches a point, 0 to 5");
  command.add_option("--directions", options->volume.directions, "directions over the whole sphere");
  command.add_option("--sampler", options->sampler, "method that chooses the directions")
      ->check(CLI::IsMember(std::vector<std::string>(kSamplerNames.begin(), kSamplerNames.end())));
  command.add_option("--seed", options->volume.seed, "seed of all samplers except fibonacci")
      ->check(CLI::Range(0, kMaxSeed));
  command.add_option("--element", options->element, "type of the numbers in the file: single, half or byte")
      ->check(CLI::IsMember(std::vector<std::string>(kElementNames.begin(), kElementNames.end())));
  command.add_option("--memory", options->memory, "MiB that the grid may take; 0: the machine's")
      ->check(CLI::Range(0, 1 << 30));
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays: sse4.2, avx, avx2 or avx512; results are reproducible on each");
  command.add_flag("--reflected", options->volume.reflects,
                   "also bake what the object reflects to the points, mirrors and all bounces included: matrices");
  command.add_flag("--strict", options->strict, "refuse meshes that would otherwise be mended with a warning");
  options->rays.add_to(command);
  CLI::Option* const shards = options->job.add_to(command, "--shards");
  shards->description("print the commands that share the rays among so many processes, and stop");
  for (const char* other : {"--shard", "--parts", "--checkpoint", "--no-checkpoint", "--restart"}) {
    shards->excludes(other);
  }
  command.add_option("--threads", options->threads, "number of threads; 0: every core; the file does not depend on it");
  command.callback([options, &command] {
    options->rays.command = words_for_parts(command);
    options->words = words_without(command, {"--shards", "--for", "--output", "--threads", "--price"});
    with_threads(options->threads, [&] { run_volume(*options); });
  });
}

}  // namespace sh::prt
