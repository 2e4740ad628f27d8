#include "prt/bake/shadow_pass.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

#include "numeric/output/progress.hpp"
#include "prt/bake/mirror_light.hpp"
#include "prt/bake/trace_form_factors.hpp"

namespace sh::prt {

namespace {

constexpr float kNearlyDark = 0.03F;  // of the cosine; such vertices are looked at more closely

}  // namespace

// This order of operations keeps every bit of DU for an open vertex.
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer) {
  const float fraction = seen.fraction();
  for (std::size_t i = 0; i < count; ++i) {
    transfer[i] = fraction * transfer[i] + (seen.visible[i] - fraction * seen.all[i]);
  }
}

RaySetup::RaySetup(const Scene& scene, int threads, const std::string& instruction_set)
    : tracer(scene.mesh, threads, instruction_set),
      mirrors(scene.mesh, tracer),
      directions(scene.bake),
      starts(ray_starts(scene.mesh)) {}

struct ShadowPass::Worker {
  Worker(const Mesh& mesh, const RaySetup& setup)
      : gatherer(setup.directions, setup.tracer), merger(mesh), mirrors(setup.mirrors) {}
  Gatherer gatherer;
  RowMerger merger;
  MirrorLight mirrors;
  double largest_cut = 0.0;
};

ShadowPass::ShadowPass(const Mesh& mesh, const RaySetup& setup, const std::vector<std::uint8_t>& open,
                       ShadowResult& result)
    : mesh_(mesh), setup_(setup), open_(open), result_(result) {}

void ShadowPass::run(Checkpoint& checkpoint) {
  const std::size_t vertices = result_.sight.size();
  output::Progress progress("bake", vertices);
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(mesh_, setup_); });
  for_chunks(vertices, [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, vertices);
    if (!checkpoint.has(chunk)) {
      trace(range, workers.local());
      checkpoint.finished(chunk);
    }
    progress.advance(range.size());
  });
  progress.finish();
  workers.combine_each([this](const Worker& w) { largest_cut_ = std::max(largest_cut_, w.largest_cut); });
  checkpoint.complete();
}

std::size_t ShadowPass::sample(const std::vector<std::uint32_t>& vertices, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(mesh_, setup_); });
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                    [&](std::size_t) {
                      do {
                        output::check_interrupt();
                        const std::size_t i = next++;
                        if (i >= vertices.size()) return;
                        trace(vertices[i], workers.local());
                        ++done;
                      } while (Clock::now() < end);
                    });
  return done;
}

void ShadowPass::trace(const VertexRange& range, Worker& worker) {
  for (std::size_t v = range.first; v < range.last; ++v) {
    output::check_interrupt();
    trace(v, worker);
  }
}

void ShadowPass::keep_row(std::size_t vertex, const std::vector<BlockedRay>& met, Worker& worker) {
  if (result_.factors != nullptr) result_.factors->keep(vertex, worker.merger.merge(met));
}

void ShadowPass::trace(std::size_t vertex, Worker& worker) {
  if (!open_.empty() && open_[vertex] != 0) {
    if (result_.factors != nullptr) result_.factors->keep(vertex, {});
    return;
  }
  const RayStart& start = setup_.starts[vertex];
  const Gathered& seen = worker.gatherer.gather(start.origin, mesh_.normals[vertex], mesh_.geometric_normals[vertex]);
  float* row = result_.transfer.row(vertex);
  control_with_unshadowed(seen, result_.transfer.shape.count(), row);
  float fraction = seen.fraction();
  if (setup_.mirrors.any()) {
    const std::vector<BlockedRay>& met = worker.mirrors.follow(start.origin, worker.gatherer.closest_hits());
    fraction += worker.mirrors.add_sky(result_.transfer.degree(), row);
    if (!mesh_.albedo[vertex].isZero(0.0F)) {  // black ones, such as mirrors themselves, do not show it
      worker.largest_cut = std::max(worker.largest_cut, worker.mirrors.cut());
    }
    keep_row(vertex, met, worker);
  } else if (result_.factors != nullptr) {
    keep_row(vertex, worker.gatherer.closest_hits(), worker);
  }
  if (fraction < kNearlyDark) result_.sight[vertex] = worker.gatherer.classify(mesh_, vertex, start, fraction <= 0.0F);
}

}  // namespace sh::prt
