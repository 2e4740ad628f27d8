// The light around objects: what receivers take from volumes, against closed forms, direct rays and the receivers' own bakes.
#include "prt/runtime/neighborhood.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "generated/cpp/cap.hpp"
#include "generated/cpp/zonal.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/bake/bake_volume.hpp"
#include "prt/basis.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/transfer/visibility.hpp"
#include "prt/zonal.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

Mesh moved(Mesh mesh, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& position : mesh.positions) position += by;
  return mesh;
}

Mesh ball(float radius, const Eigen::Vector3f& center = Eigen::Vector3f::Zero()) {
  return moved(primitive_mesh("sphere", 64, Eigen::Affine3f(Eigen::Scaling(2.0F * radius))), center);
}

VolumeOptions in_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::array<std::uint32_t, 3> counts,
                     int degree = 2, int result_degree = 4, int directions = 1024) {
  VolumeOptions options;
  options.box.emplace(low, high);
  options.counts = counts;
  options.degree = degree;
  options.result_degree = result_degree;
  options.directions = directions;
  return options;
}

Transfer space_around(const Mesh& mesh, const VolumeOptions& options) {
  return bake_volume(scene_of(mesh, &kShadowed, 64, 1), options, {});
}

/// The exit radiance over albedo of one diffuse receiver.
Eigen::Vector3d diffuse_at(const Transfer& volume, const LightCoefficients& light, const Eigen::Vector3f& position,
                           const Eigen::Vector3f& normal) {
  const TransferredRadiance reaching(volume, light);
  Eigen::Vector3f radiance;
  shade_diffuse(*volume.grid, reaching, {&position, 1}, {&normal, 1}, {&radiance, 1});
  return radiance.cast<double>();
}

/// The volume of random visibility, whose numbers do not matter.
Transfer random_volume(int degree, int result_degree) {
  Transfer volume = Transfer::of(kNeighborhood, degree);
  volume.shape.result_degree = result_degree;
  volume.grid = PointGrid{{Eigen::Vector3d(-1.0, -1.0, -1.0), Eigen::Vector3d(1.0, 1.0, 1.0)}, {3, 4, 5}};
  volume.coefficients = random_values(volume.receivers() * volume.shape.length(), 5);
  return volume;
}

/// The integral of V times light times every function of the result, by a rule that is exact.
std::vector<double> by_quadrature(const TransferShape& shape, const float* visibility, const LightCoefficients& light,
                                  std::size_t channel) {
  std::vector<double> sums(coefficient_count(shape.result_degree), 0.0);
  const int rings = 24;
  const int angles = 32;
  std::vector<double> basis(coefficient_count(kMaxDegree));
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < angles; ++j) {  // Gauss-Chebyshev of the second kind in z needs no table: weights sum to 4 pi
      const double angle = kPi * (i + 1) / (rings + 1);
      const double z = std::cos(angle);
      const double azimuth = 2.0 * kPi * (j + 0.5) / angles;
      double weight = 0.0;
      for (int k = 1; k <= (rings + 1) / 2; ++k) weight += std::sin((2 * k - 1) * angle) / (2 * k - 1);
      weight *= 4.0 * std::sin(angle) / (rings + 1) * 2.0 * kPi / angles;
      evaluate_basis(kMaxDegree, std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), z,
                     basis.data());
      double v = 0.0;
      double l = 0.0;
      for (std::size_t b = 0; b < shape.columns(); ++b) v += static_cast<double>(visibility[b]) * basis[b];
      for (std::size_t b = 0; b < coefficient_count(std::min(light.degree, shape.degree)); ++b)
        l += light.at(channel, b) * basis[b];
      for (std::size_t b = 0; b < sums.size(); ++b) sums[b] += weight * v * l * basis[b];
    }
  }
  return sums;
}

/// As it is read from a file.
Transfer stored(Transfer volume, Element element) {
  volume.shape.storage.element = element;
  volume.stored = encode(volume.coefficients, volume.shape);
  volume.coefficients.clear();
  return volume;
}

TEST(TransferredRadiance, AtPointsIsTheSameOfVisibilityThatIsStored) {
  for (const auto& [degree, result] : {std::pair{2, 4}, {4, 4}, {4, 2}, {2, 0}}) {
    for (const Element element : {Element::kHalf, Element::kByte}) {
      const Transfer kept = stored(random_volume(degree, result), element);
      Transfer widened = kept;
      widened.coefficients = kept.rows().all();
      widened.stored = {};
      for (const int light_degree : {degree, degree + 2}) {
        const LightCoefficients light = random_light(light_degree, 3);
        const TransferredRadiance of_kept(kept, light);
        const TransferredRadiance of_widened(widened, light);
        const GridCell cell(*kept.grid, {0.3, -0.1, 0.7});
        std::array<float, 3 * coefficient_count(6)> a{};
        std::array<float, 3 * coefficient_count(6)> b{};
        of_kept.at(cell, a.data());
        of_widened.at(cell, b.data());
        EXPECT_EQ(a, b) << degree << " " << result << " " << light_degree;
      }
      std::vector<float> direct(kept.shape.length());
      std::vector<float> room(kept.shape.length());
      const GridCell cell(*kept.grid, {-0.9, 0.2, 0.4});
      cell.mix(kept.rows(), direct.data());
      cell.mix(widened.coefficients.data(), room.size(), room.data());
      EXPECT_EQ(direct, room);
    }
  }
}

TEST(TransferredRadiance, AtPointsIsTheProjectedProductForAllDegrees) {
  for (const auto& [degree, result] : {std::pair{0, 0}, {0, 3}, {2, 4}, {4, 2}, {1, 1}, {4, 4}, {2, 0}}) {
    const Transfer volume = random_volume(degree, result);
    const LightCoefficients light = random_light(degree, 3);
    const TransferredRadiance reaching(volume, light);
    ASSERT_EQ(reaching.degree(), std::max(degree, result));
    const std::size_t bands = coefficient_count(reaching.degree());
    for (const std::size_t p : {std::size_t{0}, std::size_t{17}, volume.receivers() - 1}) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<double> expected = by_quadrature(volume.shape, volume.row(p), light, c);
        for (std::size_t i = 0; i < expected.size(); ++i) {
          EXPECT_NEAR(reaching.at(p)[c * bands + i], expected[i], 2e-5) << degree << " " << result << " " << i;
        }
      }
    }
  }
}

// More rows than are prepared at a time, in memory and stored; nothing is written behind the last one.
TEST(TransferLight, OfManyRowsIsThatOfEveryRowAlone) {
  constexpr std::size_t kRows = 777;
  constexpr float kBehind = 12.5F;
  for (const auto& [degree, result] : {std::pair{4, 2}, {2, 4}, {3, 3}, {0, 1}}) {
    Transfer volume = random_volume(degree, result);
    const TransferShape shape = volume.shape;
    const std::vector<float> all = random_values(kRows * shape.columns(), 9);
    const std::vector<float> light = random_values(3 * coefficient_count(degree), 10);
    const std::size_t length = 3 * coefficient_count(result);
    std::vector<float> out((kRows + 1) * length, kBehind);
    transfer_light(shape, Rows(all, {}, shape), light, out.data());
    for (std::size_t row = 0; row < kRows; ++row) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(row * shape.columns());
      const std::vector<float> one(first, first + static_cast<std::ptrdiff_t>(shape.columns()));
      std::vector<float> expected(length);
      transfer_light(shape, Rows(one, {}, shape), light, expected.data());
      for (std::size_t i = 0; i < length; ++i) {
        ASSERT_NEAR(out[row * length + i], expected[i], 1e-5F) << degree << " " << result << " " << row << " " << i;
      }
    }
    for (std::size_t i = kRows * length; i < out.size(); ++i) EXPECT_EQ(out[i], kBehind);
  }
}

TEST(TransferredRadiance, GivesAPointTheWholeLightOfAnyDegreeWhereTheObjectBlocksNothing) {
  Transfer volume = random_volume(2, 4);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    std::fill_n(volume.row(p), volume.shape.length(), 0.0F);
    volume.row(p)[0] = static_cast<float>(std::sqrt(4.0 * kPi));
  }
  for (const int degree : {0, 1, 2, 3, 4, 7, 10}) {
    const LightCoefficients light = random_light(degree, 8);
    const TransferredRadiance reaching(volume, light);
    const std::size_t bands = coefficient_count(reaching.degree());
    std::vector<float> between(3 * bands);
    reaching.at(GridCell(*volume.grid, Eigen::Vector3d(0.3, -0.77, 0.1)), between.data());
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < bands; ++i) {
        const double expected = i < light.bands_squared() ? light.at(c, i) : 0.0;
        EXPECT_NEAR(between[c * bands + i], expected, 3e-6) << degree << " " << i;
      }
    }
  }
}

TEST(TransferredRadiance, RefusesLightThatExceedsSinglePrecisionAroundAnObject) {
  const Transfer volume = random_volume(2, 4);
  EXPECT_NO_THROW(TransferredRadiance(volume, constant_light(4, 1e35)));
  for (const double strong : {1e37, 1e39, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(
        message_of([&] { TransferredRadiance(volume, constant_light(4, strong)); }).find("exceeds single precision"),
        std::string::npos);
  }
}

TEST(GridCell, IsExactAtItsPointsAndForTrilinearFunctionsAndClampsOutside) {
  const PointGrid grid{{Eigen::Vector3d(-1.0, 0.0, 2.0), Eigen::Vector3d(1.0, 1.5, 3.0)}, {5, 4, 2}};
  const auto f = [](const Eigen::Vector3d& p) { return (1.0 + p.x()) * (2.0 - p.y()) * (0.5 + p.z()); };
  std::vector<float> rows;
  for (std::size_t p = 0; p < grid.points(); ++p) rows.push_back(static_cast<float>(f(grid.point(p))));
  float value = 0.0F;
  for (std::size_t p = 0; p < grid.points(); ++p) {
    GridCell(grid, grid.point(p)).mix(rows.data(), 1, &value);
    EXPECT_EQ(value, rows[p]) << p;
  }
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.11, 0.7, 2.2), Eigen::Vector3d(-0.9, 1.45, 2.99)}) {
    GridCell(grid, p).mix(rows.data(), 1, &value);
    EXPECT_NEAR(value, f(p), 1e-5);
  }
  GridCell(grid, Eigen::Vector3d(9.0, -9.0, 2.5)).mix(rows.data(), 1, &value);
  EXPECT_NEAR(value, f({1.0, 0.0, 2.5}), 1e-5);
}

// Weights below 0 or corners elsewhere would give trilinear functions all the same.
TEST(GridCell, HasTheCornersAroundItsPointAndWeightsThatSumToOne) {
  const PointGrid grid{{Eigen::Vector3d(-1.0, 0.0, 2.0), Eigen::Vector3d(1.0, 1.5, 3.0)}, {5, 4, 2}};
  std::vector<Eigen::Vector3d> points{{0.11, 0.7, 2.2}, {-0.9, 1.45, 2.99}, {9.0, -9.0, 2.5}, {-9.0, 9.0, 9.0}};
  for (std::size_t p = 0; p < grid.points(); ++p) points.push_back(grid.point(p));
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d inside = p.cwiseMax(grid.box.min()).cwiseMin(grid.box.max());
    const GridCell cell(grid, p);
    float sum = 0.0F;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      ASSERT_LT(cell.corners[corner], grid.points()) << p.transpose();
      const Eigen::Vector3d steps = (grid.point(cell.corners[corner]) - inside).cwiseQuotient(grid.spacing());
      EXPECT_LE(steps.cwiseAbs().maxCoeff(), 1.0 + 1e-12) << p.transpose();
      EXPECT_GE(cell.weights[corner], 0.0F) << p.transpose();
      sum += cell.weights[corner];
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F) << p.transpose();
  }
}

// Under a uniform sky a sphere blocks the cap of sin(angle) = r/d about the normal of a receiver right below: 1 - (r/d)^2
// is left. Degree 4 holds this cap times the cosine within 0.01.
TEST(Neighborhood, ShadesAPlateUnderASphereAsTheCapSays) {
  const Transfer volume = space_around(
      ball(0.5F), in_box(Eigen::Vector3d(-1.0, -1.0, -2.0), Eigen::Vector3d(1.0, 1.0, 1.0), {9, 9, 25}, 2, 4, 4096));
  for (const float depth : {-0.75F, -1.0F, -1.5F, -1.9F}) {
    std::array<double, 5> zonal{};
    const double sine = 0.5 / static_cast<double>(-depth);
    sh::cap<4>(1.0 - std::sqrt(1.0 - sine * sine), zonal.data());
    double expected = 1.0;  // with the bands up to 4 of cap and cosine
    for (int l = 0; l <= 4; ++l) {
      const double factor = numeric::clamped_cosine_factor<double>(l) / kPi;
      expected -= factor * zonal[static_cast<std::size_t>(l)] * std::sqrt((2.0 * l + 1.0) / (4.0 * kPi));
    }
    const Eigen::Vector3d seen = diffuse_at(volume, constant_light(2), {0.0F, 0.0F, depth}, Eigen::Vector3f::UnitZ());
    EXPECT_NEAR(seen.x(), expected, 6e-3) << depth;
    EXPECT_NEAR(seen.x(), 1.0 - sine * sine, 0.02) << depth;
    EXPECT_EQ(seen.x(), seen.y());
  }
}

/// A slab of thickness 0.2 whose upper side is z = 0, and a ball above it.
Mesh slab_and_ball() {
  Mesh mesh = moved(primitive_mesh("box", 24, Eigen::Affine3f(Eigen::Scaling(4.0F, 4.0F, 0.2F))), {0.0F, 0.0F, -0.1F});
  append(mesh, ball(0.4F, {0.0F, 0.0F, 1.0F}));
  return mesh;
}

// A receiver on the slab, between points of a layer of the grid that just touches it.
Transfer touching(std::uint32_t count, int directions) {
  constexpr double kAbove = 1e-3;
  return space_around(slab_and_ball(),
                      in_box(Eigen::Vector3d(-2.0, -2.0, kAbove - 0.4), Eigen::Vector3d(2.0, 2.0, kAbove + 1.6),
                             {count, count, 6}, 2, 4, directions));
}

const Eigen::Vector3f kOnSlab(0.37F, -0.21F, 1e-3F);

TEST(Neighborhood, OfAReceiverThatTouchesASideIsItsOwnTransfer) {
  Mesh mesh = slab_and_ball();
  const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
  Mesh speck = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(kOnSlab) * Eigen::Scaling(1e-3F)));
  append(mesh, speck);
  const Transfer own = baked(mesh, &kShadowed, 8192, 2);
  const Transfer volume = touching(41, 8192);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const LightCoefficients light = seed == 0 ? constant_light(2) : random_light(2, seed);
    const Eigen::Vector3d expected = relight_vertex(own, vertex, light, Eigen::Vector3f::Ones()).cast<double>();
    const Eigen::Vector3d seen = diffuse_at(volume, light, kOnSlab, Eigen::Vector3f::UnitZ());
    EXPECT_LT((seen - expected).norm(), 0.02) << seed << ": the bands of the cosine above 4";
  }
}

/// The numbers at a point itself, which is in the middle of a grid.
Eigen::Vector3d diffuse_on_point(const Mesh& mesh, const Eigen::Vector3f& position, const LightCoefficients& light,
                                 int directions) {
  const Eigen::Vector3d p = position.cast<double>();
  const Eigen::Vector3d far = Eigen::Vector3d::Constant(4.0);
  return diffuse_at(space_around(mesh, in_box(p - far, p + far, {3, 3, 3}, 2, 4, directions)), light, position,
                    Eigen::Vector3f::UnitZ());
}

TEST(Neighborhood, ErrsBetweenPointsByTheSquareOfTheirDistance) {
  constexpr int kDirections = 16384;
  const LightCoefficients light = random_light(2, 4);
  std::vector<Eigen::Vector3f> receivers;
  std::vector<Eigen::Vector3d> exact;
  for (int i = 0; i < 12; ++i) {
    const auto part = [i](double step) { return static_cast<float>(2.4 * std::fmod((i + 0.5) * step, 1.0) - 1.2); };
    receivers.emplace_back(part(0.618), part(0.377), kOnSlab.z());
    exact.push_back(diffuse_on_point(slab_and_ball(), receivers.back(), light, kDirections));
  }
  std::vector<double> errors;
  for (const std::uint32_t count : {6U, 11U, 21U}) {
    const Transfer volume = touching(count, kDirections);
    double squares = 0.0;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      squares += (diffuse_at(volume, light, receivers[i], Eigen::Vector3f::UnitZ()) - exact[i]).squaredNorm();
    }
    errors.push_back(std::sqrt(squares / static_cast<double>(receivers.size())));
  }
  const double slope = std::log2(errors[0] / errors[2]) / 2.0;
  RecordProperty("slope", std::to_string(slope));
  EXPECT_NEAR(slope, 2.0, 0.4) << errors[0] << " " << errors[1] << " " << errors[2];
}

/// A stage of a small square that gathers light at its vertices, and objects with volumes.
struct AroundStage {
  explicit AroundStage(std::vector<std::shared_ptr<const Transfer>> volumes, int degree = 4) {
    stage.objects.push_back(
        stage_of(baked(primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(0.2F))), &kUnshadowed, 64, degree))
            .objects.front());
    stage.objects.front().per_vertex = true;
    for (auto& volume : volumes) {
      StageObject& object =
          stage.objects.emplace_back(stage_of(baked(ball(0.3F), &kUnshadowed, 64, degree)).objects.front());
      object.volume = std::move(volume);
      object.proxy = {Eigen::Vector3d::Zero(), 0.3};
    }
  }
  Stage stage;
};

std::shared_ptr<const Transfer> volume_of_stairs() {
  static const auto kVolume = std::make_shared<const Transfer>(
      space_around(primitive_mesh("stairs"),
                   in_box(Eigen::Vector3d::Constant(-1.5), Eigen::Vector3d::Constant(1.5), {9, 9, 9}, 2, 4, 512)));
  return kVolume;
}

TEST(Neighborhood, TurnsWithObjectAndLight) {
  const AroundStage around({volume_of_stairs()});
  const LightCoefficients light = random_light(4, 9);
  const Eigen::Vector3d offset(0.4, 1.1, -0.3);
  const Eigen::Vector3d from(0.6, 0.7, -0.8);  // in the axes of the object
  const auto at = [&](const Eigen::Matrix3d& turn, const Eigen::Vector3d& moved_by) {
    const std::vector<Pose> poses = {Pose(), {turn, moved_by}};
    const Neighborhoods neighborhoods(around.stage, poses, turned(light, turn));
    return neighborhoods.at(0, turn * from + moved_by);
  };
  const auto still = at(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  ASSERT_TRUE(still);
  for (const double degrees : {1e-4, 37.0, 90.0, 180.0}) {
    const Eigen::Matrix3d turn = rotation_about(kSlanted, degrees);
    const auto again = at(turn, offset);
    ASSERT_TRUE(again);
    EXPECT_LT(largest_difference(*again, turned(*still, turn)), 1e-5) << degrees;
  }
}

TEST(Neighborhood, GivesAReceiverTheLightInItsOwnAxesAndLeavesItsOwnVolumeOut) {
  const AroundStage around({volume_of_stairs()});
  const LightCoefficients light = random_light(4, 9);
  const Eigen::Vector3d point(0.6, 0.7, -0.8);
  const Neighborhoods straight(around.stage, {Pose(), Pose()}, light);
  const Pose tilted{rotation_about(kSlanted, 50.0), Eigen::Vector3d(9.0, 9.0, 9.0)};
  const Neighborhoods turned_receiver(around.stage, {tilted, Pose()}, light);
  EXPECT_LT(
      largest_difference(*turned_receiver.at(0, point), turned(*straight.at(0, point), tilted.rotation.transpose())),
      1e-5);
  EXPECT_FALSE(straight.at(1, point)) << "its own";
  EXPECT_FALSE(straight.at(0, Eigen::Vector3d(1.6, 0.0, 0.0))) << "outside of the box";
  EXPECT_GT(largest_difference(*straight.at(0, point), light), 0.01);
}

/// The space around an object that blocks nothing.
std::shared_ptr<const Transfer> open_space(int degree, int result_degree) {
  Transfer open = random_volume(degree, result_degree);
  std::fill(open.coefficients.begin(), open.coefficients.end(), 0.0F);
  for (std::size_t p = 0; p < open.receivers(); ++p) open.row(p)[0] = static_cast<float>(std::sqrt(4.0 * kPi));
  return std::make_shared<const Transfer>(std::move(open));
}

TEST(Neighborhood, OfObjectsThatBlockNothingIsTheWholeLightInTheAxesOfTheReceiver) {
  const auto coarse = open_space(1, 2);
  const auto fine = open_space(3, 4);
  const Pose receiver{rotation_about(kSlanted, 50.0), Eigen::Vector3d(9.0, 9.0, 9.0)};
  const Pose moved{rotation_about(kSlanted, -70.0), Eigen::Vector3d(0.1, 0.2, -0.1)};
  using Volumes = std::vector<std::shared_ptr<const Transfer>>;
  for (const Volumes& volumes : {Volumes{coarse}, Volumes{fine}, Volumes{fine, coarse}, Volumes{coarse, fine}}) {
    const AroundStage around(volumes);
    const std::vector<Pose> poses =
        volumes.size() == 1 ? std::vector<Pose>{receiver, moved} : std::vector<Pose>{receiver, moved, Pose()};
    for (const int degree : {0, 2, 4, 7}) {
      const LightCoefficients light = random_light(degree, 9);
      const auto seen = Neighborhoods(around.stage, poses, light).at(0, Eigen::Vector3d(0.2, 0.1, -0.3));
      ASSERT_TRUE(seen);
      EXPECT_LT(largest_difference(*seen, turned(light, receiver.rotation.transpose())), 1e-5)
          << volumes.size() << " of degree " << volumes[0]->shape.degree << ", light of degree " << degree;
    }
  }
}

// One object after the other; the product has to be that of both at once.
TEST(Neighborhood, OfSeveralObjectsIsTheProductOfTheirVisibilities) {
  const Eigen::Vector3f left(-0.7F, 0.0F, 0.6F);
  const Eigen::Vector3f right(0.75F, 0.1F, 0.5F);
  const VolumeOptions options =
      in_box(Eigen::Vector3d::Constant(-1.5), Eigen::Vector3d::Constant(1.5), {3, 3, 3}, 2, 4, 8192);
  const auto one = std::make_shared<const Transfer>(space_around(ball(0.4F, left), options));
  const auto other = std::make_shared<const Transfer>(space_around(ball(0.4F, right), options));
  Mesh both = ball(0.4F, left);
  append(both, ball(0.4F, right));
  const auto at_once = std::make_shared<const Transfer>(space_around(both, options));
  LightCoefficients light = constant_light(2);
  const auto light_with = [&](std::vector<std::shared_ptr<const Transfer>> volumes) {
    const AroundStage around(std::move(volumes), 2);
    return Neighborhoods(around.stage, std::vector<Pose>(around.stage.objects.size()), light)
        .at(0, Eigen::Vector3d::Zero())
        .value();
  };
  const LightCoefficients expected = light_with({at_once});
  const LightCoefficients product = light_with({one, other});
  const double error = largest_difference(product, expected) / light.at(0, 0);
  RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 0.002) << "projection of the product";
  EXPECT_GT(largest_difference(light_with({one}), expected) / light.at(0, 0), 0.03);
  EXPECT_LT(largest_difference(light_with({one, open_space(2, 4)}), light_with({one})), 1e-5);
  // A light that is bright on the side of one of them: each band meets the product.
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 3) = 2.0 * static_cast<double>(c);
  const LightCoefficients uneven = light_with({at_once});
  const double uneven_error = largest_difference(light_with({one, other}), uneven) / light.at(0, 0);
  RecordProperty("uneven_error", std::to_string(uneven_error));
  EXPECT_LT(uneven_error, 0.005);
  EXPECT_LT(largest_difference(light_with({one, other}), light_with({other, one})), 1e-5);
}

/// Exit radiance over albedo at a point, by rays to the band-limited light.
Eigen::Vector3d by_rays(const Tracer& tracer, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                        const LightCoefficients& light) {
  const std::vector<Eigen::Vector3f> directions = make_directions(Sampler::kFibonacci, 4096);
  std::vector<Hit> hits(directions.size());
  tracer.intersect(std::vector<Eigen::Vector3f>(directions.size(), point.cast<float>()), directions, hits);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double cosine = normal.dot(directions[i].cast<double>());
    if (cosine > 0.0 && hits[i].face == Hit::kNothing) {
      sum += 4.0 / static_cast<double>(directions.size()) * cosine * radiance(light, directions[i].cast<double>());
    }
  }
  return sum;
}

// The glider over a square of ground, in a turned pose: one frame against rays past the wing, under the same light.
TEST(Neighborhood, LightsAFrameOfAStageAsRaysDo) {
  const Mesh wing = primitive_mesh("wing", 32, Eigen::Affine3f(Eigen::Scaling(1.6F)));
  Mesh ground = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(3.0F)));
  refine(ground, 0.3F);
  const LightCoefficients light = [] {  // a bright part of the sky from one side
    LightCoefficients sky = constant_light(4, 0.4);
    std::array<double, 5> zonal{};
    sh::cap<4>(1.0 - std::cos(0.6), zonal.data());
    std::array<double, 25> row{};
    const Eigen::Vector3d towards = Eigen::Vector3d(0.3, 0.2, 1.0).normalized();
    sh::zonal<4>(zonal.data(), towards.x(), towards.y(), towards.z(), row.data());
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < row.size(); ++i) sky.at(c, i) += 3.0 * row[i];
    }
    return sky;
  }();
  const Pose pose{rotation_about(Eigen::Vector3d(0.2, 0.1, 1.0), 40.0), Eigen::Vector3d(0.1, -0.1, 0.7)};
  for (const auto& [degree, limit] : {std::pair{4, 0.02}, {2, 0.06}}) {
    Stage stage;
    stage.objects.push_back(stage_of(baked(ground, &kUnshadowed, 64, 4)).objects.front());
    stage.objects.push_back(stage_of(baked(wing, &kUnshadowed, 64, 4)).objects.front());
    stage.objects[0].per_vertex = true;
    stage.objects[1].volume = std::make_shared<const Transfer>(space_around(
        wing, in_box(Eigen::Vector3d(-2.6, -2.6, -1.4), Eigen::Vector3d(2.6, 2.6, 0.6), {40, 40, 16}, degree, 4, 512)));
    const StageLighting lighting(stage, [&](int /*degree*/) { return LightCoefficients(light); }, {});
    const std::vector<Eigen::Vector3f> frame = lighting.radiance({Pose(), pose}, Eigen::Matrix3d::Identity());
    Mesh placed = wing;
    for (Eigen::Vector3f& p : placed.positions) p = (pose.rotation * p.cast<double>() + pose.position).cast<float>();
    const Tracer tracer(placed);
    double squares = 0.0;
    double shadow = 0.0;
    const double open =
        by_rays(Tracer(moved(placed, {0.0F, 0.0F, -90.0F})), Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), light)
            .x();
    for (std::size_t v = 0; v < ground.positions.size(); ++v) {
      const double expected = by_rays(tracer, ground.point(v), Eigen::Vector3d::UnitZ(), light).x();
      const auto seen = static_cast<double>(frame[v].x() / ground.albedo[v].x());
      squares += std::pow(seen - expected, 2);
      shadow = std::max(shadow, open - expected);
    }
    const double rms = std::sqrt(squares / static_cast<double>(ground.positions.size())) / open;
    RecordProperty("rms_" + std::to_string(degree), std::to_string(rms));
    RecordProperty("shadow_" + std::to_string(degree), std::to_string(shadow / open));
    EXPECT_LT(rms, limit) << degree;
    EXPECT_GT(shadow / open, 0.2) << "there is one";
  }
}

TEST(Neighborhood, HasTheSameBitsForAnyNumberOfThreads) {
  const AroundStage around({volume_of_stairs(), volume_of_stairs()});
  const LightCoefficients light = random_light(4, 9);
  const std::vector<Pose> poses = {Pose(), {rotation_about(kSlanted, 20.0), Eigen::Vector3d(0.3, 0.0, 0.2)}, Pose()};
  const StageLighting lighting(around.stage, [&](int /*degree*/) { return LightCoefficients(light); }, {});
  const auto all = lighting.radiance(poses, Eigen::Matrix3d::Identity());
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(lighting.radiance(poses, Eigen::Matrix3d::Identity()), all);
}

TEST(Neighborhood, ShadesManyReceiversAsEachAlone) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);  // with many receivers at once
  const Transfer volume = random_volume(2, 4);
  const LightCoefficients light = random_light(4, 3);
  const TransferredRadiance reaching(volume, light);
  for (const std::size_t count : {1U, 255U, 256U, 257U, 200000U}) {
    const std::vector<float> places = random_values(3 * count, 8);
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
    for (std::size_t v = 0; v < count; ++v) {
      positions.emplace_back(places[3 * v], places[3 * v + 1], places[3 * v + 2]);
      normals.push_back(positions.back().normalized());
    }
    std::vector<Eigen::Vector3f> radiance(count + 1, Eigen::Vector3f::Constant(-7.0F));
    shade_diffuse(*volume.grid, reaching, positions, normals, std::span(radiance).first(count));
    for (std::size_t v = 0; v < count; v += 1 + count / 300) {
      const Eigen::Vector3d alone = diffuse_at(volume, light, positions[v], normals[v]);
      EXPECT_LT((radiance[v].cast<double>() - alone).norm(), 1e-5 * (1.0 + alone.norm())) << v << " of " << count;
    }
    EXPECT_EQ(radiance.back(), Eigen::Vector3f::Constant(-7.0F)) << count;
  }
}

TEST(Neighborhood, RefusesReceiversOfDifferentCounts) {
  const Transfer volume = random_volume(2, 4);
  const TransferredRadiance reaching(volume, constant_light(2));
  const std::vector<Eigen::Vector3f> two(2, Eigen::Vector3f::UnitZ());
  std::vector<Eigen::Vector3f> one(1);
  EXPECT_NE(message_of([&] { shade_diffuse(*volume.grid, reaching, two, two, one); }), "");
  EXPECT_NE(message_of([&] { shade_diffuse(*volume.grid, reaching, std::span(two).first(1), two, one); }), "");
  shade_diffuse(*volume.grid, reaching, {}, {}, {});
}

}  // namespace
}  // namespace sh::prt::test
