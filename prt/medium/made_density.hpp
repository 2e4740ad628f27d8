// Densities made from a seed. Integer hashes and operations that IEEE 754 rounds correctly: the same bytes on every machine.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/medium/density.hpp"

namespace sh::prt {

/// kUniform: 1 everywhere. kCloud: a heap of round puffs with a flat base, roughened by noise. kSmoke: a plume that
/// rises along z, widens and thins. Densities are 0..1; cloud and smoke do not touch the sides of the grid.
enum class MadeDensity { kUniform, kCloud, kSmoke };
inline constexpr std::array<std::string_view, 3> kMadeDensityNames = {"uniform", "cloud", "smoke"};

/// (z, y, x) values of a grid. A finer grid shows the same cloud in more detail.
std::vector<float> make_density(MadeDensity made, const Counts& counts, std::uint32_t seed);

}  // namespace sh::prt
