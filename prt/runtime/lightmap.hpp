// Lightmaps: pictures over the atlas of a mesh, whose texels are receivers (prt/mesh/atlas.hpp), and how well they join where
// a part of the surface ends in the atlas and goes on elsewhere.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "prt/image/exr_writer.hpp"
#include "prt/rays/receivers_at.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A value of every vertex as the picture of an atlas: the channels PREFIX + R, G, B. Pixels without a texel have the value
/// of a texel beside them, so that no filter reads from outside.
std::vector<ExrChannel> channels_of(const SurfaceReceivers& receivers, std::size_t atlas,
                                    const std::vector<Eigen::Vector3f>& values, const std::string& prefix = "");

/// The irradiance at every vertex, W m^-2, from the exit radiance of surfaces of this albedo: pi radiance / albedo, without
/// the emitted light. A black surface tells none: 0.
std::vector<Eigen::Vector3f> irradiance_of(const Transfer& transfer, const std::vector<Eigen::Vector3f>& radiance,
                                           const std::vector<Eigen::Vector3f>& albedo);

/// Irradiance by direction: e_0 + e_1 y + e_2 z + e_3 x at a unit normal, in the axes of the world, for every vertex
/// [O'Donnell 2018, the generated kernel `lightmap`]. So a normal map meets a lightmap.
std::array<std::vector<Eigen::Vector3f>, 4> directional_irradiance(const Transfer& transfer,
                                                                   const TransferredRadiance& reaching);

/// Where faces of an atlas meet on the surface, smoothly, but not in the atlas: the root mean square of the difference that
/// a value has between both sides, and of the value.
struct Seams {
  std::size_t edges = 0;
  double difference = 0.0;
  double value = 0.0;
};
Seams measure_seams(const Mesh& mesh, const SurfaceReceivers& receivers, const std::vector<Eigen::Vector3f>& values);

}  // namespace sh::prt
