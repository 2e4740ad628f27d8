// Rays against a mesh: a thin wrapper, the only place that knows Embree.
// Embree 4 has no stream calls; occluded() and intersect() are where packets would take their place.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "prt/mesh.hpp"

namespace sh::prt {

/// The closest hit: point = (1-u-v) p0 + u p1 + v p2 of the face.
struct Hit {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  std::uint32_t face = kNothing;
  float u = 0.0F;
  float v = 0.0F;
  float distance = 0.0F;
};

/// A mesh ready for rays. Const calls may come from any thread. The mesh may go away after construction.
class Tracer {
 public:
  /// `threads` builds the tree; 0 takes every core. Throws std::runtime_error when Embree refuses.
  explicit Tracer(const Mesh& mesh, int threads = 0);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// Closest hits of origins[i] + t directions[i], t > 0; the three spans have one length.
  void intersect(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
                 std::span<Hit> hits) const;

  /// Which rays from `origin` along directions[i] hit anything: blocked[i] = 1 or 0.
  void occluded(const Eigen::Vector3f& origin, std::span<const Eigen::Vector3f> directions,
                std::span<std::uint8_t> blocked) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sh::prt
