// Estimates what the certificate of the bounces does not cover. The certificate compares with the exact solution of the
// system that the rays and the vertices make. That system itself is coarse: light is interpolated between vertices, and
// its factors are sums over rays. Here rays from the centers of some faces find the light that leaves there, and the
// difference from the interpolated light is taken. A measurement, not a bound.
#pragma once
#include "prt/bake/bounces.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// Root mean squares over the centers and all numbers, faces weigh by their area.
struct BetweenVertices {
  double difference = 0.0;
  double light = 0.0;
};

/// `x` solves the bounces of the scene; `layout` names its columns. The rays are those of the bake.
BetweenVertices measure_between_vertices(const Scene& scene, const std::string& instruction_set, const Panel& x,
                                         const BounceLayout& layout);

}  // namespace sh::prt
