// Traces the rays of a shadowed bake: chunks of vertices on all threads, with results collected in place. In:
// unshadowed transfer vectors. Out: shadowed transfer vectors, the Sight of every vertex and, on request, the hits of
// its rays. prt/bake/steps.hpp has the formula.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/bake/checkpoint.hpp"
#include "prt/bake/gather.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/rays/mirror_paths.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Everything that the rays of a bake need. It lives as long as form factors may be traced again. The scene must
/// outlive it.
struct RaySetup {
  RaySetup(const Scene& scene, int threads, const std::string& instruction_set);

  Tracer tracer;
  MirrorPaths mirrors;
  SharedDirections directions;
  std::vector<RayStart> starts;
};

/// Replaces an unshadowed vector (count) by the shadowed one, f DU + (S - f S_all).
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer);

class ShadowPass {
 public:
  /// `result` holds unshadowed vectors, which run() replaces; `open` as in Plan. All must outlive the pass.
  ShadowPass(const Mesh& mesh, const RaySetup& setup, const std::vector<std::uint8_t>& open, ShadowResult& result);
  /// Traces all vertices that the checkpoint does not hold, and shows progress. Before every vertex it throws
  /// output::Interrupted if it is asked to stop.
  void run(Checkpoint& checkpoint);
  /// The largest part of the cosine that run() lost at a vertex by cutting paths between mirrors. Black vertices do not
  /// count.
  [[nodiscard]] double largest_cut() const { return largest_cut_; }
  /// Traces these vertices in order, in the same way as run(), until the time is over. Returns how many were traced, at
  /// least one.
  std::size_t sample(const std::vector<std::uint32_t>& vertices, double seconds);

 private:
  struct Worker;  // the buffers of one thread
  void trace(const VertexRange& range, Worker& worker);
  void trace(std::size_t vertex, Worker& worker);
  void keep_row(std::size_t vertex, const std::vector<BlockedRay>& met, Worker& worker);

  const Mesh& mesh_;
  const RaySetup& setup_;
  const std::vector<std::uint8_t>& open_;
  ShadowResult& result_;
  double largest_cut_ = 0.0;
};

}  // namespace sh::prt
