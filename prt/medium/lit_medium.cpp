#include "prt/medium/lit_medium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/output/progress.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/medium/cell_walk.hpp"
#include "prt/medium/voxel_path.hpp"

namespace sh::prt {
namespace {

constexpr double kOpaque = 1e-7;  // less of the light behind is not seen

// Where a ray is within the box: its distances; none if the second is not above the first.
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

}  // namespace

LitMedium::LitMedium(const PointGrid& grid, const std::vector<float>& density, const std::vector<float>& source)
    : grid_(grid),
      density_(density),
      source_(source),
      rows_(source.size() / (3 * grid.points())),
      degree_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(rows_)))) - 1) {
  for (std::size_t c = 0; c < 8; ++c) {
    corners_[c] = (c & 1U) + grid.counts[0] * (((c >> 1U) & 1U) + std::size_t{grid.counts[1]} * ((c >> 2U) & 1U));
  }
}

Eigen::Vector3f LitMedium::sent(std::size_t corner, const std::array<double, 8>& share, const float* basis) const {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t c = 0; c < 8; ++c) {
    const auto part = static_cast<float>(share[c]);
    if (part == 0.0F) continue;
    const float* own = &source_[(corner + corners_[c]) * 3 * rows_];
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      float radiance = 0.0F;
      for (std::size_t r = 0; r < rows_; ++r) radiance += own[static_cast<std::size_t>(channel) * rows_ + r] * basis[r];
      sum[channel] += part * radiance;
    }
  }
  return sum;
}

Marched LitMedium::march(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const {
  Marched marched;
  const auto [first, last] = within(grid_.box, eye.array(), direction.array());
  if (!(last > first)) return marched;
  std::array<float, coefficient_count(kMaxDegree)> basis{1.0F};
  if (degree_ > 0) {
    const Eigen::Vector3f d = direction.cast<float>();
    evaluate_basis(degree_, d.x(), d.y(), d.z(), basis.data());
  }
  const Eigen::Array3d spacing = grid_.spacing().array();
  const Eigen::Array3d start = (eye + first * direction - grid_.box.min()).array() / spacing;
  CellWalk walk(start, direction.array() / spacing);
  double through = 1.0;
  Eigen::Vector3f near = Eigen::Vector3f::Zero();
  bool is_inside = false;
  while (true) {
    const CellPiece piece = walk.next();
    if (!(piece.from < last - first)) break;
    bool is_cell = true;
    for (std::size_t a = 0; a < 3; ++a) {
      is_cell = is_cell && piece.place[a] >= 0 && piece.place[a] + 1 < static_cast<int>(grid_.counts[a]);
    }
    if (!is_cell) continue;  // a rounding at the border
    const std::size_t corner =
        grid_.index({static_cast<std::uint32_t>(piece.place[0]), static_cast<std::uint32_t>(piece.place[1]),
                     static_cast<std::uint32_t>(piece.place[2])});
    const std::array<double, 8> shares = piece.integral();
    double depth = 0.0;
    for (std::size_t c = 0; c < 8; ++c) depth += shares[c] * static_cast<double>(density_[corner + corners_[c]]);
    if (depth == 0.0) {
      is_inside = false;
      continue;
    }
    if (!is_inside) near = sent(corner, trilinear(piece.enter), basis.data());
    is_inside = true;
    const Eigen::Vector3f far = sent(corner, trilinear(piece.leave), basis.data());
    const CellWeights weights = cell_weights(depth);
    marched.radiance +=
        static_cast<float>(through * weights.near) * near + static_cast<float>(through * weights.far) * far;
    through *= weights.through;
    near = far;
    if (through < kOpaque) {
      through = 0.0;
      break;
    }
  }
  marched.transmittance = static_cast<float>(through);
  return marched;
}

Picture render(const LitMedium& medium, const Camera& camera, const PictureSize& size, const Background& background,
               const std::string& what) {
  require_picture_size(size);
  const CameraFrame frame(camera, size);
  const int pixels = size.width * size.height;
  Picture picture{size.width, size.height, std::vector<Eigen::Vector3f>(pixels), std::vector<float>(pixels)};
  output::Progress progress(what, size.height);
  in_parallel(0, size.height, [&](int row) {
    const std::vector<Eigen::Vector3f> directions = frame.directions(row, size);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const Marched marched = medium.march(camera.position, directions[k].cast<double>().normalized());
      const std::size_t pixel = static_cast<std::size_t>(row) * size.width + k / size.samples;
      const float share = 1.0F / static_cast<float>(size.samples);
      if (k % size.samples == 0) picture.radiance[pixel].setZero();
      picture.radiance[pixel] += share * (marched.radiance + marched.transmittance * background(directions[k]));
      picture.coverage[pixel] += share * (1.0F - marched.transmittance);
    }
    progress.advance();
  });
  progress.finish();
  return picture;
}

}  // namespace sh::prt
