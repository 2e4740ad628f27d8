#include "prt/bake/steps.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "prt/bake/bake_run.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/trace_form_factors.hpp"
#include "prt/bake/unshadowed.hpp"

namespace sh::prt {

namespace {

void report_closed(const Scene& scene, const FillPlan& plan, OnFlaw on_flaw) {
  if (plan.closed > 0) {
    report_flaw(on_flaw, fmt::format("{}: no ray can leave {} of {} vertices ({} filled from neighbors, {} "
                                     "in closed parts left dark)",
                                     scene.name, plan.closed, scene.mesh.positions.size(), plan.filled,
                                     plan.closed - plan.filled));
  }
}

// Reports meshes that are mostly dark: a closed room without light, or surfaces whose fronts face inwards.
void report_dark(const Scene& scene, const std::vector<Sight>& sight, OnFlaw on_flaw) {
  const auto dark = static_cast<std::size_t>(std::count(sight.begin(), sight.end(), Sight::kDark));
  if (2 * dark > sight.size() && scene.mesh.emission.empty()) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} vertices see no sky and nothing shines: closed rooms, or meshes "
                                     "with their fronts inside (`flip` turns a mesh)",
                                     scene.name, dark, sight.size()));
  }
}

// Reports lost light: paths between mirrors that face each other do not end if the mirrors lose little.
void report_cut(const Scene& scene, double cut, OnFlaw on_flaw) {
  constexpr double kNoticed = 1e-3;
  if (cut > kNoticed) {
    report_flaw(on_flaw, fmt::format("{}: paths were cut after {} mirrors: up to {:.2g} of the light of a vertex is "
                                     "left out",
                                     scene.name, MirrorPaths::kMostMirrors, cut));
  }
}

void begin_tracing(BakeRun& run) {
  const Scene& scene = run.scene;
  Transfer& transfer = run.transfer;
  run.rays.emplace(scene, run.settings.threads, run.settings.instruction_set);
  transfer.instruction_set = run.rays->tracer.instruction_set();
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  transfer.sampler = scene.bake.sampler;
  transfer.seed = scene.bake.seed;
  const std::size_t vertices = scene.mesh.positions.size();
  if (scene.bake.kind->has_bounces()) {
    run.factors.emplace(vertices, run.settings.bounce_memory, [&scene, rays = &*run.rays] {
      return make_row_maker(scene.mesh, rays->starts, rays->directions, rays->tracer, rays->mirrors);
    });
  }
  run.found.emplace(
      ShadowResult{transfer, std::vector<Sight>(vertices, Sight::kSome), run.factors ? &*run.factors : nullptr});
  run.checkpoint.emplace(run.settings.checkpoint, bake_key(scene, transfer.instruction_set, run.open), *run.found);
}

}  // namespace

void take_unshadowed(BakeRun& run) {
  run.transfer.scene = run.scene.name;
  run.transfer.mesh = run.scene.mesh;
  run.transfer.shape = {.degree = run.scene.bake.degree};
  run.transfer.instruction_set = "any";
  run.transfer.coefficients = unshadowed_transfer(run.scene.bake.degree, run.scene.mesh.normals);
  run.transfer.emitted = run.scene.mesh.emission;
}

// Gives closed vertices the vectors of their neighbors.
void trace_shadows(BakeRun& run) {
  begin_tracing(run);
  const OnFlaw on_flaw = run.settings.on_flaw;
  ShadowPass pass(run.scene.mesh, *run.rays, run.open, *run.found);
  pass.run(*run.checkpoint);
  report_cut(run.scene, pass.largest_cut(), on_flaw);
  const FillPlan plan = plan_fill(run.scene.mesh, run.found->sight);
  fill_closed(run.transfer, plan);
  report_closed(run.scene, plan, on_flaw);
  report_dark(run.scene, run.found->sight, on_flaw);
  for (const Fill& fill : plan.fills) {
    if (run.factors) run.factors->keep_mean(fill.vertex, fill.sources);
  }
}

}  // namespace sh::prt
