// Rays that mirrors send on: the [S]* paths of [SloanKautzSnyder02], section 5.
// A ray that meets the front of a mirror goes on in the mirrored direction, with the reflectance on its account; about
// the interpolated normal, or the face's where that would lead into the surface. What else the surface does, diffusely
// or of its own, is met where the ray meets it. Paths end after kMostMirrors mirrors or where no channel of their
// throughput reaches kLeastThroughput: what is left out is at most the throughput times what is there.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {

/// A straight part of a path, from where it begins or from a mirror to what it meets.
struct Leg {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
  Hit hit;                                               // kNothing: it leaves the scene
  std::uint32_t ray = 0;                                 // which of the rays it is a part of
  std::uint32_t mirrors = 0;                             // before it on its path
  Eigen::Vector3f throughput = Eigen::Vector3f::Ones();  // product of their reflectances
  bool is_cut = false;                                   // it ends on a mirror, where it would go on
};

class MirrorPaths {
 public:
  static constexpr std::uint32_t kMostMirrors = 64;
  static constexpr float kLeastThroughput = 1e-4F;

  /// Both must outlive it.
  MirrorPaths(const Mesh& mesh, const Tracer& tracer) : mesh_(mesh), tracer_(tracer) {}
  [[nodiscard]] bool any() const { return !mesh_.mirror.empty(); }
  /// `legs` holds the first of each path; the others are appended.
  void follow(std::vector<Leg>& legs) const;

 private:
  const Mesh& mesh_;
  const Tracer& tracer_;
};

}  // namespace sh::prt
