// `prt bake SCENE -o FILE`: the transfer vectors of a scene's mesh.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/bake/budget.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/commands.hpp"
#include "prt/plan/plan.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"

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
  if (!settings.path.empty()) {
    require_writable(settings.path);
  }
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

void report_plan(const Plan& plan) {
  for (const Decision& decision : plan.record.decisions) {
    fmt::print(stderr, "prt: plan: {}: {} ({:.2g}, {})\n", decision.name, decision.choice, decision.error,
               decision.basis);
  }
}

constexpr double kMiB = 1048576.0;

void print_estimate(const Scene& scene, const BakeEstimate& estimate) {
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
  std::cout << json.dump(2) << '\n' << std::flush;
  if (!std::cout) {
    throw std::runtime_error("standard output: cannot write");
  }
}

void say_estimate(const BakeEstimate& estimate) {
  constexpr double kWorthSaying = 2.0;  // seconds
  if (estimate.seconds() < kWorthSaying) {
    return;
  }
  fmt::print(stderr, "prt: about {:.2g} s, {:.0f} MiB: {:.3g} million rays{}\n", estimate.seconds(),
             static_cast<double>(estimate.bytes) / kMiB, estimate.rays * 1e-6,
             estimate.bounces > 0.0 ? fmt::format(", {:.0f} bounces", estimate.bounces) : "");
}

// Fewer directions and a deadline for the bounces, where there is a budget.
void take_budget(const Options& options, const BakeEstimate& estimate, double spent, BakeOptions& bake) {
  if (!options.budget_seconds) {
    return;
  }
  const int wanted = bake.directions;
  bake = within_budget(bake, estimate, *options.budget_seconds - spent);
  const auto left = std::chrono::duration<double>(*options.budget_seconds - spent);
  bake.bounces.deadline =
      std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(left);
  if (bake.directions < wanted) {
    fmt::print(stderr, "prt: {} of {} directions fit into {} s\n", bake.directions, wanted, *options.budget_seconds);
  }
}

void run(const Options& options) {
  const Stopwatch stopwatch;
  if (!options.only_estimate) {
    require_writable(options.output);
  }
  BakeSettings settings = settings_of(options);
  Scene scene = load_scene(options.scene, settings.on_flaw);
  options.bake.apply_to(scene.bake);
  Plan plan = make_plan(scene, options.plan.applied_to(scene.plan), settings);
  const BakeOptions wanted = plan.bake;
  if (wanted.kind != TransferKind::kUnshadowed) {
    scene.bake = plan.bake;
    settings.open = plan.open;
    const BakeEstimate estimate = estimate_bake(scene, settings);
    if (options.only_estimate) {
      print_estimate(scene, estimate);
      return;
    }
    say_estimate(estimate);
    take_budget(options, estimate, stopwatch.seconds(), plan.bake);
  }
  BakeReport report;
  Transfer transfer = bake_planned(scene, plan, settings, &report);
  transfer.missing = shortfall(wanted, transfer);
  report_plan(plan);
  if (transfer.kind == TransferKind::kInterreflected) {
    report_bounces(transfer.bounces);
  }
  write_transfer(options.output, transfer);
  if (!report.checkpoint.empty()) {
    std::filesystem::remove(report.checkpoint);
  }
  fmt::print(stderr, "prt: {} rays traced, {:.0f} MiB at the most\n", report.rays,
             static_cast<double>(peak_memory()) / kMiB);
  stopwatch.report(fmt::format("baked {} vertices, {} faces, degree {}, {} directions, into {}",
                               transfer.mesh.positions.size(), transfer.mesh.faces.size(), transfer.degree,
                               transfer.directions, options.output));
}

void add_checkpoint_to(CLI::App& command, Options& options) {
  auto* path = command.add_option("--checkpoint", options.checkpoint,
                                  "where a bake that is stopped leaves what it has; the same command goes on from "
                                  "there; default: the output's name with .part");
  command
      .add_option("--budget-seconds", options.budget_seconds,
                  "be done in about this time: with fewer directions and a looser tolerance, which the file states")
      ->check(CLI::Range(0.0, 1e9))
      ->excludes(path);
  command.add_flag("--no-checkpoint", options.no_checkpoint, "leave nothing")->excludes(path);
  command.add_flag("--restart", options.restart, "throw the checkpoint away and start afresh");
  command
      .add_option("--checkpoint-seconds", options.checkpoint_seconds,
                  "the most work that is lost when the process is killed")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
}

}  // namespace

void add_bake_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("bake", "compute the transfer vectors of a scene");
  command->add_option("SCENE", options->scene, "a scene's JSON file, or `demo`, the embedded scene")->required();
  auto* output = command->add_option("-o,--output", options->output, "transfer file to write");
  command->add_flag("--estimate", options->only_estimate, "print time and memory that it would take, as JSON");
  options->bake.add_to(*command);
  command
      ->add_option("--bounce-memory", options->bounce_memory,
                   "MiB for what rays hit; what does not fit is traced again for each bounce, with the same result")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "0: every core; the file does not depend on it")
      ->capture_default_str();
  command->add_option("--instruction-set", options->instruction_set,
                      "of the rays: sse4.2, avx, avx2 or avx512; bits are reproducible on each");
  options->plan.add_to(*command);
  command->add_flag("--strict", options->strict, "refuse meshes that would otherwise be mended with a warning");
  add_checkpoint_to(*command, *options);
  command->callback([options, output] {
    if (output->empty() && !options->only_estimate) {
      throw CLI::RequiredError("--output");
    }
    with_threads(options->threads, [&] { run(*options); });
  });
}

}  // namespace sh::prt
