#include "prt/bake/bake.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/bake/compress.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/bake/glossy_bounces.hpp"
#include "prt/bake/gray.hpp"
#include "prt/bake/steps.hpp"
#include "prt/chunks.hpp"
#include "prt/plan/measure.hpp"
#include "prt/plan/plan_file.hpp"
#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {

namespace {

void check(const BakeJob& job) {
  const BakeOptions& options = job.scene.bake;
  constexpr KindName kWord = &TransferKind::word;  // other commands make some of the known kinds
  if (find_kind(kWord, options.kind->word, file_kinds()) != find_kind(kWord, options.kind->word)) {
    throw std::invalid_argument(fmt::format("{}: `prt bake` does not make transfer of the kind {}; expected one of {}",
                                            job.scene.name, options.kind->word, fmt::join(kind_names(kWord), ", ")));
  }
  if (const int highest = options.kind->highest_degree; options.degree < 0 || options.degree > highest) {
    const std::string whose = highest < kMaxDegree ? fmt::format(" (of the kind {})", options.kind->word) : "";
    throw std::invalid_argument(fmt::format("degree: expected 0 to {}{}, got {}", highest, whose, options.degree));
  }
  if (job.settings.threads < 0) {
    throw std::invalid_argument(fmt::format("threads: expected 0 (every core) or more, got {}", job.settings.threads));
  }
  const Mesh& mesh = job.scene.mesh;
  if (mesh.faces.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the mesh has no faces, expected at least one triangle", job.scene.name));
  }
  if (options.kind->is_glossy() && options.sampler == Sampler::kCosine) {
    throw std::invalid_argument(fmt::format(
        "{}: the sampler cosine has few directions near the horizon, which glossy transfer needs; expected another one",
        job.scene.name));
  }
  if (options.kind->is_glossy() && !mesh.mirror.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: its mirrors turn light into other directions, which glossy transfer cannot hold; expected no "
                    "mirrors, or a diffuse kind",
                    job.scene.name));
  }
  if (!options.kind->is_glossy() && !job.scene.normal_map_entry.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: {} holds the cosine about the normals of vertices, which a normal map cannot turn; expected "
                    "{}, {} or {}, or no normal map",
                    job.scene.normal_map_entry, options.kind->word, kGlossyUnshadowed.word, kGlossyShadowed.word,
                    kGlossyInterreflected.word));
  }
  if (options.kind->indirect != nullptr && !mesh.emission.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: its surfaces shine, and {} does not bounce their light; expected no emission, or a kind of {} or {}",
        job.scene.name, options.kind->word, kGlossyShadowed.word, kInterreflected.word));
  }
  const auto coefficients = static_cast<int>(coefficient_count(options.degree));
  if (options.kind->indirect != nullptr && options.bounces.directions > 0 &&
      options.bounces.directions < coefficients) {
    throw std::invalid_argument(
        fmt::format("{}: bounce_directions: {} directions cannot tell the {} coefficients of degree {} apart; expected "
                    "at least {}",
                    job.scene.name, options.bounces.directions, coefficients, options.degree, coefficients));
  }
  if (options.kind->indirect != nullptr) require_glossy_bounce_memory(job.scene, memory_of_machine());
  if (options.compress.clusters > kMostClusters || options.compress.vectors > kMostVectors) {
    throw std::invalid_argument(fmt::format("compress: expected 1 to {} clusters of 0 to {} vectors, got {} of {}",
                                            kMostClusters, kMostVectors, options.compress.clusters,
                                            options.compress.vectors));
  }
  if (options.compress_by_plan && job.scene.plan.mode != PlanMode::kLossy) {
    throw std::invalid_argument(fmt::format(
        "{}: compress: only a plan with an error chooses counts of clusters; expected one (lossy), or counts",
        job.scene.name));
  }
  if (!options.kind->stores_visibility() && options.keep != KeptBands()) {
    throw std::invalid_argument(fmt::format("{}: keep: {} stores no visibility and no matrices; expected {} or {}",
                                            job.scene.name, options.kind->word, kGlossyShadowed.word,
                                            kGlossyInterreflected.word));
  }
  const KeptBands& keep = options.keep;
  if (!options.kind->stores_matrices() && (keep.result != KeptBands().result || keep.light != KeptBands().light)) {
    throw std::invalid_argument(fmt::format("{}: keep: {} has no matrices with result and light; expected {}",
                                            job.scene.name, options.kind->word, kGlossyInterreflected.word));
  }
  if (std::min({keep.visibility, keep.result, keep.light}) < 0) {
    throw std::invalid_argument(
        fmt::format("keep: expected bands of 0 or more, got {}, {} and {}", keep.visibility, keep.result, keep.light));
  }
  const bool compresses = options.compress.clusters > 0 || options.compress_by_plan;
  if (compresses && options.kind->shape(options.degree).length() == 0) {
    throw std::invalid_argument(
        fmt::format("{}: {} stores no numbers to compress; expected another kind, or no `compress`", job.scene.name,
                    options.kind->word));
  }
  if (job.plan && !job.plan->open.empty() && job.plan->open.size() != mesh.positions.size()) {
    throw std::invalid_argument(
        fmt::format("{} marks of open vertices for {} vertices", job.plan->open.size(), mesh.positions.size()));
  }
}

// Without the mesh. whole: the scene, or the one whose channel it is. tracer: of the scene, or null.
Transfer run_steps(const Scene& scene, const Scene& whole, const BakeSettings& settings, const Plan& plan,
                   const std::shared_ptr<Tracer>& tracer, BakeReport& report) {
  if (!settings.ranks.is_first() && !scene.bake.kind->has_form_factors()) return {};
  const std::uint64_t rays_before = tracer ? tracer->rays() : 0;
  BakeRun run(scene, whole, settings, plan.open, tracer);
  try {
    for (const BakeStep& step : scene.bake.kind->steps) {
      step.run(run);
      if (run.rays && !settings.checkpoint.shard.is_whole()) break;  // the parts of the others are needed to go on
    }
  } catch (const output::Interrupted&) {
    if (!run.checkpoint) throw;
    throw output::Interrupted(run.checkpoint->interrupted());
  }
  if (run.rays) {
    report.rays += run.rays->tracer.rays() - rays_before;
    report.checkpoint = settings.checkpoint.path;
    report.bounces = bounces_file(settings.checkpoint);
  }
  if (run.checkpoint) report.kept = run.checkpoint->interrupted();
  return std::move(run.transfer);
}

// Takes channel `c` and the worse value of each number of the report.
void take_channel(const Transfer& from, int c, Transfer& to) {
  const std::size_t count = to.shape.count();
  for (std::size_t at = c * count; at < to.coefficients.size(); at += to.shape.length()) {
    std::copy_n(from.coefficients.data() + at, count, to.coefficients.data() + at);
  }
  for (std::size_t v = 0; v < to.emitted.size(); ++v) to.emitted[v][c] = from.emitted[v][c];
  to.bounces.applications = std::max(to.bounces.applications, from.bounces.applications);
  to.bounces.certified = to.bounces.certified && from.bounces.certified;
  using Report = BounceReport;
  for (const auto number : {&Report::bound, &Report::residual, &Report::largest, &Report::spectral_bound,
                            &Report::emitted_bound, &Report::emitted_largest, &Report::between_vertices}) {
    to.bounces.*number = std::max(to.bounces.*number, from.bounces.*number);
  }
}

// Each channel is a separate bake. The single channel of shadowed transfer cannot hold the color of the mirrors.
Transfer run_by_channel(const BakeJob& job, const std::shared_ptr<Tracer>& tracer, BakeReport& report) {
  if (job.scene.bake.kind->shape(job.scene.bake.degree).channels == 1) {
    throw std::invalid_argument(fmt::format(
        "{}: its mirrors have colors, which shadowed transfer cannot hold; expected gray mirrors, or interreflected",
        job.scene.name));
  }
  BakeSettings settings = job.settings;
  const bool has_result = settings.checkpoint.shard.is_whole() && settings.ranks.is_first();
  Transfer transfer;
  for (int c = 0; c < 3; ++c) {
    Scene scene = job.scene;
    scene.mesh = in_gray(std::move(scene.mesh), c);
    settings.checkpoint.channel = static_cast<std::uint32_t>(c);
    settings.checkpoint.restart = job.settings.checkpoint.restart && c == 0;  // the others stand in the same file
    Transfer channel = run_steps(scene, job.scene, settings, *job.plan, tracer, report);
    if (!has_result) continue;
    if (c == 0) {
      transfer = std::move(channel);
    } else {
      take_channel(channel, c, transfer);
    }
  }
  return transfer;
}

// Sets fewer directions and a deadline for the bounces if there is a budget. Returns a tracer of the scene, if it made one.
std::shared_ptr<Tracer> prepare(BakeJob& job, const BakeObserver& say) {
  constexpr double kWorthSaying = 2.0;  // seconds
  if (!traces_here(job.scene, job.settings) || (!say && !job.budget)) return {};
  if (!job.settings.checkpoint.shard.is_whole()) return {};  // each shard would measure the same again
  const BakeEstimate estimate = estimate_bake(job);
  if (say && estimate.seconds() >= kWorthSaying) {
    say(fmt::format("about {:.2g} s, {:.0f} MiB: {:.3g} million rays{}", estimate.seconds(),
                    static_cast<double>(estimate.bytes) / 1048576.0, estimate.rays * 1e-6,
                    estimate.bounces > 0.0                     ? fmt::format(", {:.0f} bounces", estimate.bounces)
                    : job.scene.bake.kind->indirect != nullptr ? ", bounces not counted"
                                                               : ""));
  }
  if (const std::size_t shared = estimate.tracer->shared_faces(); say && shared > 0) {
    say(fmt::format("{:.3g} million faces of copies share the trees of their originals",
                    1e-6 * static_cast<double>(shared)));
  }
  if (!job.budget) return estimate.tracer;
  const auto& [seconds, spent] = *job.budget;
  const int wanted = job.scene.bake.directions;
  job.scene.bake = within_budget(job.scene.bake, estimate, seconds - spent.seconds());
  job.scene.bake.bounces.deadline = spent.after(seconds);
  if (say && job.scene.bake.directions < wanted) {
    say(fmt::format("{} of {} directions fit into {} s", job.scene.bake.directions, wanted, seconds));
  }
  return estimate.tracer;
}

void take_plan(const Plan& plan, Transfer& transfer) {
  transfer.plan = plan.record;
  transfer.shape.storage = plan.storage;
  if (plan.storage.element != Element::kByte) return;
  if ((largest_numbers(transfer.coefficients, plan.largest.size()) > as_array(plan.largest)).any()) {
    transfer.shape.storage.element = Element::kHalf;  // an outlier would coarsen every other number of its column
  }
}

// What files lose by clusters: complete rows, each a difference.
Transfer lost_by(const Transfer& clustered, const Transfer& transfer) {
  Transfer lost = transfer;
  const auto subtract = [](std::vector<float>& from, const std::vector<float>& what) {
    as_array(from) = as_array(what) - as_array(from);
  };
  if (!clustered.clusters.empty()) {
    subtract(lost.coefficients, clustered.clusters.rows());
  } else if (clustered.shape.storage.element != transfer.shape.storage.element) {
    subtract(lost.coefficients, decode(encode(transfer.coefficients, clustered.shape), clustered.shape));
  } else {
    std::fill(lost.coefficients.begin(), lost.coefficients.end(), 0.0F);
  }
  if (!clustered.indirect_clusters.empty()) subtract(lost.indirect, clustered.indirect_clusters.rows());
  return lost;
}

std::int64_t stored_bytes(const Transfer& transfer) {
  const std::size_t vertices = transfer.mesh.positions.size();
  const bool has_matrices = transfer.kind->indirect != nullptr;
  return static_cast<std::int64_t>(transfer.shape.stored_bytes(vertices) +
                                   (has_matrices ? transfer.indirect_shape.stored_bytes(vertices) : 0));
}

// Clusters in place of rows: the first counts of a plan that lose no more than it has room for, or those of a bake without
// such a plan.
void compress_by_plan(const Plan& plan, ClusterCounts asked, Transfer& transfer) {
  if (plan.clusters.empty()) return compress(transfer, asked);
  const auto decision = std::find_if(transfer.plan.decisions.begin(), transfer.plan.decisions.end(),
                                     [](const Decision& one) { return one.name == kClustersDecision; });
  double error = 0.0;
  for (const ClusterCounts counts : plan.clusters) {
    Transfer clustered = transfer;
    compress(clustered, counts);
    decision->choice = fmt::format("{} of {} vectors", counts.clusters, counts.vectors);
    error = worst_radiance(lost_by(clustered, transfer), plan.lights) / plan.reference;
    if (error > decision->error) continue;
    decision->error = error;
    decision->bytes_saved = stored_bytes(transfer) - stored_bytes(clustered);
    clustered.plan = transfer.plan;
    transfer = std::move(clustered);
    return;
  }
  decision->why = fmt::format("{} would lose {:.2g}, more than {:.2g}", decision->choice, error, decision->error);
  decision->choice = "rows as they are";
  decision->bytes_saved = 0;
  decision->error = 0.0;
}

}  // namespace

BakeJob::BakeJob(Scene the_scene, BakeSettings the_settings)
    : scene(std::move(the_scene)), settings(std::move(the_settings)) {
  if (!scene.mesh.frame.is_world()) return;
  const std::vector<Eigen::Vector3d> points = points_of(scene.mesh);
  if (!frame_around(bounding_box(points), scene.name).is_world()) place(scene.mesh, points, scene.name);
}

BakeJob planned(BakeJob job) {
  if (!job.settings.plan_file.empty()) job.plan = read_plan(job.settings.plan_file, job.scene);
  check(job);
  on_threads(job.settings.threads, [&] {
    if (job.scene.bake.fit_lobes && job.scene.bake.kind->is_glossy()) {
      job.fits = fit_lobes(job.scene.mesh, job.scene.bake.degree);
    }
    if (!job.plan) job.plan = make_plan(job.scene, job.settings.instruction_set);
  });
  return job;
}

Transfer bake(BakeJob job, BakeReport* report, const BakeObserver& say) {
  if (job.plan) {
    check(job);
  } else {
    job = planned(std::move(job));
  }
  const BakeOptions wanted = job.scene.bake;
  if (say) {
    for (const FittedBrdf& fitted : job.fits) say(described(fitted));
  }
  const std::shared_ptr<Tracer> tracer = prepare(job, say);
  Transfer transfer;
  BakeReport measured;
  const bool by_channel = job.scene.bake.kind->traces_rays() && has_colored_mirrors(job.scene.mesh);
  on_threads(job.settings.threads, [&] {
    transfer = by_channel ? run_by_channel(job, tracer, measured)
                          : run_steps(job.scene, job.scene, job.settings, *job.plan, tracer, measured);
  });
  if (report != nullptr) *report = measured;
  if (!job.settings.checkpoint.shard.is_whole()) return {};  // the checkpoint is the result
  if (!job.settings.ranks.is_first()) return {};
  transfer.mesh = std::move(job.scene.mesh);
  if (!wanted.kind->is_glossy()) leave_out_gloss(transfer.mesh);
  take_plan(*job.plan, transfer);
  if (wanted.kind->stores_visibility()) keep_bands(wanted.keep, transfer);
  if (wanted.compress.clusters > 0 || !job.plan->clusters.empty()) {
    try {
      on_threads(job.settings.threads, [&] { compress_by_plan(*job.plan, wanted.compress, transfer); });
    } catch (const output::Interrupted&) {
      if (measured.kept.empty()) throw;
      throw output::Interrupted(measured.kept);
    }
  }
  transfer.missing = shortfall(wanted, transfer);
  return transfer;
}

void require_shard(const Shard& shard) {
  if (!shard.is_whole() && shard.count <= kMostShards && shard.index < shard.count) return;
  throw std::invalid_argument(
      fmt::format("shard {} of {}: expected one of 2 to {}", shard.index + 1, shard.count, kMostShards));
}

void bake_shard(BakeJob job, BakeReport* report, const BakeObserver& say) {
  const Scene& scene = job.scene;
  require_shard(job.settings.checkpoint.shard);
  if (!scene.bake.kind->traces_rays()) {
    throw std::invalid_argument(
        fmt::format("{}: {} traces no rays, which shards share; expected another kind, or no shard", scene.name,
                    scene.bake.kind->word));
  }
  bake(std::move(job), report, say);
}

Transfer bake_to_file(const std::string& file, BakeJob job, BakeReport* report, const BakeObserver& say) {
  BakeReport measured;
  const bool is_first = job.settings.ranks.is_first();
  Transfer transfer = bake(std::move(job), &measured, say);
  if (!is_first) return {};
  write_transfer(file, transfer);
  if (!measured.checkpoint.empty()) std::filesystem::remove(measured.checkpoint);
  if (!measured.bounces.empty()) remove_bounces(measured.bounces);
  if (report != nullptr) *report = measured;
  return transfer;
}

}  // namespace sh::prt
