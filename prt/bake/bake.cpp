#include "prt/bake/bake.hpp"

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "numeric/zonal.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/bake/gather.hpp"
#include "prt/bake/trace_form_factors.hpp"
#include "prt/basis.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kVerticesPerTask = 32;
constexpr float kNearlyDark = 0.03F;  // of the cosine; such vertices are looked at more closely

// T_lm = A_l/pi Y_lm(n), out (bands^2) [RamamoorthiHanrahan01]
void unshadowed_transfer(int degree, const Eigen::Vector3f& normal, float* out) {
  evaluate_basis(degree, normal.x(), normal.y(), normal.z(), out);
  for (std::ptrdiff_t l = 0; l <= degree; ++l) {
    const auto factor =
        static_cast<float>(numeric::clamped_cosine_factor<double>(static_cast<int>(l)) / std::numbers::pi);
    std::for_each(out + l * l, out + (l + 1) * (l + 1), [&](float& value) { value *= factor; });
  }
}

// f DU + (S - f S_all): the order in which an open vertex keeps every bit of DU.
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer) {
  const float fraction = seen.fraction();
  for (std::size_t i = 0; i < count; ++i) {
    transfer[i] = fraction * transfer[i] + (seen.visible[i] - fraction * seen.all[i]);
  }
}

void check_options(const BakeOptions& options, int threads) {
  if (options.degree < 0 || options.degree > kMaxDegree) {
    throw std::invalid_argument(fmt::format("degree: expected 0 to {}, got {}", kMaxDegree, options.degree));
  }
  if (threads < 0) {
    throw std::invalid_argument(fmt::format("threads: expected 0 (every core) or more, got {}", threads));
  }
}

// Calls each(first, last) for parts of 0..count on the threads of the arena.
template <class Each>
void for_parts(tbb::task_arena& arena, std::size_t count, const Each& each) {
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kVerticesPerTask),
                      [&](const tbb::blocked_range<std::size_t>& part) { each(part.begin(), part.end()); });
  });
}

// Everything that rays of a bake need, for as long as form factors may be traced again.
struct RaySetup {
  RaySetup(const Scene& scene, const BakeSettings& settings)
      : tracer(scene.mesh, settings.threads, settings.instruction_set),
        directions(scene.bake.directions, scene.bake.degree),
        starts(ray_starts(scene.mesh)) {}

  Tracer tracer;
  SharedDirections directions;
  std::vector<RayStart> starts;
};

// Replaces the unshadowed vectors in `transfer` by shadowed ones and keeps what the rays hit, if wanted; returns what
// became of the rays.
std::vector<Sight> shadow(const Mesh& mesh, const RaySetup& setup, tbb::task_arena& arena, Transfer& transfer,
                          FormFactors* factors) {
  const std::size_t count = transfer.bands_squared();
  std::vector<Sight> sight(setup.starts.size(), Sight::kSome);
  output::Progress progress("bake", setup.starts.size());
  for_parts(arena, setup.starts.size(), [&](std::size_t first, std::size_t last) {
    Gatherer gatherer(setup.directions, setup.tracer);
    RowMerger merger(mesh);
    for (std::size_t v = first; v < last; ++v) {
      const RayStart& start = setup.starts[v];
      const Gathered& seen = gatherer.gather(start.origin, mesh.normals[v], mesh.geometric_normals[v]);
      control_with_unshadowed(seen, count, transfer.coefficients.data() + v * count);
      if (factors != nullptr) {
        factors->keep(v, merger.merge(gatherer));
      }
      if (const float fraction = seen.fraction(); fraction < kNearlyDark) {
        sight[v] = gatherer.classify(mesh, v, start, fraction <= 0.0F);
      }
    }
    progress.advance(last - first);
  });
  progress.finish();
  return sight;
}

void report_closed(const Scene& scene, const FillPlan& plan, OnFlaw on_flaw) {
  if (plan.closed > 0) {
    report_flaw(on_flaw, fmt::format("{}: no ray can leave {} of {} vertices ({} filled from neighbours, {} "
                                     "in closed parts left dark)",
                                     scene.name, plan.closed, scene.mesh.positions.size(), plan.filled,
                                     plan.closed - plan.filled));
  }
}

// Replaces shadowed vectors by interreflected ones, (vertices, 3, bands^2).
void bounce(const Scene& scene, const FormFactors& factors, tbb::task_arena& arena, OnFlaw on_flaw,
            Transfer& transfer) {
  const std::size_t count = transfer.bands_squared();
  const BounceLayout layout{count};
  Panel x(factors.size(), layout.columns());
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
      const auto albedo = static_cast<double>(scene.mesh.albedo[v][static_cast<Eigen::Index>(c)]);
      std::transform(transfer.coefficients.data() + v * count, transfer.coefficients.data() + (v + 1) * count,
                     x.row(v) + layout.channel(c),
                     [albedo](float direct) { return albedo * static_cast<double>(direct); });
    }
  }
  arena.execute([&] { transfer.bounces = solve_bounces(factors, scene.mesh.albedo, layout, x, scene.bake.bounces); });
  transfer.kind = TransferKind::kInterreflected;
  transfer.coefficients.resize(x.rows * transfer.row_length());
  float* out = transfer.coefficients.data();
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
      const double* values = x.row(v) + layout.channel(c);
      out = std::transform(values, values + count, out, [](double value) { return static_cast<float>(value); });
    }
  }
  if (!transfer.bounces.certified) {
    report_flaw(on_flaw, fmt::format("{}: bounces did not settle within {} (residual {:.2g} after {} applications): "
                                     "surfaces of albedo 1 enclose light (kept as it is)",
                                     scene.name, scene.bake.bounces.tolerance, transfer.bounces.residual,
                                     transfer.bounces.applications));
  }
}

// Unshadowed vectors become shadowed or interreflected ones.
void trace(const Scene& scene, const BakeSettings& settings, tbb::task_arena& arena, Transfer& transfer) {
  const RaySetup setup(scene, settings);
  transfer.instruction_set = setup.tracer.instruction_set();
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  const bool bounces = scene.bake.kind == TransferKind::kInterreflected;
  FormFactors factors(bounces ? scene.mesh.positions.size() : 0, settings.bounce_memory,
                      [&] { return make_row_maker(scene.mesh, setup.starts, setup.directions, setup.tracer); });
  const std::vector<Sight> sight = shadow(scene.mesh, setup, arena, transfer, bounces ? &factors : nullptr);
  const FillPlan plan = plan_fill(scene.mesh, sight);
  fill_closed(transfer, plan);
  report_closed(scene, plan, settings.on_flaw);
  if (bounces) {
    for (const Fill& fill : plan.fills) {
      factors.keep_mean(fill.vertex, fill.sources);
    }
    bounce(scene, factors, arena, settings.on_flaw, transfer);
  }
}

}  // namespace

Transfer bake(const Scene& scene, const BakeSettings& settings) {
  check_options(scene.bake, settings.threads);
  Transfer transfer;
  transfer.scene = scene.name;
  transfer.mesh = scene.mesh;
  transfer.degree = scene.bake.degree;
  transfer.kind = scene.bake.kind == TransferKind::kUnshadowed ? TransferKind::kUnshadowed : TransferKind::kShadowed;
  transfer.instruction_set = "any";
  const std::size_t count = transfer.bands_squared();
  const std::size_t vertices = scene.mesh.positions.size();
  transfer.coefficients.resize(vertices * count);
  const int cores = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(settings.threads == 0 ? cores : std::min(settings.threads, cores));
  for_parts(arena, vertices, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      unshadowed_transfer(transfer.degree, scene.mesh.normals[v], transfer.coefficients.data() + v * count);
    }
  });
  if (scene.bake.kind != TransferKind::kUnshadowed) {
    trace(scene, settings, arena, transfer);
  }
  return transfer;
}

}  // namespace sh::prt
