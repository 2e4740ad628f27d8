// `prt bake SCENE -o FILE`: the transfer vectors of a scene's mesh.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/commands.hpp"
#include "prt/plan/plan.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string scene;
  std::string output;
  BakeOverrides bake;
  std::string instruction_set;
  int threads = 0;
  std::size_t bounce_memory = 4096;  // MiB
  bool strict = false;
  std::string checkpoint;  // empty: beside the output
  bool no_checkpoint = false;
  bool restart = false;
  double checkpoint_seconds = CheckpointSettings().seconds;
  PlanArguments plan;
  bool only_estimate = false;
  std::optional<double> budget_seconds;
};

void report_bounces(const BounceReport& bounces) {
  fmt::print(stderr,
             "prt: bounces by {}: {} applications, certified error {:.2g} of {:.3g} (residual {:.2g}), largest "
             "eigenvalue at most {:.4g}\n",
             bounces.solver, bounces.applications, bounces.bound, bounces.largest, bounces.residual,
             bounces.spectral_bound);
}

CheckpointSettings checkpoint_of(const Options& options) {
  CheckpointSettings settings{options.checkpoint, options.restart, options.checkpoint_seconds};
  const bool is_special = std::filesystem::exists(options.output) && !std::filesystem::is_regular_file(options.output);
  if (settings.path.empty() && !options.no_checkpoint && !is_special && !options.budget_seconds &&
      !options.only_estimate) {
    settings.path = options.output + ".part";
  }
  if (!settings.path.empty()) require_writable(settings.path);
  return settings;
}

BakeSettings settings_of(const Options& options) {
  BakeSettings settings;
  settings.threads = options.threads;
  settings.instruction_set = options.instruction_set;
  settings.on_flaw = options.strict ? OnFlaw::kRefuse : OnFlaw::kMend;
  settings.bounce_memory = options.bounce_memory * (std::size_t{1} << 20U);
  settings.checkpoint = checkpoint_of(options);
  return settings;
}

void report_plan(const PlanRecord& plan) {
  for (const Decision& decision : plan.decisions) {
    fmt::print(stderr, "prt: plan: {}: {} ({:.2g}, {})\n", decision.name, decision.choice, decision.error,
               decision.basis);
  }
}

void print_estimate(const BakeJob& job) {
  const Scene& scene = job.scene;
  const BakeEstimate estimate = estimate_bake(job);
  const nlohmann::ordered_json json = {{"scene", scene.name},
                                       {"vertices", scene.mesh.positions.size()},
                                       {"traced_vertices", estimate.vertices},
                                       {"degree", scene.bake.degree},
                                       {"directions", scene.bake.directions},
                                       {"rays", estimate.rays},
                                       {"seconds", estimate.seconds()},
                                       {"setup_seconds", estimate.setup_seconds},
                                       {"first_pass_seconds", estimate.pass_seconds},
                                       {"bounces", estimate.bounces},
                                       {"seconds_a_bounce", estimate.bounce_seconds},
                                       {"form_factor_bytes", estimate.factor_bytes},
                                       {"bytes", estimate.bytes}};
  print_out(json.dump(2) + "\n");
}

void run(const Options& options) {
  const Stopwatch stopwatch;
  if (!options.only_estimate) require_writable(options.output);
  const BakeSettings settings = settings_of(options);
  BakeJob job(load_scene(options.scene, settings.on_flaw), settings);
  options.bake.apply_to(job.scene.bake);
  job.scene.plan = options.plan.applied_to(job.scene.plan);
  if (options.only_estimate) {
    print_estimate(planned(std::move(job)));
    return;
  }
  if (options.budget_seconds) job.budget = BakeBudget{*options.budget_seconds, stopwatch};
  BakeReport report;
  const Transfer transfer = bake_to_file(options.output, std::move(job), &report,
                                         [](const std::string& line) { fmt::print(stderr, "prt: {}\n", line); });
  report_plan(transfer.plan);
  if (transfer.kind->has_bounces()) report_bounces(transfer.bounces);
  fmt::print(stderr, "prt: {} rays traced, {:.0f} MiB at the most\n", report.rays,
             static_cast<double>(peak_memory()) / 1048576.0);
  report_time(stopwatch, fmt::format("baked {} vertices, {} faces, degree {}, {} directions, into {}",
                                     transfer.mesh.positions.size(), transfer.mesh.faces.size(), transfer.degree(),
                                     transfer.directions, options.output));
}

void add_checkpoint_to(CLI::App& command, Options& options) {
  auto* path = command.add_option("--checkpoint", options.checkpoint,
                                  "file in which a stopped bake saves its results; the same command continues from "
                                  "there; default: the output's name with .part");
  command
      .add_option("--budget-seconds", options.budget_seconds,
                  "finish in about this time, with fewer directions and a looser tolerance; the file states both")
      ->check(CLI::Range(0.0, 1e9))
      ->excludes(path);
  command.add_flag("--no-checkpoint", options.no_checkpoint, "write no checkpoint")->excludes(path);
  command.add_flag("--restart", options.restart, "delete the checkpoint and start again");
  command
      .add_option("--checkpoint-seconds", options.checkpoint_seconds,
                  "seconds of work that a killed process loses at most")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
}

}  // namespace

void add_bake_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("bake", "compute the transfer vectors of a scene");
  command->add_option("SCENE", options->scene, "a scene's JSON file, or `demo`, the embedded scene")->required();
  auto* output = command->add_option("-o,--output", options->output, "transfer file to write");
  command->add_flag("--estimate", options->only_estimate, "print the estimated time and memory as JSON and stop");
  options->bake.add_to(*command);
  command
      ->add_option("--bounce-memory", options->bounce_memory,
                   "MiB for the hits of rays; further hits are traced again for each bounce, with the same result")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "number of threads; 0: every core; the file does not depend on it")
      ->capture_default_str();
  command->add_option("--instruction-set", options->instruction_set,
                      "instruction set for rays: sse4.2, avx, avx2 or avx512; results are reproducible on each");
  options->plan.add_to(*command);
  command->add_flag("--strict", options->strict, "refuse meshes that would otherwise be mended with a warning");
  add_checkpoint_to(*command, *options);
  command->callback([options, output] {
    if (output->empty() && !options->only_estimate) throw CLI::RequiredError("--output");
    with_threads(options->threads, [&] { run(*options); });
  });
}

}  // namespace sh::prt
