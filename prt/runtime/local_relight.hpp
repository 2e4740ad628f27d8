// Local lighting: near lights are sampled at a few points, and every vertex blends the lights seen from these.
// For unshadowed and shadowed transfer only: light that bounces comes from other places than the vertex
// [SloanKautzSnyder02 section 6.1; Green03, "Rendering SH Diffuse Surfaces"].
//   distance    k points spread over the mesh by k-means; weight of point j at a vertex d_j^-4 over the sum of all, d_j
//               their distance
//   polyhedron  the corners of the octahedron through the middles of the bounding box's sides; a vertex takes the
//               barycentric coordinates of the nearest point on its faces
// The weights of a vertex are not negative and add up to 1. Relighting is linear in the light: the blend of the lights
// is the blend of the relit vertices, so it costs k times relighting.
#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

inline constexpr int kMaxLightSamples = 64;

/// Where the light is sampled, and how much of each sample a vertex takes.
struct LightSamples {
  std::vector<Eigen::Vector3d> points;  // (k)
  std::vector<float> weights;           // (vertices, k)
};

/// k-means over the vertices, from the vertex nearest to their mean and then each time the one farthest from all points
/// so far: no chance in it, the same points for the same mesh. 1 <= k <= kMaxLightSamples, fewer where the mesh has
/// fewer places; throws std::invalid_argument otherwise.
LightSamples samples_by_distance(std::span<const Eigen::Vector3f> vertices, int k);

/// Six points; a flat box is given a little thickness. Throws std::invalid_argument for a mesh without extent.
LightSamples samples_on_octahedron(std::span<const Eigen::Vector3f> vertices);

/// Exit radiance per vertex under lights (k), each as `shading.chosen` gave it, blended by the samples' weights. One
/// light: the bits of shading.shade. Throws std::invalid_argument for transfer with bounces, where counts do not fit,
/// and as that.
std::vector<Eigen::Vector3f> relight_locally(const Transfer& transfer, const LightSamples& samples,
                                             std::span<const LightCoefficients> lights, const Shading& shading = {});

}  // namespace sh::prt
