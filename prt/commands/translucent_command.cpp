// `prt translucent SCENE -o FILE`: the transfer of bodies that let light through, or their thickness.
#include <fmt/format.h>

#include "numeric/output/atomic_file.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/commands/scene_options.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/translucent/bake_translucent.hpp"

namespace sh::prt {
namespace {

struct TranslucentCommand : DirectionOptions {
  std::string output;
  bool thickness = false;
  std::string instruction_set;
  bool strict = false;
  CheckpointOptions checkpoint;
  int threads = 0;
};

void run_translucent(const TranslucentCommand& options) {
  const Stopwatch stopwatch;
  require_output(options.output);
  BakeSettings settings{
      .threads = options.threads, .instruction_set = options.instruction_set, .on_flaw = on_flaw(options.strict)};
  if (!options.thickness) settings.checkpoint = options.checkpoint.settings(options.output);
  Scene scene = load_scene(options.scene, settings.on_flaw);
  require_meshes(scene, "light through bodies");
  output::require_no_input(options.output, scene.files);
  output::require_no_input(settings.checkpoint.path, scene.files);
  options.apply_to(scene.bake);
  BakeJob job(std::move(scene), settings);
  BakeReport report;
  Transfer transfer;
  if (options.thickness) {
    transfer = bake_thickness(std::move(job), &report);
    write_transfer(options.output, transfer);
  } else {
    transfer = bake_translucent_to_file(options.output, std::move(job), &report, say);
  }
  say(fmt::format("{} rays traced, {:.0f} MiB at the most", report.rays,
                  static_cast<double>(peak_memory()) / 1048576.0));
  report_time(stopwatch,
              fmt::format("baked {}{} vertices, {} faces, degree {}, {} directions, into {}",
                          options.thickness ? "the thickness of " : "", transfer.mesh.positions.size(),
                          transfer.mesh.faces.size(), transfer.degree(), transfer.directions, options.output));
}

}  // namespace

void add_translucent_command(CLI::App& tool) {
  auto options = std::make_shared<TranslucentCommand>();
  CLI::App& command = *tool.add_subcommand(
      "translucent", "compute the transfer of bodies that let light through, or their thickness by direction");
  options->add_to(command);
  command.add_option("-o,--output", options->output, "transfer file to write")->required();
  command.add_flag("--thickness", options->thickness,
                   "the distance through the body by direction, in the scene's unit, instead; of any material");
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays: sse4.2, avx, avx2 or avx512; results are reproducible on each");
  command.add_flag("--strict", options->strict, "refuse meshes that would otherwise be mended with a warning");
  options->checkpoint.add_to(command);
  run_with_threads(command, options, run_translucent, "; the file does not depend on it");
}

}  // namespace sh::prt
