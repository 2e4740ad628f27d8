// Traces the rays of a shadowed bake: chunks of vertices on all threads, with results collected in place. In:
// unshadowed transfer vectors. Out: shadowed transfer vectors, the Sight of every vertex and, on request, the hits of
// its rays. prt/bake/steps.hpp has the formula.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/bake/checkpoint.hpp"
#include "prt/bake/row_tracer.hpp"

namespace sh::prt {

class ShadowPass {
 public:
  /// `result` holds unshadowed vectors, which run() replaces; `open` as in Plan. All must outlive the pass.
  ShadowPass(const RaySetup& setup, const std::vector<std::uint8_t>& open, ShadowResult& result)
      : setup_(setup), open_(open), result_(result) {}
  /// Traces all vertices that the checkpoint does not hold, and shows progress. Before every vertex it throws
  /// output::Interrupted if it is asked to stop. Returns the largest part of the cosine that a vertex lost by cutting
  /// paths between mirrors. Black vertices do not count.
  double run(Checkpoint& checkpoint);
  struct Sampled {
    std::size_t vertices = 0;  // at least one
    double seconds = 0.0;      // without those that buffers take once, which grow with the mesh
  };
  /// Traces these vertices in order, in the same way as run(), until the time is over.
  Sampled sample(const std::vector<std::uint32_t>& vertices, double seconds);

 private:
  struct Worker;  // the buffers of one thread
  void trace(std::size_t vertex, Worker& worker);

  const RaySetup& setup_;
  const std::vector<std::uint8_t>& open_;
  ShadowResult& result_;
};

}  // namespace sh::prt
