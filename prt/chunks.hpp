// Loops on all threads of the caller's arena, and chunks of vertices of one fixed size.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sh::prt {

/// The vertices of one task; the same for any number of threads.
inline constexpr std::size_t kVerticesPerChunk = 32;

/// Vertices first..last-1.
struct VertexRange {
  std::size_t first;
  std::size_t last;
  [[nodiscard]] std::size_t size() const { return last - first; }
};

constexpr std::size_t chunk_count(std::size_t vertices) {
  return (vertices + kVerticesPerChunk - 1) / kVerticesPerChunk;
}

constexpr VertexRange chunk_range(std::size_t chunk, std::size_t vertices) {
  return {chunk * kVerticesPerChunk, std::min(vertices, (chunk + 1) * kVerticesPerChunk)};
}

/// The number of threads to use: 0 stands for every core, and the result never exceeds the number of cores.
inline int thread_count(int threads) {
  const int cores = tbb::this_task_arena::max_concurrency();
  return threads == 0 ? cores : std::min(threads, cores);
}

/// Runs `work` in an arena of that many threads.
template <class Work>
void on_threads(int threads, const Work& work) {
  tbb::task_arena arena(thread_count(threads));
  arena.execute(work);
}

/// tbb::parallel_for, with the caller's rounding and denormals on every thread. The ray tracer flushes denormals while it
/// builds its tree; where this is the first loop of a process, threads would go on to flush them.
template <class... Arguments>
void in_parallel(Arguments&&... arguments) {
  using Context = tbb::task_group_context;
  Context callers(Context::bound, Context::default_traits | Context::fp_settings);
  tbb::parallel_for(std::forward<Arguments>(arguments)..., callers);
}

/// Calls each(chunk) for all chunks of `vertices` vertices, in parallel and in any order.
template <class Each>
void for_chunks(std::size_t vertices, const Each& each) {
  in_parallel(std::size_t{0}, chunk_count(vertices), each);
}

/// Calls each(vertex) for all vertices, in parallel; the vertices of a chunk in their order.
template <class Each>
void for_vertices(std::size_t vertices, const Each& each) {
  for_chunks(vertices, [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, vertices);
    for (std::size_t v = range.first; v < range.last; ++v) each(v);
  });
}

}  // namespace sh::prt
