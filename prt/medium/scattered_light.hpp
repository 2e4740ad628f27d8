// The light that the points of a medium send, from their transfer: by the generated drivers that relight surfaces.
#pragma once
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// (points, 3, result rows): radiance, W m^-2 sr^-1, or its coefficients by the direction in which a point is seen. The same
/// bits for any number of threads. Throws std::invalid_argument for a light of a higher degree.
std::vector<float> scattered_light(const Transfer& transfer, const LightCoefficients& light);

}  // namespace sh::prt
