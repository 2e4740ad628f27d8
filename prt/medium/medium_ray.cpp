#include "prt/medium/medium_ray.hpp"

#include <algorithm>
#include <cmath>

namespace sh::prt {

std::array<std::size_t, 8> corners_of_cells(const PointGrid& grid) {
  std::array<std::size_t, 8> corners{};
  for (std::size_t c = 0; c < 8; ++c) {
    corners[c] = (c & 1U) + grid.counts[0] * (((c >> 1U) & 1U) + std::size_t{grid.counts[1]} * ((c >> 2U) & 1U));
  }
  return corners;
}

std::array<double, 2> within(const Eigen::AlignedBox3d& box, const Eigen::Array3d& eye,
                             const Eigen::Array3d& direction) {
  double first = 0.0;
  double last = std::numeric_limits<double>::infinity();
  for (Eigen::Index a = 0; a < 3; ++a) {
    if (direction[a] == 0.0) {
      if (eye[a] < box.min()[a] || eye[a] > box.max()[a]) last = 0.0;
      continue;
    }
    const double low = (box.min()[a] - eye[a]) / direction[a];
    const double high = (box.max()[a] - eye[a]) / direction[a];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return {first, last};
}

double transmittance(const PointGrid& grid, const std::vector<float>& density, const Eigen::Vector3d& point,
                     const Eigen::Vector3d& direction) {
  constexpr double kOpaque = 50.0;  // exp(-50) is below the rounding of single precision
  double all = 0.0;
  for_cells(grid, density, point, direction, std::numeric_limits<double>::infinity(),
            [&](const CellPiece& /*piece*/, std::size_t /*corner*/, double depth) {
              all += depth;
              return all < kOpaque;
            });
  return std::exp(-all);
}

}  // namespace sh::prt
