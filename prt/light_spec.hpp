// A light as a scene file describes it: what to load, not yet any coefficients (prt/light.hpp makes those).
#pragma once
#include <Eigen/Core>
#include <string>

namespace sh::prt {

enum class LightType { kConstant, kCieOvercast, kEnvironment };

/// One light; a scene adds its lights up. Radiance is W m^-2 sr^-1, linear RGB.
struct LightSpec {
  LightType type = LightType::kCieOvercast;
  Eigen::Vector3f radiance = Eigen::Vector3f::Ones();  // constant: everywhere; cie_overcast: at the zenith
  std::string file;                                    // environment: lat-long EXR or Radiance .hdr, path resolved
  float scale = 1.0F;                                  // environment: factor on every pixel (exposure)
  Eigen::Vector3f rotation_axis = Eigen::Vector3f::UnitZ();
  float rotation_degrees = 0.0F;  // right-handed about the axis; turns the light, not the mesh
};

}  // namespace sh::prt
