// Rays that mirrors reflect: the [S]* paths of [SloanKautzSnyder02], section 5.
// A ray that meets the front of a mirror continues in the mirrored direction, and its throughput is multiplied by the
// reflectance. It is mirrored about the interpolated normal, or about the face normal if the path would otherwise enter
// the surface. Paths end after kMostMirrors mirrors or when no channel of their throughput reaches kLeastThroughput.
// The error of this cut is at most the throughput times the radiance that the path would have met.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {

/// A straight part of a path. It starts at the origin of the path or at a mirror and ends at its hit.
struct Leg {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
  Hit hit;                                               // kNothing: the path leaves the scene
  std::uint32_t ray = 0;                                 // index of the ray that this leg belongs to
  std::uint32_t mirrors = 0;                             // number of mirrors before this leg on its path
  Eigen::Vector3f throughput = Eigen::Vector3f::Ones();  // product of the reflectances
  bool is_cut = false;                                   // the path is cut at a mirror
};

class MirrorPaths {
 public:
  static constexpr std::uint32_t kMostMirrors = 64;
  static constexpr float kLeastThroughput = 1e-4F;

  /// Mesh and tracer must outlive this object.
  MirrorPaths(const Mesh& mesh, const Tracer& tracer) : mesh_(mesh), tracer_(tracer) {}
  [[nodiscard]] bool any() const { return !mesh_.mirror.empty(); }
  /// `legs` holds the first leg of each path; follow() appends the other legs.
  void follow(std::vector<Leg>& legs) const;

 private:
  const Mesh& mesh_;
  const Tracer& tracer_;
};

}  // namespace sh::prt
