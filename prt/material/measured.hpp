// Measured isotropic BRDFs of the MERL data base [MatusikPfisterBrandMcMillan03], in the coordinates of Rusinkiewicz: the
// angle of the half vector to the normal (90 steps, finer near the normal), and the light about the half vector, by its
// angle (90 steps of 1 degree) and azimuth (180 steps of 1 degree; half a turn, because a BRDF is reciprocal).
//   three 32-bit counts, 90 90 180; then red, green and blue, each 90 x 90 x 180 binary64, in units of 1/1500, 1.15/1500
//   and 1.66/1500 a steradian; little-endian
#pragma once
#include <string>
#include <vector>

#include "prt/material/reflectance.hpp"

namespace sh::prt {

struct MeasuredReflectance {
  Reflectance reflectance;
  Eigen::Vector3f albedo;          // mean hemispherical reflectance, linear RGB, 0..1: what a diffuse surface shows
  std::vector<std::string> flaws;  // negative values that light meets, and surfaces that send more than they get
};

/// Throws std::runtime_error, one line that begins with the path, for a file that is missing, of another size or other
/// counts, or whose values are not finite or mostly negative where light meets them. Values below 0 elsewhere count as 0,
/// as the data base has them below the horizon.
MeasuredReflectance read_measured_reflectance(const std::string& path);

}  // namespace sh::prt
