#include "prt/bake/shadow_pass.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>

#include "prt/bake/trace_form_factors.hpp"

namespace sh::prt {

namespace {

constexpr float kNearlyDark = 0.03F;  // of the cosine; such vertices are looked at more closely

}  // namespace

// The order in which an open vertex keeps every bit of DU.
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer) {
  const float fraction = seen.fraction();
  for (std::size_t i = 0; i < count; ++i) {
    transfer[i] = fraction * transfer[i] + (seen.visible[i] - fraction * seen.all[i]);
  }
}

RaySetup::RaySetup(const Scene& scene, int threads, const std::string& instruction_set)
    : tracer(scene.mesh, threads, instruction_set), directions(scene.bake), starts(ray_starts(scene.mesh)) {}

struct ShadowPass::Worker {
  Worker(const Mesh& mesh, const RaySetup& setup) : gatherer(setup.directions, setup.tracer), merger(mesh) {}
  Gatherer gatherer;
  RowMerger merger;
};

ShadowPass::ShadowPass(const Mesh& mesh, const RaySetup& setup, Transfer& transfer, FormFactors* factors,
                       const std::vector<std::uint8_t>& open)
    : mesh_(mesh),
      setup_(setup),
      transfer_(transfer),
      factors_(factors),
      open_(open),
      sight_(setup.starts.size(), Sight::kSome) {}

void ShadowPass::run() {
  output::Progress progress("bake", sight_.size());
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(mesh_, setup_); });
  for_chunks(sight_.size(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, sight_.size());
    trace(range, workers.local());
    progress.advance(range.size());
  });
  progress.finish();
}

void ShadowPass::trace(const VertexRange& range, Worker& worker) {
  for (std::size_t v = range.first; v < range.last; ++v) {
    output::check_interrupt();
    trace(v, worker);
  }
}

void ShadowPass::trace(std::size_t vertex, Worker& worker) {
  if (!open_.empty() && open_[vertex] != 0) {
    if (factors_ != nullptr) {
      factors_->keep(vertex, {});
    }
    return;
  }
  const RayStart& start = setup_.starts[vertex];
  const Gathered& seen = worker.gatherer.gather(start.origin, mesh_.normals[vertex], mesh_.geometric_normals[vertex]);
  const std::size_t count = transfer_.bands_squared();
  control_with_unshadowed(seen, count, transfer_.coefficients.data() + vertex * count);
  if (factors_ != nullptr) {
    factors_->keep(vertex, worker.merger.merge(worker.gatherer));
  }
  if (const float fraction = seen.fraction(); fraction < kNearlyDark) {
    sight_[vertex] = worker.gatherer.classify(mesh_, vertex, start, fraction <= 0.0F);
  }
}

}  // namespace sh::prt
