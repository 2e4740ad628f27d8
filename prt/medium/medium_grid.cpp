#include "prt/medium/medium_grid.hpp"

namespace sh::prt {

GridOfMedium::GridOfMedium(const Density& extinction) {
  const PaddedDensity padded(extinction);
  grid.box = extinction.support();
  for (std::size_t a = 0; a < 3; ++a) grid.counts[a] = static_cast<std::uint32_t>(extinction.counts[a] + 2);
  grid.filled = grid.points() - extinction.size();
  for (std::size_t point = 0; point < grid.points(); ++point) density.push_back(static_cast<float>(*padded.at(point)));
}

}  // namespace sh::prt
