// Lobes in place of the BRDFs of a mesh.
#pragma once
#include <string>
#include <vector>

#include "prt/material/lobe_fit.hpp"
#include "prt/mesh/mesh.hpp"

namespace sh::prt {

struct FittedBrdf {
  std::string name;
  LobeFit fit;
};

/// One line for people.
std::string described(const FittedBrdf& fitted);

/// Gives the vertices that have a BRDF the albedo, the lobe and its exponent that are nearest to it in the bands
/// 0 .. degree, and leaves out the tables. Returns the fit of each table.
std::vector<FittedBrdf> fit_lobes(Mesh& mesh, int degree);

}  // namespace sh::prt
