#include "prt/medium/lit_medium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/medium/medium_ray.hpp"
#include "prt/medium/voxel_path.hpp"

namespace sh::prt {
namespace {

constexpr double kOpaque = 1e-7;  // less of the light behind is not seen

}  // namespace

LitMedium::LitMedium(const PointGrid& grid, const std::vector<float>& density, const std::vector<float>& source)
    : grid_(grid),
      density_(density),
      source_(source),
      rows_(source.size() / (3 * grid.points())),
      degree_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(rows_)))) - 1),
      corners_(corners_of_cells(grid)) {}

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

Marched LitMedium::march(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction, double farthest) const {
  Marched marched;
  std::array<float, coefficient_count(kMaxDegree)> basis{1.0F};
  if (degree_ > 0) {
    const Eigen::Vector3f d = direction.cast<float>();
    evaluate_basis(degree_, d.x(), d.y(), d.z(), basis.data());
  }
  double through = 1.0;
  Eigen::Vector3f near = Eigen::Vector3f::Zero();
  bool is_inside = false;
  const auto cross = [&](const CellPiece& piece, std::size_t corner, double depth) {
    if (depth == 0.0) {
      is_inside = false;
      return true;
    }
    if (!is_inside) near = sent(corner, trilinear(piece.enter), basis.data());
    is_inside = true;
    const Eigen::Vector3f far = sent(corner, trilinear(piece.leave), basis.data());
    const CellWeights weights = cell_weights(depth);
    marched.radiance +=
        static_cast<float>(through * weights.near) * near + static_cast<float>(through * weights.far) * far;
    through *= weights.through;
    near = far;
    if (through < kOpaque) through = 0.0;
    return through > 0.0;
  };
  for_cells(grid_, density_, eye, direction, farthest, cross);
  marched.transmittance = static_cast<float>(through);
  return marched;
}

Veil veil_of(std::vector<PlacedMedium> media, const Eigen::Vector3d& eye) {
  return [media = std::move(media), eye](const Eigen::Vector3f& direction, double distance) {
    struct Crossed {
      const PlacedMedium* medium;
      Eigen::Vector3d eye;  // in its axes
      Eigen::Vector3d direction;
      double enters;
    };
    std::vector<Crossed> crossed;
    for (const PlacedMedium& medium : media) {
      const Eigen::Matrix3d turn = medium.pose.rotation.transpose();
      const Eigen::Vector3d from = turn * (eye - medium.pose.position);
      const Eigen::Vector3d along = (turn * direction.cast<double>()).normalized();
      const auto [first, last] = within(medium.transfer->grid->box, from.array(), along.array());
      if (last > first && distance > first) crossed.push_back({&medium, from, along, first});
    }
    std::stable_sort(crossed.begin(), crossed.end(),
                     [](const Crossed& a, const Crossed& b) { return a.enters < b.enters; });
    Marched all;
    for (const Crossed& one : crossed) {
      const Transfer& transfer = *one.medium->transfer;
      const Marched own =
          LitMedium(*transfer.grid, transfer.density, one.medium->source).march(one.eye, one.direction, distance);
      all.radiance += all.transmittance * own.radiance;
      all.transmittance *= own.transmittance;
    }
    return all;
  };
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
