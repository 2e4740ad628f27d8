#include "prt/transfer/point_grid.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sh::prt {

std::string flaw_of(const PointGrid& grid) {
  constexpr double kFarthest = 1e30;
  const auto is_near = [](const Eigen::Vector3d& corner) { return corner.cwiseAbs().maxCoeff() <= kFarthest; };
  const Eigen::AlignedBox3d& box = grid.box;
  if (!box.min().allFinite() || !box.max().allFinite() || !is_near(box.min()) || !is_near(box.max()) ||
      !(box.sizes().minCoeff() > 0.0)) {
    return fmt::format("the box of its grid is from {:g} {:g} {:g} to {:g} {:g} {:g}, expected three sides above 0",
                       box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z());
  }
  const auto& counts = grid.counts;
  if (!std::all_of(counts.begin(), counts.end(), [](auto n) { return n >= kFewestAlong && n <= kMostAlong; }) ||
      grid.points() > kMostPoints) {
    return fmt::format("its grid has {} points, expected {} to {} along an axis and at most {} in all",
                       fmt::join(counts, " x "), kFewestAlong, kMostAlong, kMostPoints);
  }
  if (grid.filled > grid.points()) {
    return fmt::format("{} points of its grid are filled, expected at most {}", grid.filled, grid.points());
  }
  return {};
}

}  // namespace sh::prt
