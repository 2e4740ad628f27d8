// A few vertices, spread evenly over a mesh's, baked with any number of directions, on which a plan measures.
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
  std::vector<double> blocked;  // (vertices of the probe) part of the cosine that something is in the way of, 0..1
};

class Probe {
 public:
  /// Of at most `vertices` vertices. All but `instruction_set` must outlive the probe.
  Probe(const Scene& scene, const std::vector<RayStart>& starts, std::size_t vertices,
        const std::string& instruction_set);
  /// Shadowed transfer along that many directions of the scene's sampler; vertices that are `open` (as in Plan,
  /// not empty) take no rays. Runs on the threads of the caller's arena.
  [[nodiscard]] ProbeRows bake(const std::vector<std::uint8_t>& open, int directions) const;
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }

 private:
  const Scene& scene_;
  const std::vector<RayStart>& starts_;
  Tracer tracer_;
  std::vector<std::uint32_t> vertices_;
};

/// Root of the mean of squares; 0 of nothing.
double rms(const std::vector<double>& values);

}  // namespace sh::prt
