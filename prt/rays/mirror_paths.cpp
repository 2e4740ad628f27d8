#include "prt/rays/mirror_paths.hpp"

#include <algorithm>
#include <limits>

#include "prt/mesh/corners.hpp"

namespace sh::prt {

namespace {

constexpr float kRoundings = 32.0F;  // of the coordinates, off the mirror

}  // namespace

void MirrorPaths::follow(std::vector<Leg>& legs) const {
  std::vector<Eigen::Vector3f> origins;
  std::vector<Eigen::Vector3f> directions;
  std::vector<Hit> hits;
  for (std::size_t first = 0; any() && first < legs.size();) {
    const std::size_t last = legs.size();
    origins.clear();
    directions.clear();
    for (; first < last; ++first) {
      const Leg leg = legs[first];
      if (leg.hit.face == Hit::kNothing) continue;
      const Face& face = mesh_.faces[leg.hit.face];
      const Eigen::Vector3f& reflectance = mesh_.mirror[face[0]];  // a face has one
      const Eigen::Vector3f flat = face_normal(mesh_.positions, face);
      if (reflectance.isZero(0.0F) || flat.dot(leg.direction) >= 0.0F) continue;
      Leg next = leg;
      next.throughput = leg.throughput.cwiseProduct(reflectance);
      ++next.mirrors;
      if (next.mirrors > kMostMirrors || next.throughput.maxCoeff() < kLeastThroughput) {
        legs[first].is_cut = true;
        continue;
      }
      next.direction = mirrored(leg.direction, interpolated(leg.hit, mesh_, mesh_.normals).normalized());
      if (next.direction.dot(flat) <= 0.0F) next.direction = mirrored(leg.direction, flat);
      // The point is computed from the ray; a large face would give a coarse point.
      const Eigen::Vector3f point = leg.origin + leg.hit.distance * leg.direction;
      const float rounding =
          std::numeric_limits<float>::epsilon() * std::max(point.cwiseAbs().maxCoeff(), leg.hit.distance);
      next.origin = point + kRoundings * rounding * flat;
      origins.push_back(next.origin);
      directions.push_back(next.direction);
      legs.push_back(next);
    }
    hits.resize(origins.size());
    tracer_.intersect(origins, directions, hits);
    for (std::size_t i = 0; i < hits.size(); ++i) legs[last + i].hit = hits[i];
  }
}

}  // namespace sh::prt
