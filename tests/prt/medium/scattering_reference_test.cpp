// Multiple scattering against answers of other methods: random walks, and diffusion between the sides of a thick slab.
#include <gtest/gtest.h>

#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "tests/prt/medium/media.hpp"

namespace sh::prt::test {
namespace {

/// Light of degree 1 whose radiance in direction s is 1 + 0.8 s.x - 0.5 s.z.
double radiance_of(const Eigen::Vector3d& s) { return 1.0 + 0.8 * s.x() - 0.5 * s.z(); }

/// Coefficients of that light by the definition of band 1 (y, z, x).
std::array<double, 4> coefficients() {
  const double first = std::sqrt(4.0 * std::numbers::pi);
  const double second = std::sqrt(4.0 * std::numbers::pi / 3.0);
  return {first, 0.0, -0.5 * second, 0.8 * second};
}

/// The light that each voxel scatters, by the solver.
std::vector<double> solved(const Density& density, double albedo, int along) {
  const Scattering scattering(density, medium_directions(along));
  const std::vector<float> direct = scattering.direct(1);
  const BounceLayout layout{4};
  Panel x(density.size(), layout.columns());
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 4; ++i) x.row(v)[layout.channel(c) + i] = albedo * double(direct[4 * v + i]);
    }
  }
  const std::vector<Eigen::Vector3f> albedos(density.size(), Eigen::Vector3f::Constant(float(albedo)));
  EXPECT_TRUE(solve_bounces(scattering.between_voxels(SIZE_MAX), albedos, layout, x).certified);
  std::vector<double> light;
  for (std::size_t v = 0; v < x.rows; ++v) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += x.row(v)[i] * coefficients()[i];
    light.push_back(sum);
  }
  return light;
}

/// Random walks by the method of fictitious scattering [Woodcock65]: independent of cells, directions and solver.
class Walks {
 public:
  Walks(const Density& density, std::uint64_t seed) : density_(density), random_(seed) {
    for (const float value : density.values) most_ = std::max(most_, double(value));
  }

  /// The light that the medium scatters at a voxel's center: mean, and its standard error.
  std::pair<double, double> light(std::size_t voxel, double albedo, int count) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
      const double light = albedo * walk(density_.center(voxel), albedo);
      sum += light;
      squares += light * light;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / count)};
  }

 private:
  double uniform() { return 0.5 * (random_.next() + 1.0); }

  double density_at(const Eigen::Vector3d& point) const {
    const Eigen::Array3d p = (point - density_.first).array() / density_.spacing.array();
    const Eigen::Array3d low = p.floor();
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const int x = int(low.x()) + (corner & 1);
      const int y = int(low.y()) + (corner >> 1 & 1);
      const int z = int(low.z()) + (corner >> 2);
      if (x < 0 || y < 0 || z < 0 || x >= density_.counts[0] || y >= density_.counts[1] || z >= density_.counts[2])
        continue;
      sum += (1.0 - std::abs(p.x() - x)) * (1.0 - std::abs(p.y() - y)) * (1.0 - std::abs(p.z() - z)) *
             double(density_.values[density_.index(x, y, z)]);
    }
    return sum;
  }

  double walk(Eigen::Vector3d at, double albedo) {
    const Eigen::AlignedBox3d box = density_.support();
    double weight = 1.0;
    while (true) {
      const double z = random_.next();
      const double azimuth = std::numbers::pi * random_.next();
      const double r = std::sqrt(1.0 - z * z);
      const Eigen::Vector3d s(r * std::cos(azimuth), r * std::sin(azimuth), z);
      do {
        at -= std::log(1.0 - uniform()) / most_ * s;
        if (!box.contains(at)) return weight * radiance_of(s);
      } while (uniform() * most_ >= density_at(at));
      weight *= albedo;
    }
  }

  const Density& density_;
  numeric::Random random_;
  double most_ = 0.0;
};

void expect_walks(const Density& density, double albedo, int along, double besides) {
  const std::vector<double> light = solved(density, albedo, along);
  Walks walks(density, 17);
  for (const double part : {0.1, 0.37, 0.5, 0.81}) {
    const auto voxel = std::size_t(part * double(density.size()));
    const auto [mean, error] = walks.light(voxel, albedo, 100000);
    EXPECT_NEAR(light[voxel], mean, 4.0 * error + besides * mean) << voxel;
  }
}

// Cells of an optical depth of 0.25, of up to 0.4 and of up to 1, where the error of cells exceeds that of the walks.
TEST(Scattering, AgreesWithRandomWalks) {
  expect_walks(uniform({9, 8, 10}, 0.5, 0.5F), 0.9, 4, 0.0);
  expect_walks(uneven({6, 6, 6}, 0.5, 0.8F, 4), 1.0, 4, 0.0);
  expect_walks(uneven({10, 10, 10}, 0.5, 2.0F, 4), 0.99, 4, 0.005);
}

/// The largest difference, along the middle of a wide slab of this optical depth under light from above alone, from the
/// straight line of diffusion: with an albedo of 1, light would reach 1 above and 0 below the sides by 0.7104 mean free
/// paths [Milne21].
double off_diffusion(double depth, int layers, int width) {
  const double cell = depth / layers;
  const Density slab = uniform({width, width, layers}, 1.0, float(cell));
  const PaddedDensity padded(slab);
  const std::vector<MediumDirection> directions = medium_directions(3);
  const BounceLayout layout{1};
  Panel x(slab.size(), layout.columns());
  for (const auto& [s, weight] : directions) {
    if (s.z() < 0.0) continue;
    const VoxelPath path(slab, padded, s);
    for (std::size_t v = 0; v < x.rows; ++v) {
      const double seen = weight * transmittance(path, padded, slab.place(v));
      for (std::size_t c = 0; c < 3; ++c) x.row(v)[layout.channel(c)] += seen;
    }
  }
  const std::vector<Eigen::Vector3f> albedos(slab.size(), Eigen::Vector3f::Ones());
  EXPECT_TRUE(solve_bounces(Scattering(slab, directions).between_voxels(SIZE_MAX), albedos, layout, x).certified);
  double worst = 0.0;
  for (int k = 0; k < layers; ++k) {
    const double from_top = (layers - k - 0.5) * cell;
    const double line = (depth - from_top + 0.7104) / (depth + 2.0 * 0.7104);
    worst = std::max(worst, std::abs(x.row(slab.index(width / 2, width / 2, k))[0] - line));
  }
  return worst;
}

// The interpolation between voxels spreads light, too: the error falls by the square of the optical depth of a cell.
TEST(Scattering, FallsLinearlyThroughAThickSlab) {
  const double coarse = off_diffusion(5.0, 5, 11);
  const double fine = off_diffusion(5.0, 10, 22);
  EXPECT_LT(fine, 0.012);  // 0.0090 seen
  EXPECT_GT(coarse / fine, 3.0);
}

}  // namespace
}  // namespace sh::prt::test
