#include "prt/bake/shadow_pass.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

struct ShadowPass::Worker {
  explicit Worker(const RaySetup& setup) : rows(setup) {}
  RowTracer rows;
  double largest_cut = 0.0;
};

double ShadowPass::run(Checkpoint& checkpoint) {
  const std::size_t vertices = result_.sight.size();
  output::Progress progress("bake", vertices);
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(setup_); });
  for_chunks(vertices, [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, vertices);
    if (checkpoint.wants(chunk)) {
      for (std::size_t v = range.first; v < range.last; ++v) trace(v, workers.local());
      checkpoint.finished(chunk);
    }
    progress.advance(range.size());
  });
  progress.finish();
  checkpoint.complete();
  double largest = 0.0;
  workers.combine_each([&](const Worker& worker) { largest = std::max(largest, worker.largest_cut); });
  return largest;
}

ShadowPass::Sampled ShadowPass::sample(const std::vector<std::uint32_t>& vertices, double seconds) {
  const int tasks = tbb::this_task_arena::max_concurrency();
  const output::Stopwatch stopwatch;
  std::vector<double> starts(tasks);
  std::vector<double> ends(tasks);
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(setup_); });
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  in_parallel(0, tasks, [&](int task) {
    Worker& worker = workers.local();  // the time to make it is not that of a vertex
    starts[task] = ends[task] = stopwatch.seconds();
    do {
      const std::size_t i = next++;
      if (i >= vertices.size()) return;
      trace(vertices[i], worker);
      ++done;
      ends[task] = stopwatch.seconds();
    } while (ends[task] - starts[task] < seconds);
  });
  return {done, *std::max_element(ends.begin(), ends.end()) - *std::min_element(starts.begin(), starts.end())};
}

void ShadowPass::trace(std::size_t vertex, Worker& worker) {
  output::check_interrupt();
  if (!open_.empty() && open_[vertex] != 0) {
    if (result_.factors != nullptr) result_.factors->keep(vertex, {});
    return;
  }
  RowTracer& rows = worker.rows;
  const Gathered& seen = rows.gatherer().gather(vertex);
  float* row = result_.transfer.row(vertex);
  control_with_unshadowed(seen, result_.transfer.shape.count(), row);
  float fraction = seen.fraction();
  const bool needs_hits = result_.factors != nullptr && !rows.has_own_directions();
  if (setup_.mirrors.any() || needs_hits) rows.meet(vertex);
  if (setup_.mirrors.any()) {
    fraction += rows.add_sky(result_.transfer.degree(), row);
    const bool is_black = setup_.mesh.albedo[vertex].isZero(0.0F);  // mirrors, for instance; they do not show it
    if (!is_black) worker.largest_cut = std::max(worker.largest_cut, rows.cut());
  }
  if (result_.factors != nullptr) result_.factors->keep(vertex, rows.row(vertex));
  result_.sight[vertex] = rows.gatherer().sight(vertex, fraction);
}

}  // namespace sh::prt
