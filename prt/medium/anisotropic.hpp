// Light that scatters in a medium whose phase function prefers a direction, as SH coefficients of the direction in which a
// voxel is seen. A phase function of the angle alone scales the bands of the light that reaches a voxel: by g^l, for
// [HenyeyGreenstein41]. With the light L_v(s) that reaches voxel v from direction s,
//   J = sum of all orders,   J_vlm = albedo g^l integral of L_v Y_lm,   L_v(s) = transmittance * light(s) + what the cells on
//   the way send of J(s).
#pragma once
#include "prt/medium/medium.hpp"
#include "prt/medium/scattering.hpp"
#include "prt/scene/options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct AnisotropicLight {
  std::vector<float>
      rows;             // (voxels, 3, result bands^2, bands^2): coefficients of J for unit coefficients of the light
  BounceReport report;  // not certified: the end is measured by the rate at which orders shrink
};

/// Light and result of this degree. The same bits for any number of threads. Shows progress. Throws std::runtime_error,
/// beginning with `name`, if the orders do not shrink, and output::Interrupted.
AnisotropicLight scatter_anisotropically(const Scattering& scattering, const Medium& medium, int degree,
                                         const BounceOptions& options, const std::string& name);

/// The memory that it needs, in bytes.
std::size_t anisotropic_bytes(std::size_t voxels, int degree);

}  // namespace sh::prt
