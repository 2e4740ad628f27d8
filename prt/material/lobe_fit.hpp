// Circularly symmetric fits of BRDFs: a lobe about the mirrored direction of view (prt/material/lobe.hpp) and the clamped
// cosine about the normal in place of a table [KautzSloanSnyder02, section 3]. They cost less in every bounce and at run
// time, and show neither Fresnel's rise of reflectance nor the stretched lobes at grazing views.
#pragma once
#include <array>

#include "prt/material/reflectance.hpp"

namespace sh::prt {

struct LobeFit {
  float exponent = 0.0F;  // 0..kMaxExponent
  /// What each part of the table gives to the diffuse reflectance and to that of the lobe, 0..1.
  std::array<double, kReflectionParts> diffuse{};
  std::array<double, kReflectionParts> specular{};
  /// Of the coefficients, RMS over RMS, over views with the density of the cosine; a surface model has albedo 0.5 here.
  double error = 0.0;
};

/// The least squares over views, with the density of the cosine, in the bands 0 .. degree: each part of the table by
/// itself, then the exponent with the least error. No share is negative, and constant light gains no energy.
LobeFit fit_lobe(const BrdfTable& table, int degree);

}  // namespace sh::prt
