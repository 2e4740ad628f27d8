// Conventions in use: engines, file formats, libraries.
//
// Each preset is the convention as its source writes it, in the source's own coordinates x, y, z (axes = identity), the
// place where it is documented, and what it covers. `world` says how those coordinates lie: the source's coordinates of
// a direction given in our world, x right, y forward, z up, right-handed; in_world() has them as its axes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symbolic/convention/convention.hpp"

namespace sh::symbolic {

struct Preset {
  std::string name;
  Convention convention;
  SignedPermutation world;
  std::string source;  ///< where the convention is documented: file or page
  std::string covers;  ///< what the coefficients are, and what is not covered

  [[nodiscard]] Convention in_world() const;
};

/// All presets; the first is this project's own convention, "shforge".
const std::vector<Preset>& presets();

/// The preset of that name; throws std::invalid_argument with the names that exist.
const Preset& find_preset(std::string_view name);

}  // namespace sh::symbolic
