// Relighting: baked transfer vectors times a light's coefficients.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Exit radiance per vertex, (vertices), linear RGB, W m^-2 sr^-1, as transfer.hpp says. Single precision; slightly
/// negative where a band-limited light rings. Throws std::invalid_argument unless both have one degree.
std::vector<Eigen::Vector3f> relight(const Transfer& transfer, const LightCoefficients& light);

/// The mesh with float vertex properties red, green, blue (linear exit radiance), binary little-endian PLY. The file
/// appears complete or not at all. Throws std::runtime_error naming `file`.
void write_ply(const std::string& file, const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance);

}  // namespace sh::prt
