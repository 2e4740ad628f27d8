// Local lighting: samples near lights at a few points; every vertex blends the lights of these points. It serves
// unshadowed and shadowed transfer only: light that bounces comes from other places than the vertex [SloanKautzSnyder02
// section 6.1; Green03, "Rendering SH Diffuse Surfaces"].
//   distance    k-means spreads k points over the mesh. The weight of point j at a vertex is d_j^-4 over the sum
//               of all weights; d_j is the distance between them
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

/// The points at which the light is sampled, and the weight of each sample at every vertex.
struct LightSamples {
  std::vector<Eigen::Vector3d> points;  // (k)
  std::vector<float> weights;           // (vertices, k)
};

/// Runs k-means over the vertices, which are in the world. It starts with the vertex nearest to their mean, then adds
/// the vertex farthest from all points so far, so that the same mesh always gives the same points. 1 <= k <=
/// kMaxLightSamples, else it throws std::invalid_argument. The result has fewer points if the mesh has fewer distinct
/// positions.
LightSamples samples_by_distance(std::span<const Eigen::Vector3d> vertices, int k);

/// The six corners of the octahedron; a flat bounding box gets a little thickness. Throws std::invalid_argument for a
/// mesh without extent.
LightSamples samples_on_octahedron(std::span<const Eigen::Vector3d> vertices);

/// Exit radiance per vertex under `lights` (k), blended by the weights of the samples. Each light comes from
/// `shading.chosen`. One light gives the same bits as shading.shade. Throws std::invalid_argument for transfer with
/// bounces, for counts that do not fit, and for the same reasons as shading.shade.
std::vector<Eigen::Vector3f> relight_locally(const Transfer& transfer, const LightSamples& samples,
                                             std::span<const LightCoefficients> lights, const Shading& shading = {});

}  // namespace sh::prt
