// A density as the points of a grid: its voxels with a border of one point on each side, where the medium ends.
#pragma once
#include <vector>

#include "prt/medium/density.hpp"
#include "prt/transfer/point_grid.hpp"

namespace sh::prt {

struct GridOfMedium {
  explicit GridOfMedium(const Density& extinction);

  PointGrid grid;              // `filled`: the border
  std::vector<float> density;  // (points)
};

}  // namespace sh::prt
