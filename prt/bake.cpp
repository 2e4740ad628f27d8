#include "prt/bake.hpp"

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "numeric/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/directions.hpp"
#include "prt/fill_closed.hpp"
#include "prt/gather.hpp"
#include "prt/tracer.hpp"

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

// Replaces the unshadowed vectors in `transfer` by shadowed ones; notes in `sight` what became of the rays.
void shadow(const Scene& scene, tbb::task_arena& arena, const BakeSettings& settings, Transfer& transfer,
            std::vector<Sight>& sight) {
  const Tracer tracer(scene.mesh, settings.threads, settings.instruction_set);
  transfer.instruction_set = tracer.instruction_set();
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  const SharedDirections shared(scene.bake.directions, transfer.degree);
  const std::vector<RayStart> starts = ray_starts(scene.mesh);
  const std::size_t count = transfer.bands_squared();
  sight.assign(starts.size(), Sight::kSome);
  output::Progress progress("bake", starts.size());
  for_parts(arena, starts.size(), [&](std::size_t first, std::size_t last) {
    Gatherer gatherer(shared, tracer);
    for (std::size_t v = first; v < last; ++v) {
      const Gathered& seen = gatherer.gather(starts[v].origin, scene.mesh.normals[v], scene.mesh.geometric_normals[v]);
      control_with_unshadowed(seen, count, transfer.coefficients.data() + v * count);
      if (const float fraction = seen.fraction(); fraction < kNearlyDark) {
        sight[v] = gatherer.classify(scene.mesh, v, starts[v], fraction <= 0.0F);
      }
    }
    progress.advance(last - first);
  });
  progress.finish();
}

}  // namespace

Transfer bake(const Scene& scene, const BakeSettings& settings) {
  check_options(scene.bake, settings.threads);
  Transfer transfer;
  transfer.scene = scene.name;
  transfer.mesh = scene.mesh;
  transfer.degree = scene.bake.degree;
  transfer.kind = scene.bake.kind;
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
  if (transfer.kind == TransferKind::kShadowed) {
    std::vector<Sight> sight;
    shadow(scene, arena, settings, transfer, sight);
    const FillCount filled = fill_closed(transfer, sight);
    if (filled.closed > 0) {
      report_flaw(settings.on_flaw,
                  fmt::format("{}: no ray can leave {} of {} vertices ({} filled from neighbours, {} "
                              "in closed parts left dark)",
                              scene.name, filled.closed, vertices, filled.filled, filled.closed - filled.filled));
    }
  }
  return transfer;
}

}  // namespace sh::prt
