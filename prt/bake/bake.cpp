#include "prt/bake/bake.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/bake/bake_key.hpp"
#include "prt/bake/chunks.hpp"
#include "prt/bake/coloured_mirrors.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/bake/interreflect.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/bake/trace_form_factors.hpp"
#include "prt/bake/unshadowed.hpp"

namespace sh::prt {

namespace {

void check_options(const BakeOptions& options, int threads) {
  if (options.degree < 0 || options.degree > kMaxDegree) {
    throw std::invalid_argument(fmt::format("degree: expected 0 to {}, got {}", kMaxDegree, options.degree));
  }
  if (threads < 0) {
    throw std::invalid_argument(fmt::format("threads: expected 0 (every core) or more, got {}", threads));
  }
}

void report_closed(const Scene& scene, const FillPlan& plan, OnFlaw on_flaw) {
  if (plan.closed > 0) {
    report_flaw(on_flaw, fmt::format("{}: no ray can leave {} of {} vertices ({} filled from neighbours, {} "
                                     "in closed parts left dark)",
                                     scene.name, plan.closed, scene.mesh.positions.size(), plan.filled,
                                     plan.closed - plan.filled));
  }
}

// Mostly in the dark: a closed room without light, or surfaces whose fronts are inside.
void report_dark(const Scene& scene, const std::vector<Sight>& sight, OnFlaw on_flaw) {
  const auto dark = static_cast<std::size_t>(std::count(sight.begin(), sight.end(), Sight::kDark));
  if (2 * dark > sight.size() && scene.mesh.emission.empty()) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} vertices see no sky and nothing shines: closed rooms, or meshes "
                                     "with their fronts inside (`flip` turns a mesh)",
                                     scene.name, dark, sight.size()));
  }
}

// Light between mirrors that face each other, without much loss, has no end.
void report_cut(const Scene& scene, double cut, OnFlaw on_flaw) {
  constexpr double kNoticed = 1e-3;
  if (cut > kNoticed) {
    report_flaw(on_flaw, fmt::format("{}: paths were cut after {} mirrors: up to {:.2g} of the light of a vertex is "
                                     "left out",
                                     scene.name, MirrorPaths::kMostMirrors, cut));
  }
}

// Shadowed vectors of all vertices; those without sight take their neighbours'.
void shadow(const Scene& scene, const RaySetup& setup, const BakeSettings& settings, Checkpoint& checkpoint,
            ShadowResult& result) {
  ShadowPass pass(scene.mesh, setup, settings.open, result);
  pass.run(checkpoint);
  report_cut(scene, pass.largest_cut(), settings.on_flaw);
  const FillPlan plan = plan_fill(scene.mesh, result.sight);
  fill_closed(result.transfer, plan);
  report_closed(scene, plan, settings.on_flaw);
  report_dark(scene, result.sight, settings.on_flaw);
  for (const Fill& fill : plan.fills) {
    if (result.factors != nullptr) {
      result.factors->keep_mean(fill.vertex, fill.sources);
    }
  }
}

// Unshadowed vectors become shadowed or interreflected ones.
void trace(const Scene& scene, const BakeSettings& settings, Transfer& transfer, BakeReport& report) {
  const RaySetup setup(scene, settings.threads, settings.instruction_set);
  transfer.kind = TransferKind::kShadowed;
  transfer.instruction_set = setup.tracer.instruction_set();
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  transfer.sampler = scene.bake.sampler;
  transfer.seed = scene.bake.seed;
  const bool bounces = scene.bake.kind == TransferKind::kInterreflected;
  FormFactors factors(bounces ? scene.mesh.positions.size() : 0, settings.bounce_memory, [&] {
    return make_row_maker(scene.mesh, setup.starts, setup.directions, setup.tracer, setup.mirrors);
  });
  ShadowResult result{transfer, std::vector<Sight>(scene.mesh.positions.size(), Sight::kSome),
                      bounces ? &factors : nullptr};
  Checkpoint checkpoint(settings.checkpoint, bake_key(scene, transfer.instruction_set, settings.open), result);
  try {
    shadow(scene, setup, settings, checkpoint, result);
    if (bounces) {
      interreflect(scene, factors, settings.on_flaw, transfer);
    }
  } catch (const output::Interrupted&) {
    throw output::Interrupted(checkpoint.interrupted());
  }
  report = {setup.tracer.rays(), settings.checkpoint.path};
}

Transfer bake_in_arena(const Scene& scene, const BakeSettings& settings, BakeReport& report) {
  Transfer transfer;
  transfer.scene = scene.name;
  transfer.mesh = scene.mesh;
  transfer.degree = scene.bake.degree;
  transfer.kind = TransferKind::kUnshadowed;
  transfer.instruction_set = "any";
  transfer.coefficients = unshadowed_transfer(transfer.degree, scene.mesh.normals);
  transfer.emitted = scene.mesh.emission;
  if (scene.bake.kind != TransferKind::kUnshadowed) {
    trace(scene, settings, transfer, report);
  }
  return transfer;
}

}  // namespace

Transfer bake(const Scene& scene, const BakeSettings& settings, BakeReport* report) {
  check_options(scene.bake, settings.threads);
  if (scene.mesh.faces.empty()) {
    throw std::invalid_argument(fmt::format("{}: the mesh has no faces, expected at least one triangle", scene.name));
  }
  if (!settings.open.empty() && settings.open.size() != scene.mesh.positions.size()) {
    throw std::invalid_argument(
        fmt::format("{} marks of open vertices for {} vertices", settings.open.size(), scene.mesh.positions.size()));
  }
  Transfer transfer;
  BakeReport measured;
  on_threads(settings.threads, [&] {
    if (scene.bake.kind != TransferKind::kUnshadowed && has_coloured_mirrors(scene.mesh)) {
      BakeSettings part = settings;
      part.checkpoint = {};  // it holds one bake
      transfer = bake_by_channel(scene, [&](const Scene& grey) {
        BakeReport channel;
        Transfer result = bake_in_arena(grey, part, channel);
        measured.rays += channel.rays;
        return result;
      });
    } else {
      transfer = bake_in_arena(scene, settings, measured);
    }
  });
  if (report != nullptr) {
    *report = measured;
  }
  return transfer;
}

}  // namespace sh::prt
