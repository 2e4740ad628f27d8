// `prt bake SCENE -o FILE`: the transfer vectors of a scene's mesh.
// `prt plan SCENE`: the work that a bake can leave out, its savings and its error.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/bake/bake.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/commands/scene_options.hpp"
#include "prt/commands/shared_rays.hpp"
#include "prt/mesh/mesh_checksum.hpp"
#include "prt/plan/plan_file.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

struct BakeCommand : SceneOptions {
  std::string output;
  std::string vectors;  // empty: none
  std::string instruction_set;
  std::size_t bounce_memory = 4096;  // MiB
  bool strict = false;
  SharedOptions rays;
  bool only_estimate = false;
  std::optional<double> budget_seconds;
  Ranks ranks;
};

struct PlanCommand : SceneOptions {
  std::string output;  // empty: none
  bool json = false;
};

CheckpointSettings checkpoint_of(const BakeCommand& options) {
  SharedOptions shared = options.rays;
  shared.none = shared.none || options.budget_seconds || options.only_estimate;
  return shared.settings(options.output);
}

constexpr double kLittleOfALobe = 0.9;

void print_estimate(const BakeJob& job) {
  const Scene& scene = job.scene;
  const BakeEstimate estimate = estimate_bake(job);
  const bool has_matrices = scene.bake.kind->indirect != nullptr;
  print_json({{"scene", scene.name},
              {"vertices", scene.mesh.positions.size()},
              {"traced_vertices", estimate.vertices},
              {"degree", scene.bake.degree},
              {"directions", scene.bake.directions},
              {"rays", estimate.rays},
              {"seconds", estimate.seconds()},
              {"setup_seconds", estimate.setup_seconds},
              {"first_pass_seconds", estimate.pass_seconds},
              {"bounces", has_matrices ? Json() : Json(estimate.bounces)},  // not estimated
              {"seconds_a_bounce", has_matrices ? Json() : Json(estimate.bounce_seconds)},
              {"form_factor_bytes", estimate.factor_bytes},
              {"bytes", estimate.bytes}});
}

void report_clusters(const Clusters& clusters, const TransferShape& shape, const char* of) {
  if (clusters.empty()) return;
  say(fmt::format(
      "{} of {} clusters of {} vectors: {} bytes a vertex and {:.2f} MiB for all; the numbers lost {:.2g} of "
      "themselves (rms)",
      of, clusters.count(), clusters.vectors, shape.receiver_bytes(),
      static_cast<double>(shape.stored_rows(0) * shape.row_bytes()) / 1048576.0, clusters.error));
}

void report_bake(const Transfer& transfer, const BakeReport& report) {
  for (const Decision& decision : transfer.plan.decisions) {
    say(fmt::format("plan: {}: {} ({:.2g}, {})", decision.name, decision.choice, decision.error, decision.basis));
  }
  if (const BounceReport& bounces = transfer.bounces; transfer.kind->indirect != nullptr) {
    say(fmt::format(
        "{} bounces, each {:.2g} of the one before, {:.2g} left of {:.3g} (measured); matrices of {} bytes a "
        "vertex",
        bounces.applications, bounces.spectral_bound, bounces.residual, bounces.largest,
        transfer.indirect_shape.receiver_bytes()));
  } else if (transfer.kind->has_bounces()) {
    std::string errors = fmt::format("certified error {:.2g} of {:.3g}", bounces.bound, bounces.largest);
    if (!transfer.emitted.empty()) {
      errors += fmt::format(", of emitted light {:.2g} of {:.3g}", bounces.emitted_bound, bounces.emitted_largest);
    }
    say(fmt::format("bounces by {}: {} applications, {} (residual {:.2g}), largest eigenvalue at most {:.4g}",
                    bounces.solver, bounces.applications, errors, bounces.residual, bounces.spectral_bound));
    if (bounces.between_vertices > 0.0) {
      say(fmt::format(
          "the certificate does not cover rays and interpolation: between vertices light is off by {:.2g} of "
          "itself (rms, measured at centers of faces)",
          bounces.between_vertices));
    }
  }
  report_clusters(transfer.clusters, transfer.shape, "rows");
  report_clusters(transfer.indirect_clusters, transfer.indirect_shape, "matrices");
  if (const auto lobe = sharpest_lobe(transfer); lobe && lobe->share < kLittleOfALobe) {
    say(fmt::format("degree {} holds {:.2g} % of the lobe of exponent {:g} (in squares): it shows duller",
                    transfer.degree(), 100.0 * lobe->share, lobe->exponent));
  }
  const std::vector<double> shares = held_shares_of_brdfs(transfer);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] >= kLittleOfALobe) continue;
    say(fmt::format("degree {} holds {:.2g} % of the BRDF `{}` to degree {} (in squares): it shows duller",
                    transfer.degree(), 100.0 * shares[i], transfer.mesh.brdfs.heads[i].name, kMaxDegree));
  }
  say(fmt::format("{} rays traced, {:.0f} MiB at the most", report.rays,
                  static_cast<double>(peak_memory()) / 1048576.0));
}

void require_vectors(const BakeCommand& options, const Scene& scene) {
  if (options.vectors.empty()) return;
  output::require_no_input(options.vectors, scene.files);
  if (std::filesystem::weakly_canonical(options.vectors) == std::filesystem::weakly_canonical(options.output)) {
    throw std::invalid_argument(
        fmt::format("--vectors: expected another file than the output, got {}", options.vectors));
  }
  if (!scene.bake.kind->is_glossy()) {
    throw std::invalid_argument(
        fmt::format("--vectors: the kind {} has vectors already; expected a glossy kind", scene.bake.kind->word));
  }
}

void require_medium_options(const BakeCommand& options, const std::string& name) {
  std::vector<std::string> given = options.given();
  for (const std::string& option : options.rays.given()) given.push_back(option);
  if (!options.vectors.empty()) given.emplace_back("--vectors");
  if (!options.instruction_set.empty()) given.emplace_back("--instruction-set");
  if (options.budget_seconds) given.emplace_back("--budget-seconds");
  for (const std::string& option : given) {
    if (option == "--degree" || option == "--directions") continue;
    throw std::invalid_argument(fmt::format(
        "{}: {}: is for meshes; for a medium expected --degree, --directions or --bounce-memory", name, option));
  }
}

void run_medium_bake(const BakeCommand& options, Scene scene) {
  require_medium_options(options, scene.name);
  options.apply_to(scene);
  const std::size_t memory = options.bounce_memory << 20U;
  if (options.only_estimate) return print_medium_estimate(scene, memory);
  bake_medium_to_file(scene, memory, options.output);
}

void run_shard(const BakeCommand& options, BakeJob job, const Stopwatch& stopwatch) {
  BakeReport report;
  bake_shard(std::move(job), &report, say);
  report_time(stopwatch,
              fmt::format("traced {} rays of shard {}, into {}", report.rays, options.rays.shard, options.output));
}

void run_bake(const BakeCommand& options) {
  const Stopwatch stopwatch;
  if (!options.only_estimate) require_output(options.output);
  if (!options.vectors.empty()) require_output(options.vectors);
  const BakeSettings settings{.threads = options.threads,
                              .instruction_set = options.instruction_set,
                              .on_flaw = on_flaw(options.strict),
                              .bounce_memory = options.bounce_memory << 20U,
                              .checkpoint = checkpoint_of(options),
                              .ranks = options.ranks,
                              .plan_file = options.plan_file()};
  Scene scene = load_scene(options.scene, settings.on_flaw);
  malloc_trim(0);  // what loading freed, which the allocator keeps otherwise
  output::require_no_input(options.output, scene.files);
  output::require_no_input(options.output, {settings.plan_file});
  output::require_no_input(options.output, options.rays.parts);
  if (scene.medium) return run_medium_bake(options, std::move(scene));
  if (!scene.mesh.translucence.empty()) {
    report_flaw(settings.on_flaw,
                scene.name + ": its translucent materials are left out, which only `prt translucent` shows");
  }
  BakeJob job(std::move(scene), settings);
  output::require_no_input(settings.checkpoint.path, job.scene.files);
  output::require_no_input(settings.checkpoint.path, {settings.plan_file});
  options.apply_to(job.scene);
  require_vectors(options, job.scene);
  if (options.only_estimate) return print_estimate(planned(std::move(job)));
  if (options.budget_seconds) job.budget = BakeBudget{*options.budget_seconds, stopwatch};
  BakeReport report;
  if (!options.rays.shard.empty()) return run_shard(options, std::move(job), stopwatch);
  const Transfer transfer = bake_to_file(options.output, std::move(job), &report, say);
  if (!options.ranks.is_first()) return;
  report_bake(transfer, report);
  if (!options.vectors.empty()) write_transfer(options.vectors, diffuse_vectors(transfer));
  report_time(stopwatch, fmt::format("baked {} vertices, {} faces, degree {}, {} directions, into {}",
                                     transfer.mesh.positions.size(), transfer.mesh.faces.size(), transfer.degree(),
                                     transfer.directions, options.output));
}

void run_plan(const PlanCommand& options) {
  const Stopwatch stopwatch;
  if (!options.output.empty()) require_output(options.output);
  Scene scene = load_scene(options.scene, OnFlaw::kMend);
  require_meshes(scene, "a plan");
  output::require_no_input(options.output, scene.files);
  BakeJob job(std::move(scene), {.threads = options.threads, .plan_file = options.plan_file()});
  options.apply_to(job.scene);
  if (options.plan.empty()) job.scene.plan.mode = PlanMode::kLossy;
  const std::string mesh = checksums_of(job.scene.mesh).whole;
  job = planned(std::move(job));
  for (const FittedBrdf& fitted : job.fits) say(described(fitted));
  print_out(options.json ? plan_json(*job.plan, job.scene) + "\n" : plan_text(*job.plan, job.scene));
  if (!options.output.empty()) write_plan(options.output, *job.plan, job.scene, mesh);
  report_time(stopwatch, options.output.empty() ? "planned" : fmt::format("planned, into {}", options.output));
}

}  // namespace

void add_bake_to(CLI::App& tool, const Ranks& ranks) {
  auto options = std::make_shared<BakeCommand>();
  options->ranks = ranks;
  CLI::App& command = *tool.add_subcommand("bake", "compute the transfer vectors of a scene");
  options->add_to(command);
  command.add_option("-o,--output", options->output, "transfer file to write");
  command.add_option(
      "--vectors", options->vectors,
      "glossy kinds: a second transfer file to write, the vectors of diffuse surfaces, from the same run");
  command.add_flag("--estimate", options->only_estimate, "print the estimated time and memory as JSON and stop");
  command
      .add_option("--bounce-memory", options->bounce_memory,
                  "MiB for the hits of rays; further hits are traced again for each bounce, with the same result")
      ->check(CLI::Range(0, 1 << 30));
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays: sse4.2, avx, avx2 or avx512; results are reproducible on each");
  command.add_flag("--strict", options->strict, "refuse meshes that would otherwise be mended with a warning");
  options->rays.add_to(command);
  CLI::Option* budget =
      command
          .add_option("--budget-seconds", options->budget_seconds,
                      "finish in about this time, with fewer directions and a looser tolerance; the file states both")
          ->check(CLI::Range(0.0, 1e9));
  for (const char* other : {"--checkpoint", "--shard", "--parts"}) budget->excludes(other);
  for (const char* other : {"--estimate", "--vectors"}) command.get_option("--shard")->excludes(other);
  command.add_option("--threads", options->threads, "number of threads; 0: every core; the file does not depend on it");
  command.callback([options, &command] {
    if (options->output.empty() && !options->only_estimate) throw CLI::RequiredError("--output");
    options->rays.command = words_for_parts(command);
    with_threads(options->threads, [&] { run_bake(*options); });
  });
}

void add_bake_command(CLI::App& tool) { add_bake_to(tool, {}); }

void add_plan_command(CLI::App& tool) {
  auto options = std::make_shared<PlanCommand>();
  CLI::App& command = *tool.add_subcommand("plan", "list the work that a bake can leave out, and the error");
  options->add_to(command);
  command.add_option("-o,--output", options->output,
                     "file to write, with all decisions for `--plan FILE` of `bake`, `shards` and `plan`");
  command.add_flag("--json", options->json, "print JSON for programs");
  run_with_threads<PlanCommand>(command, options, run_plan);
}

}  // namespace sh::prt
