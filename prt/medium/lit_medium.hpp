// Pictures of a medium whose points send known light: rays through the grid, front to back, and the light behind.
// Within a cell, the light that it sends is that of prt/medium/voxel_path.hpp: the optical depth is exact, the source
// linear in it between the faces.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "prt/runtime/render.hpp"
#include "prt/scene/stage.hpp"
#include "prt/transfer/point_grid.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

class LitMedium {
 public:
  /// density (points): extinction; source (points, 3, result rows): what a point sends, as radiance (one row) or as SH
  /// coefficients of the direction in which it is seen. The arguments must outlive this object.
  LitMedium(const PointGrid& grid, const std::vector<float>& density, const std::vector<float>& source);

  /// Along a ray from a point of the world in a unit direction, up to a distance.
  [[nodiscard]] Marched march(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                              double farthest = std::numeric_limits<double>::infinity()) const;

 private:
  [[nodiscard]] Eigen::Vector3f sent(std::size_t corner, const std::array<double, 8>& share, const float* basis) const;

  const PointGrid& grid_;
  const std::vector<float>& density_;
  const std::vector<float>& source_;
  std::size_t rows_;
  int degree_;
  std::array<std::size_t, 8> corners_;  // relative to the lowest one
};

/// A medium of a stage, with the light that its points send.
struct PlacedMedium {
  const Transfer* transfer;
  Pose pose;
  std::vector<float> source;  // as LitMedium takes it
};

/// The media before what an eye sees, from front to back by the places where a ray enters their boxes. The transfer must
/// outlive the result.
Veil veil_of(std::vector<PlacedMedium> media, const Eigen::Vector3d& eye);

/// The same bits for any number of threads. Coverage is the part of the light behind that the medium takes. Progress on
/// standard error is labeled `what`. Throws std::invalid_argument for an unusable camera or size.
Picture render(const LitMedium& medium, const Camera& camera, const PictureSize& size, const Background& background,
               const std::string& what);

}  // namespace sh::prt
