// A few vertices, spread evenly over the vertices of a mesh, on which a plan measures bakes with any number of
// directions.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/bake/gather.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

struct ProbeRows {
  std::vector<float> transfer;  // (vertices of the probe, bands^2) without albedo
  std::vector<double> blocked;  // (vertices of the probe) blocked part of the cosine, 0..1
};

class Probe {
 public:
  /// A probe of at most `vertices` vertices. `scene` and `starts` must outlive the probe.
  Probe(const Scene& scene, const std::vector<RayStart>& starts, std::size_t vertices,
        const std::string& instruction_set);
  /// Shadowed transfer with `directions` directions of the scene's sampler. Vertices that are `open` (as in Plan, not
  /// empty) need no rays. Runs on the threads of the caller's arena.
  [[nodiscard]] ProbeRows bake(const std::vector<std::uint8_t>& open, int directions) const;
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }

 private:
  const Scene& scene_;
  const std::vector<RayStart>& starts_;
  Tracer tracer_;
  std::vector<std::uint32_t> vertices_;
};

/// The root mean square; 0 if there are no values.
double rms(const std::vector<double>& values);

}  // namespace sh::prt
