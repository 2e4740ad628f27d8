#include "prt/bake/steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "prt/arrays.hpp"
#include "prt/bake/between_vertices.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr double kNoticedCut = 1e-3;  // of the light of a vertex

void report(const BakeRun& run, const std::string& flaw) {
  report_flaw(run.settings.on_flaw, fmt::format("{}: {}", run.scene.name, flaw));
}

void begin_tracing(BakeRun& run) {
  const Scene& scene = run.scene;
  Transfer& transfer = run.transfer;
  if (traces_here(scene, run.settings)) {
    run.rays.emplace(scene.mesh, scene.bake, run.settings.threads, run.settings.instruction_set, run.tracer);
  }
  transfer.instruction_set = choose_instruction_set(run.settings.instruction_set);
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  transfer.sampler = scene.bake.sampler;
  transfer.seed = scene.bake.seed;
  const std::size_t vertices = scene.mesh.positions.size();
  if (scene.bake.kind->has_form_factors()) {
    run.factors.emplace(vertices, run.settings.bounce_memory, [rays = &*run.rays] { return make_row_maker(*rays); });
    run.factors->share_among(run.settings.ranks);
  }
  run.found.emplace(ShadowResult{transfer, std::vector<Sight>(vertices), run.factors ? &*run.factors : nullptr});
  run.checkpoint.emplace(run.settings.checkpoint, bake_key(run.whole, transfer.instruction_set, run.open), *run.found);
}

// Reports meshes that are mostly dark: a closed room without light, or surfaces whose fronts face inwards.
void report_dark(const BakeRun& run) {
  const std::vector<Sight>& sight = run.found->sight;
  const std::size_t dark =
      std::count_if(sight.begin(), sight.end(), [](const Sight& s) { return s.visible <= 0.0F && s.closed() <= 0.5F; });
  if (2 * dark > sight.size() && run.scene.mesh.emission.empty()) {
    report(run, fmt::format("{} of {} vertices see no sky and nothing shines: closed rooms, or meshes with their "
                            "fronts inside (`flip` turns a mesh)",
                            dark, sight.size()));
  }
}

// Gives closed vertices the light of their neighbors.
void fill_closed(BakeRun& run) {
  const std::vector<Sight>& sight = run.found->sight;
  std::vector<ClosedVertex> closed = closed_vertices(run.scene.mesh, sight);
  if (const auto [buried, filled] = count_buried(closed, sight); buried > 0) {
    report(run, fmt::format("no ray can leave {} of {} vertices ({} filled from neighbors, {} in closed parts left "
                            "dark)",
                            buried, sight.size(), filled, buried - filled));
  }
  Fill fill(std::move(closed));
  const std::size_t length = run.transfer.shape.length();
  fill.apply(run.transfer.coefficients.data(), length, length);
  if (run.factors) run.factors->fill_with(std::move(fill));
}

bool is_late(const BounceOptions& options) { return std::chrono::steady_clock::now() >= options.deadline; }

// Refuses a solution without a digit that is proved, and reports one that is coarser than asked for.
void check_bounces(const BakeRun& run) {
  const BounceReport& bounces = run.transfer.bounces;
  const bool late = is_late(run.scene.bake.bounces);
  const double error = std::max(bounces.bound, bounces.emitted_bound);
  if (late && !std::isfinite(error)) {
    throw std::runtime_error(fmt::format(
        "{}: the time ended before the error of the bounces had a bound; expected more time", run.scene.name));
  }
  if (!late && !(bounces.bound <= bounces.largest && bounces.emitted_bound <= bounces.emitted_largest)) {
    throw std::runtime_error(
        fmt::format("{}: its bounces have no sum that can be told (residual {:.2g} after {} applications): surfaces of "
                    "albedo near 1 enclose light; expected a lower albedo or a larger opening",
                    run.scene.name, bounces.residual, bounces.applications));
  }
  constexpr double kLargestSingle = std::numeric_limits<float>::max();
  if (!(std::max(bounces.largest, bounces.emitted_largest) <= kLargestSingle)) {
    throw std::runtime_error(
        fmt::format("{}: its light is too strong for single precision: expected at most {:.2g}, "
                    "got {:.2g}",
                    run.scene.name, kLargestSingle, std::max(bounces.largest, bounces.emitted_largest)));
  }
  if (!bounces.certified && !late) {
    report(run, fmt::format("bounces are within {:.2g} of the largest number, not {:.2g} (residual {:.2g} after {} "
                            "applications)",
                            std::max(bounces.bound / bounces.largest, bounces.emitted_bound / bounces.emitted_largest),
                            run.scene.bake.bounces.tolerance, bounces.residual, bounces.applications));
  }
}

}  // namespace

bool traces_here(const Scene& scene, const BakeSettings& settings) {
  const TransferKind& kind = *scene.bake.kind;
  return kind.traces_rays() && (settings.checkpoint.parts.empty() || kind.has_bounces());
}

Panel direct_light(const Mesh& mesh, const Transfer& transfer, const BounceLayout& layout) {
  Panel x(mesh.positions.size(), layout.columns());
  const std::size_t count = transfer.shape.count();
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
      const auto albedo = static_cast<double>(mesh.albedo[v][c]);
      double* own = x.row(v) + layout.channel(c);
      as_array(own, count) = albedo * as_array(transfer.row(v), count).cast<double>();
      if (layout.emitted > 0) own[count] = static_cast<double>(mesh.emission[v][c]);
    }
  }
  return x;
}

// The bounds then hold for the single precision in which the transfer is kept.
void take_solution(const Panel& x, const BounceLayout& layout, Transfer& transfer) {
  transfer.bounces.bound += kSingleRounding * transfer.bounces.largest;
  transfer.bounces.emitted_bound += kSingleRounding * transfer.bounces.emitted_largest;
  transfer.shape = transfer.kind->shape(transfer.degree());
  transfer.coefficients.resize(x.rows * transfer.shape.length());
  const std::size_t count = transfer.shape.count();
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
      const double* values = x.row(v) + layout.channel(c);
      as_array(transfer.row(v) + c * count, count) = as_array(values, count).cast<float>();
      if (layout.emitted > 0) transfer.emitted[v][c] = static_cast<float>(values[count]);
    }
  }
}

void take_unshadowed(BakeRun& run) {
  run.transfer.scene = run.scene.name;
  if (!run.transfer.kind->is_glossy() && !run.scene.mesh.normal_map.empty()) {
    report(run, "its normal maps are left out, which only glossy kinds show");
  }
  run.transfer.shape = run.scene.bake.kind->traced_shape(run.scene.bake.degree);
  run.transfer.instruction_set = "any";
  run.transfer.coefficients = unshadowed_transfer(run.transfer.shape, run.scene.mesh);
  run.transfer.emitted = run.scene.mesh.emission;
}

void trace_shadows(BakeRun& run) {
  begin_tracing(run);
  const double cut = run.rays ? ShadowPass(*run.rays, run.open, *run.found).run(*run.checkpoint) : 0.0;
  if (!run.settings.checkpoint.shard.is_whole()) return;  // the other vertices are not traced
  if (cut > kNoticedCut) {                                // mirrors that face each other and lose little
    report(run, fmt::format("paths were cut after {} mirrors: up to {:.2g} of the light of a vertex is left out",
                            MirrorPaths::kMostMirrors, cut));
  }
  fill_closed(run);
  report_dark(run);
}

void add_bounces(BakeRun& run) {
  const Scene& scene = run.scene;
  Transfer& transfer = run.transfer;
  const std::size_t emitted = scene.mesh.emission.empty() ? 0 : 1;
  const BounceLayout layout{transfer.shape.count() + emitted, emitted};
  Panel x = direct_light(scene.mesh, transfer, layout);
  const CheckpointSettings& kept = run.settings.checkpoint;
  BounceCheckpoint checkpoint(
      {.path = bounces_file(kept), .restart = kept.restart, .seconds = kept.seconds},
      bounce_key(bake_key(scene, transfer.instruction_set, run.open), scene.bake.bounces, scene.mesh.albedo, x),
      run.settings.ranks);
  transfer.bounces = solve_bounces(*run.factors, scene.mesh.albedo, layout, x, scene.bake.bounces, &checkpoint);
  run.found->factors = nullptr;
  run.factors.reset();  // their memory serves what follows
  transfer.bounces.directions = static_cast<std::uint32_t>(scene.bake.fewer_for_bounces());
  if (!run.settings.ranks.is_first()) return;
  check_bounces(run);
  if (!is_late(scene.bake.bounces)) {
    const BetweenVertices between = measure_between_vertices(scene, transfer.instruction_set, x, layout);
    transfer.bounces.between_vertices = between.light > 0.0 ? between.difference / between.light : 0.0;
  }
  take_solution(x, layout, transfer);
}

}  // namespace sh::prt
