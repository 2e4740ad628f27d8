// The light that a vertex sees in mirrors: the sky, which is added to its transfer vector, and other surfaces, which
// are added to its row of the form factors. Mirrors are gray: only the first channel of a reflectance counts
// (prt/bake/colored_mirrors.hpp handles colored mirrors). In: the closest hits of the blocked rays. A path that leaves
// the scene in direction s adds
//   (its part of the cosine) * (product of the reflectances) * Y(s).
#pragma once
#include <vector>

#include "prt/bake/gather.hpp"
#include "prt/rays/mirror_paths.hpp"

namespace sh::prt {

/// Follows mirror paths, with the reusable buffers of one thread.
class MirrorLight {
 public:
  explicit MirrorLight(const MirrorPaths& paths) : paths_(paths) {}

  /// Follows the rays from `origin`. The result holds these rays and the hits at the ends of their mirror paths, with
  /// the remaining parts of the cosine. It is valid until the next call.
  const std::vector<BlockedRay>& follow(const Eigen::Vector3f& origin, const std::vector<BlockedRay>& closest);
  /// Adds the sky that the last follow() found to a transfer vector (bands^2); returns its part of the cosine.
  float add_sky(int degree, float* transfer) const;
  /// The part of the cosine that the last follow() left out where it cut paths.
  [[nodiscard]] double cut() const { return cut_; }

 private:
  const MirrorPaths& paths_;
  std::vector<Leg> legs_;
  std::vector<BlockedRay> met_;
  std::vector<BlockedRay> sky_;
  double cut_ = 0.0;
};

}  // namespace sh::prt
