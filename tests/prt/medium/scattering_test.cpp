// Light in media against closed answers: Beer and Lambert, a sphere of directions, furnaces, symmetries.
#include "prt/medium/scattering.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <functional>

#include "prt/basis.hpp"
#include "tests/prt/medium/media.hpp"

namespace sh::prt::test {
namespace {

constexpr double kFourPi = 4.0 * std::numbers::pi;

TEST(CellWeights, SumToOneAndAreTheirIntegrals) {
  for (const double t : {0.0, 1e-300, 1e-9, 1e-4, 0.00999, 0.01001, 0.5, 1.0, 20.0, 800.0, 1e300}) {
    const CellWeights w = cell_weights(t);
    EXPECT_NEAR(w.near + w.far + w.through, 1.0, 3e-16) << t;
    EXPECT_GE(w.near, 0.0) << t;
    EXPECT_GE(w.far, 0.0) << t;
  }
  for (const double t : {1e-6, 0.00999, 0.01001, 0.3, 5.0}) {
    double far = 0.0;  // by midpoints
    constexpr int kParts = 20000;
    for (int i = 0; i < kParts; ++i) {
      const double u = t * (i + 0.5) / kParts;
      far += std::exp(-u) * u / kParts;
    }
    EXPECT_NEAR(cell_weights(t).far / far, 1.0, 2e-8) << t;
  }
}

TEST(MediumDirections, IntegrateTheBasisAndHaveTheSymmetriesOfACube) {
  const std::vector<MediumDirection> directions = medium_directions(4);
  ASSERT_EQ(directions.size(), 384U);
  BasisValues sum{};
  for (const auto& [d, weight] : directions) add_basis(kMaxDegree, d.x(), d.y(), d.z(), weight, sum.data());
  EXPECT_NEAR(sum[0] * std::sqrt(kFourPi), 1.0, 1e-14);
  for (std::size_t i = 1; i < coefficient_count(5); ++i) EXPECT_NEAR(sum[i], 0.0, 1e-7) << i;
  for (std::size_t i = coefficient_count(5); i < sum.size(); ++i) EXPECT_NEAR(sum[i], 0.0, 8e-4) << i;  // 4.0e-4 seen
  for (const auto& [d, weight] : directions) {
    for (const Eigen::Vector3d& image : {Eigen::Vector3d(-d.y(), d.x(), d.z()), Eigen::Vector3d(d.y(), d.z(), d.x()),
                                         Eigen::Vector3d(d.x(), d.y(), -d.z())}) {
      EXPECT_TRUE(std::any_of(directions.begin(), directions.end(), [&, w = weight](const MediumDirection& other) {
        return (other.direction - image).norm() < 1e-15 && std::abs(other.weight - w) < 1e-15;
      }));
    }
  }
  EXPECT_EQ(directions_along(383), 3);
  EXPECT_EQ(directions_along(384), 4);
  EXPECT_EQ(directions_along(1), 1);
}

// Along an axis, a row of centers has half a voxel on each side beyond its outermost centers.
TEST(VoxelPath, AgreesWithBeerAndLambertAlongAxes) {
  const double extinction = 0.7;
  const Density slab = uniform({5, 6, 7}, 0.25, float(extinction));
  const PaddedDensity padded(slab);
  const VoxelPath up(slab, padded, Eigen::Vector3d::UnitZ());
  const VoxelPath west(slab, padded, -Eigen::Vector3d::UnitX());
  for (int k = 0; k < 7; ++k) {
    EXPECT_NEAR(transmittance(up, padded, {2, 3, k}), std::exp(-double(0.7F) * 0.25 * (7 - k - 0.5)), 1e-15) << k;
  }
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(transmittance(west, padded, {i, 3, 2}), std::exp(-double(0.7F) * 0.25 * (i + 0.5)), 1e-15) << i;
  }
}

// A slab that is far wider than it is thick: the optical depth goes with 1 / |z|.
TEST(VoxelPath, AgreesWithBeerAndLambertAlongSlopes) {
  const Density slab = uniform({41, 41, 4}, 0.25, 0.7F);
  const PaddedDensity padded(slab);
  for (const Eigen::Vector3d& towards : {Eigen::Vector3d(0.3, 0.2, 0.5), Eigen::Vector3d(-0.9, 0.4, -0.5),
                                         Eigen::Vector3d(1.0, 1.0, 1.0), Eigen::Vector3d(1.0, -1.0, -2.0)}) {
    const Eigen::Vector3d s = towards.normalized();
    const VoxelPath path(slab, padded, s);
    for (int k = 0; k < 4; ++k) {
      const double cells = s.z() > 0.0 ? 4 - k - 0.5 : k + 0.5;
      EXPECT_NEAR(transmittance(path, padded, {20, 20, k}), std::exp(-double(0.7F) * 0.25 * cells / std::abs(s.z())),
                  1e-14)
          << s.transpose();
    }
  }
}

// Against many small steps through the trilinear density of an uneven medium.
TEST(VoxelPath, IntegratesTheTrilinearDensity) {
  const Density density = uneven({4, 5, 3}, 0.5, 3.0F, 11);
  const PaddedDensity padded(density);
  const auto at = [&](const Eigen::Vector3d& p) {  // p in voxels
    double sum = 0.0;
    for (std::size_t v = 0; v < density.size(); ++v) {
      const Counts place = density.place(v);
      auto tent = double(density.values[v]);
      for (int a = 0; a < 3; ++a) tent *= std::max(0.0, 1.0 - std::abs(p[a] - place[std::size_t(a)]));
      sum += tent;
    }
    return sum;
  };
  const Eigen::Vector3d s = Eigen::Vector3d(0.6, -0.3, 0.2).normalized();
  const VoxelPath path(density, padded, s);
  double depth = 0.0;
  constexpr int kSteps = 20000;
  constexpr double kReach = 6.0;
  for (int i = 0; i < kSteps; ++i) {
    depth += at(Eigen::Vector3d(1, 3, 1) + s / 0.5 * (kReach * (i + 0.5) / kSteps)) * kReach / kSteps;
  }
  EXPECT_NEAR(-std::log(transmittance(path, padded, {1, 3, 1})), depth, 1e-6 * depth);
}

TEST(Scattering, OfAnEmptyMediumIsTheLightItself) {
  const Density empty = uniform({3, 2, 4}, 1.0, 0.0F);
  const Scattering scattering(empty, medium_directions(4));
  const std::vector<float> direct = scattering.direct(4);
  for (std::size_t v = 0; v < empty.size(); ++v) {
    EXPECT_NEAR(direct[v * 25], 1.0 / std::sqrt(kFourPi), 1e-7);
    for (std::size_t i = 1; i < 25; ++i) EXPECT_NEAR(direct[v * 25 + i], 0.0, 1e-7);
  }
  EXPECT_TRUE(scattering.between_voxels(SIZE_MAX).row(5).empty());
}

// A single voxel is a tent: its center sees the closed integral of exp(-depth) in every direction.
TEST(Scattering, OfASingleVoxelHasASymmetricVector) {
  const Density voxel = uniform({1, 1, 1}, 2.0, 0.5F);
  const Scattering scattering(voxel, medium_directions(4));
  const std::vector<float> direct = scattering.direct(3);
  double mean = 0.0;  // over 8 octants alike: depth = 0.5 * 2 * integral of (1-xt)(1-yt)(1-zt), Simpson's rule is exact
  for (const auto& [s, weight] : medium_directions(10)) {
    const double reach = 1.0 / s.cwiseAbs().maxCoeff();
    const auto tent = [&, d = s](double t) { return ((1.0 - t * d.array().abs()).prod()); };
    const double depth = reach / 6.0 * (tent(0.0) + 4.0 * tent(0.5 * reach) + tent(reach));
    mean += weight * std::exp(-depth);
  }
  EXPECT_NEAR(double(direct[0]) * std::sqrt(kFourPi), mean, 1e-6);
  for (std::size_t i = 1; i < 16; ++i) EXPECT_NEAR(direct[i], 0.0, 1e-7);
  const FormFactors factors = scattering.between_voxels(SIZE_MAX);
  ASSERT_EQ(factors.row(0).size(), 1U);  // its own light alone
  EXPECT_NEAR(factors.row(0)[0].weight, 1.0 - mean, 1e-6);
}

TEST(Scattering, LosesNothingWithAnAlbedoOfOne) {
  for (const float density : {1e-6F, 0.01F, 1.0F, 30.0F, 1e4F}) {
    const Scattered s = scattered(uneven({6, 5, 7}, 0.5, density, 3), 1.0, 2);
    ASSERT_TRUE(s.report.certified) << density;
    for (const double x : s.light) {
      EXPECT_NEAR(x, 1.0, std::sqrt(kFourPi) * s.report.bound + 1e-6) << density;
    }
  }
}

TEST(Scattering, RowsAndTheLightFromOutsideSumToOne) {
  const Density density = uneven({5, 5, 5}, 1.0, 2.0F, 8);
  const Scattering scattering(density, medium_directions(3));
  const std::vector<float> direct = scattering.direct(0);
  const FormFactors factors = scattering.between_voxels(SIZE_MAX);
  for (std::size_t v = 0; v < density.size(); ++v) {
    double sum = double(direct[v]) * std::sqrt(kFourPi);
    for (const FormFactor& factor : factors.row(v)) sum += factor.weight;
    EXPECT_NEAR(sum, 1.0, 1e-6) << v;
  }
}

TEST(Scattering, WithALittleAlbedoIsTheDirectLight) {
  const Density density = uneven({4, 4, 4}, 1.0, 2.0F, 8);
  const std::vector<float> direct = Scattering(density, medium_directions(3)).direct(0);
  const Scattered little = scattered(density, 1e-6, 3);
  const Scattered none = scattered(density, 0.0, 3);
  for (std::size_t v = 0; v < density.size(); ++v) {
    EXPECT_NEAR(little.light[v] / 1e-6, double(direct[v]) * std::sqrt(kFourPi), 2e-6);
    EXPECT_EQ(none.light[v], 0.0);
  }
}

/// The density with its voxel at place(x, y, z) moved to `to(place)`.
template <class To>
Density moved(const Density& density, const Counts& counts, const To& to) {
  Density out{.counts = counts, .spacing = density.spacing};
  out.values.resize(out.size());
  for (std::size_t v = 0; v < density.size(); ++v) {
    const Counts place = to(density.place(v));
    out.values[out.index(place[0], place[1], place[2])] = density.values[v];
  }
  return out;
}

constexpr int kDegree = 4;
constexpr std::size_t kCount = 25;

// A turned grid has turned vectors: x -> y -> -x about z, and x -> y -> z -> x about the diagonal.
TEST(Scattering, TurnsWithItsGrid) {
  const Density density = uneven({4, 3, 5}, 0.5, 2.0F, 5);
  struct Case {
    Eigen::Matrix3d turn;
    Counts counts;
    std::function<Counts(const Counts&)> to;
  };
  Eigen::Matrix3d about_z;
  about_z << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Eigen::Matrix3d about_diagonal;
  about_diagonal << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Case cases[] = {{about_z,
                         {3, 4, 5},
                         [](const Counts& p) {
                           return Counts{2 - p[1], p[0], p[2]};
                         }},
                        {about_diagonal, {5, 4, 3}, [](const Counts& p) {
                           return Counts{p[2], p[0], p[1]};
                         }}};
  const std::vector<float> direct = Scattering(density, medium_directions(3)).direct(kDegree);
  const Scattered s = scattered(density, 0.9, 3);
  for (const Case& c : cases) {
    const Density turned = moved(density, c.counts, c.to);
    const std::vector<float> turned_direct = Scattering(turned, medium_directions(3)).direct(kDegree);
    const Scattered turned_s = scattered(turned, 0.9, 3);
    for (std::size_t v = 0; v < density.size(); ++v) {
      const Counts place = c.to(density.place(v));
      const std::size_t w = turned.index(place[0], place[1], place[2]);
      EXPECT_NEAR(turned_s.light[w], s.light[v], 1e-12);
      double expected[kCount];
      const Eigen::ArrayXd row = as_array(&direct[v * kCount], kCount).cast<double>();
      rotate_function(kDegree, c.turn, row.data(), expected);
      for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(turned_direct[w * kCount + i], expected[i], 1e-7);
    }
  }
}

// A mirror x -> -x changes the signs of the functions that are odd in x: m < 0 even, and m > 0 odd.
TEST(Scattering, IsMirroredWithItsGrid) {
  const Density density = uneven({4, 3, 5}, 0.5, 2.0F, 6);
  const auto to = [](const Counts& p) { return Counts{3 - p[0], p[1], p[2]}; };
  const Density mirrored = moved(density, density.counts, to);
  const std::vector<float> direct = Scattering(density, medium_directions(3)).direct(kDegree);
  const std::vector<float> mirrored_direct = Scattering(mirrored, medium_directions(3)).direct(kDegree);
  for (std::size_t v = 0; v < density.size(); ++v) {
    const Counts place = to(density.place(v));
    const std::size_t w = mirrored.index(place[0], place[1], place[2]);
    for (int l = 0; l <= kDegree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const std::size_t i = coefficient_index(l, m);
        const bool is_odd = m < 0 ? m % 2 == 0 : m % 2 != 0;
        EXPECT_NEAR(mirrored_direct[w * kCount + i], (is_odd ? -1.0F : 1.0F) * direct[v * kCount + i], 1e-7);
      }
    }
  }
}

TEST(Scattering, HasTheSameBitsForAnyNumberOfThreadsAndAnyMemory) {
  const Density density = uneven({7, 6, 5}, 0.5, 3.0F, 9);
  const auto run = [&](std::size_t threads, std::size_t bytes) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Scattering scattering(density, medium_directions(2));
    std::vector<double> numbers;
    for (const float x : scattering.direct(2)) numbers.push_back(double(x));
    Panel x(density.size(), 1);
    Panel y(density.size(), 1);
    for (std::size_t v = 0; v < x.rows; ++v) x.row(v)[0] = 1.0 / double(v + 1);
    scattering.between_voxels(bytes).apply(x, y);
    numbers.insert(numbers.end(), y.values.begin(), y.values.end());
    return numbers;
  };
  const std::vector<double> alone = run(1, SIZE_MAX);
  EXPECT_EQ(alone, run(2, SIZE_MAX));
  EXPECT_EQ(alone, run(2, 10000));
}

}  // namespace
}  // namespace sh::prt::test
