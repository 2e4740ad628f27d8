#include "symbolic/errata/errata.hpp"

#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {
namespace {

std::vector<Entry> joined(std::initializer_list<std::vector<Entry>> parts) {
  std::vector<Entry> all;
  for (const std::vector<Entry>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Entry> green() {
  return joined({green_monte_carlo(), green_sampling(), green_legendre(), green_basis(), green_projection(),
                 green_reconstruction(), green_products(), green_rotation(), green_euler_angles(), green_transfer(),
                 green_rendering(), green_environments(), green_lights(), green_appendix()});
}

std::vector<Entry> gpfault() {
  return joined({gpfault_foundations(), gpfault_basis(), gpfault_real_basis(), gpfault_projection(),
                 gpfault_evaluation(), gpfault_irradiance()});
}

std::vector<Entry> sloan() {
  return joined({sloan_basis(), sloan_properties(), sloan_transfer(), sloan_simulation(), sloan_sampling()});
}

std::vector<Source> all_sources() {
  return {
      {"G", "Green, Spherical Harmonic Lighting: The Gritty Details, 2003", green()},
      {"GP", "gpfault.net, Introduction to Spherical Harmonics for Graphics Programmers, 2026", gpfault()},
      {"S", "Sloan, Kautz, Snyder, Precomputed Radiance Transfer, 2002", sloan()},
      {"B", "Brown, Spherical Harmonic Basis Functions, 2004", brown()},
      {"IR", "Ivanic, Ruedenberg, Rotation Matrices for Real Spherical Harmonics, 1996 with the corrections of 1998",
       ivanic_ruedenberg()},
      {"CH", "Choi, Ivanic, Gordon, Ruedenberg, Rapid and Stable Determination of Rotation Matrices, 1999", choi()},
      {"BL", "Blanco, Florez, Bermejo, Evaluation of the Rotation Matrices, 1997", blanco()},
      {"RH", "Ramamoorthi, Hanrahan, An Efficient Representation for Irradiance Environment Maps, 2001", ramamoorthi()},
  };
}

}  // namespace sh::symbolic::errata
