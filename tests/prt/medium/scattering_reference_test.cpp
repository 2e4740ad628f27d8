// Multiple scattering against answers of other methods: random walks, and diffusion between the sides of a thick slab.
#include <gtest/gtest.h>

#include "prt/basis.hpp"
#include "prt/medium/anisotropic.hpp"
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

/// Random walks by the method of fictitious scattering [Woodcock65] with the phase function of [HenyeyGreenstein41]:
/// independent of cells, directions, bands and solver.
class Walks {
 public:
  Walks(const Density& density, std::uint64_t seed, double g = 0.0) : density_(density), random_(seed), g_(g) {
    for (const float value : density.values) most_ = std::max(most_, double(value));
  }

  /// The light that the medium scatters at a voxel's center against a direction: mean, and its standard error.
  std::pair<double, double> light(std::size_t voxel, double albedo, int count,
                                  const Eigen::Vector3d& seen = Eigen::Vector3d::UnitZ()) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
      const double light = albedo * walk(density_.center(voxel), scattered(seen), albedo);
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

  // A direction at an angle to the unit vector `s` by the phase function, whose inverse distribution is closed.
  Eigen::Vector3d scattered(const Eigen::Vector3d& s) {
    const double u = random_.next();
    const double part = (1.0 - g_ * g_) / (1.0 + g_ * u);
    const double z = g_ == 0.0 ? u : (1.0 + g_ * g_ - part * part) / (2.0 * g_);
    const double azimuth = std::numbers::pi * random_.next();
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const Eigen::Vector3d side = s.unitOrthogonal();
    return (r * std::cos(azimuth) * side + r * std::sin(azimuth) * s.cross(side) + z * s).normalized();
  }

  double walk(Eigen::Vector3d at, Eigen::Vector3d s, double albedo) {
    const Eigen::AlignedBox3d box = density_.support();
    double weight = 1.0;
    while (true) {
      do {
        at -= std::log(1.0 - uniform()) / most_ * s;
        if (!box.contains(at)) return weight * radiance_of(s);
      } while (uniform() * most_ >= density_at(at));
      weight *= albedo;
      s = scattered(s);
    }
  }

  const Density& density_;
  numeric::Random random_;
  double g_;
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

/// A uniform medium with a preferred direction.
AnisotropicLight anisotropic(const Density& density, double albedo, double g, int degree, int along) {
  Medium medium;
  medium.albedo.setConstant(float(albedo));
  medium.anisotropy = g;
  return scatter_anisotropically(Scattering(density, medium_directions(along)), medium, degree, {}, "test");
}

// g^5 is 0.01: the bands up to 4 hold the phase function. Voxels of an optical depth of 0.3 err by 0.002.
TEST(Anisotropic, AgreesWithRandomWalks) {
  constexpr int kDegree = 4;
  constexpr std::size_t kCount = 25;
  const Density density = uniform({7, 6, 8}, 0.5, 0.6F);
  for (const double g : {0.4, -0.3}) {
    const AnisotropicLight light = anisotropic(density, double(0.9F), g, kDegree, 4);
    Walks walks(density, 23, g);
    for (const Eigen::Vector3d& seen : {Eigen::Vector3d(1, 2, 2), Eigen::Vector3d(-2, 1, -2)}) {
      const Eigen::Vector3d s = seen.normalized();
      BasisValues basis{};
      evaluate_basis(kDegree, s.x(), s.y(), s.z(), basis.data());
      for (const std::size_t voxel : {31U, 168U, 290U}) {
        double sum = 0.0;
        for (std::size_t r = 0; r < kCount; ++r) {
          for (std::size_t i = 0; i < 4; ++i) {
            sum += basis[r] * double(light.rows[(3 * voxel * kCount + r) * kCount + i]) * coefficients()[i];
          }
        }
        const auto [mean, error] = walks.light(voxel, double(0.9F), 100000, s);
        EXPECT_NEAR(sum, mean, 4.0 * error + 0.002 * mean) << voxel;
      }
    }
  }
}

// Without a preferred direction it is the isotropic medium, by another solver.
TEST(Anisotropic, WithoutADirectionIsIsotropic) {
  const Density density = uneven({5, 4, 6}, 0.5, 2.0F, 5);
  const std::vector<double> expected = solved(density, double(0.9F), 3);
  const AnisotropicLight light = anisotropic(density, double(0.9F), 0.0, 1, 3);
  for (std::size_t v = 0; v < density.size(); ++v) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += double(light.rows[3 * v * 16 + i]) * coefficients()[i];
    EXPECT_NEAR(sum / std::sqrt(4.0 * std::numbers::pi), expected[v], 2e-4) << v;
    for (std::size_t i = 4; i < 16; ++i) EXPECT_EQ(light.rows[3 * v * 16 + i], 0.0F);
  }
}

TEST(Anisotropic, LosesNothingWithAnAlbedoOfOne) {
  const Density density = uneven({5, 4, 6}, 0.5, 2.0F, 5);
  for (const double g : {0.7, -0.5}) {
    const AnisotropicLight light = anisotropic(density, 1.0, g, 3, 4);
    for (std::size_t v = 0; v < density.size(); ++v) {
      EXPECT_NEAR(light.rows[3 * v * 256], 1.0F, 2e-4F) << v;
      for (std::size_t r = 1; r < 16; ++r) EXPECT_NEAR(light.rows[(3 * v * 16 + r) * 16], 0.0F, 1e-4F) << r;
    }
  }
}

TEST(Anisotropic, RefusesWhatHardlyShrinks) {
  try {
    anisotropic(uniform({6, 6, 6}, 1.0, 30.0F), 1.0, 0.5, 1, 2);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("test: an order of scattering is 0.9")) << error.what();
  }
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
