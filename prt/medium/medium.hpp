// A medium that scatters light: smoke, a cloud.
#pragma once
#include <Eigen/Core>
#include <string>

#include "prt/medium/density.hpp"

namespace sh::prt {

/// Of a scene that does not say: 24 * 4^2.
inline constexpr int kMediumDirections = 384;

struct Medium {
  Density extinction;                                // 1 / unit of the scene: the part of the light that a unit takes
  Eigen::Vector3f albedo = Eigen::Vector3f::Ones();  // the part of it that scatters, linear RGB, 0..1
  double anisotropy = 0.0;  // g of the phase function [HenyeyGreenstein41], the mean cosine; 0: isotropic
  std::string file;         // that the density is read from; empty: made
};

}  // namespace sh::prt
