#include "prt/plan/probe.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "numeric/output/progress.hpp"
#include "prt/bake/chunks.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/bake/unshadowed.hpp"

namespace sh::prt {

Probe::Probe(const Scene& scene, const std::vector<RayStart>& starts, std::size_t vertices,
             const std::string& instruction_set)
    : scene_(scene), starts_(starts), tracer_(scene.mesh, tbb::this_task_arena::max_concurrency(), instruction_set) {
  const std::size_t count = std::min(vertices, starts.size());
  for (std::size_t k = 0; k < count; ++k) {
    vertices_.push_back(static_cast<std::uint32_t>((2 * k + 1) * starts.size() / (2 * count)));
  }
}

ProbeRows Probe::bake(const std::vector<std::uint8_t>& open, int directions) const {
  BakeOptions options = scene_.bake;
  options.directions = directions;
  const SharedDirections shared(options);
  std::vector<Eigen::Vector3f> normals;
  for (const std::uint32_t v : vertices_) normals.push_back(scene_.mesh.normals[v]);
  ProbeRows rows{unshadowed_transfer(options.degree, normals), std::vector<double>(vertices_.size(), 0.0)};
  const std::size_t count = coefficient_count(options.degree);
  for_chunks(vertices_.size(), [&](std::size_t chunk) {
    Gatherer gatherer(shared, tracer_);
    const VertexRange range = chunk_range(chunk, vertices_.size());
    for (std::size_t k = range.first; k < range.last; ++k) {
      output::check_interrupt();
      const std::uint32_t v = vertices_[k];
      if (open[v] == 0) {
        const Gathered& seen =
            gatherer.gather(starts_[v].origin, scene_.mesh.normals[v], scene_.mesh.geometric_normals[v]);
        control_with_unshadowed(seen, count, rows.transfer.data() + k * count);
        rows.blocked[k] = 1.0 - static_cast<double>(seen.fraction());
      }
    }
  });
  return rows;
}

double rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace sh::prt
