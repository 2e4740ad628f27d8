// What objects send to the points around them: planes, mirrors and furnaces in closed form, files, threads, several objects.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "prt/bake/bake_volume.hpp"
#include "prt/basis.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/neighborhood.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/unshadowed.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kLight = 2;
constexpr int kResult = 4;
constexpr std::size_t kRows = coefficient_count(kResult);
constexpr std::size_t kColumns = coefficient_count(kLight);

Scene around(Mesh mesh) { return scene_of(std::move(mesh), &kShadowed, 64, 1); }

Mesh painted(Mesh mesh, const Eigen::Vector3f& albedo) {
  paint(mesh, albedo);
  return mesh;
}

/// Points around the z axis that the options' box has at its corners, and the plane z = 0 in it.
VolumeOptions over_plane(float width, int directions = 2048) {
  VolumeOptions options;
  options.counts = {2, 2, 2};
  const double half = 0.51 * static_cast<double>(width);
  options.box.emplace(Eigen::Vector3d(-half, -half, -1.0), Eigen::Vector3d(half, half, 1.0));
  options.directions = directions;
  options.reflects = true;
  return options;
}

VolumeOptions cube(double half, std::uint32_t count, int directions = 512) {
  VolumeOptions options;
  options.counts = {count, count, count};
  options.box.emplace(Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half));
  options.directions = directions;
  options.reflects = true;
  return options;
}

/// The matrix entry of a point.
double entry(const Transfer& volume, std::size_t point, std::size_t channel, std::size_t row, std::size_t column) {
  const TransferShape& shape = volume.indirect_shape;
  return static_cast<double>(
      volume.indirect[(point * shape.channels + channel) * shape.count() + row * shape.columns() + column]);
}

/// The sum over shared directions of y_r(s) f_l(s) over those from which `point` sees the square of this width at z = 0.
template <class Function>
std::vector<double> over_square(const Eigen::Vector3d& point, double width, int directions, const Function& light) {
  std::vector<double> matrix(kRows * kColumns, 0.0);
  for (const Eigen::Vector3f& single : make_directions(Sampler::kFibonacci, directions)) {
    const Eigen::Vector3d s = single.cast<double>();
    if (!(s.z() * point.z() < 0.0)) continue;
    const Eigen::Vector3d hit = point - point.z() / s.z() * s;
    if (std::max(std::abs(hit.x()), std::abs(hit.y())) > 0.5 * width) continue;
    std::array<double, kRows> y{};
    evaluate_basis(kResult, s.x(), s.y(), s.z(), y.data());
    const std::vector<double> l = light(s);
    for (std::size_t r = 0; r < kRows; ++r) {
      for (std::size_t c = 0; c < kColumns; ++c) {
        matrix[r * kColumns + c] += 4.0 * kPi / static_cast<double>(directions) * y[r] * l[c];
      }
    }
  }
  return matrix;
}

// A flat diffuse square sends the same in all directions, by its color, and nothing from its back.
TEST(SentToPoints, OverADiffuseSquareIsItsRadianceWhereItIsSeen) {
  constexpr float kWidth = 4.0F;
  const Eigen::Vector3f albedo(0.8F, 0.4F, 0.0F);
  const Mesh square = painted(primitive_mesh("plane", 3, Eigen::Affine3f(Eigen::Scaling(kWidth))), albedo);
  const VolumeOptions options = over_plane(kWidth);
  const Transfer volume = bake_volume(around(square), options, {});
  const std::vector<float> up = unshadowed_transfer(kLight, {Eigen::Vector3f::UnitZ()});
  double largest = 0.0;
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    const Eigen::Vector3d point = volume.grid->point(p);
    const std::vector<double> seen =
        over_square(point, static_cast<double>(kWidth), options.directions,
                    [&](const Eigen::Vector3d&) { return std::vector<double>(up.begin(), up.end()); });
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < kRows; ++r) {
        for (std::size_t l = 0; l < kColumns; ++l) {
          const double color = point.z() > 0.0 ? static_cast<double>(albedo[static_cast<int>(c)]) : 0.0;
          EXPECT_NEAR(entry(volume, p, c, r, l), color * seen[r * kColumns + l], 2e-4) << p;
          largest = std::max(largest, std::abs(entry(volume, p, c, r, l)));
        }
      }
    }
  }
  EXPECT_GT(largest, 0.05);
}

// A mirror sends the light of the mirrored direction, by its color: what makes caustics.
TEST(SentToPoints, OverAMirrorIsTheMirroredLight) {
  constexpr float kWidth = 4.0F;
  Mesh square = painted(primitive_mesh("plane", 3, Eigen::Affine3f(Eigen::Scaling(kWidth))), Eigen::Vector3f::Zero());
  const Eigen::Vector3f reflectance(1.0F, 0.5F, 0.25F);
  square.mirror.assign(square.positions.size(), reflectance);
  const VolumeOptions options = over_plane(kWidth);
  const Transfer volume = bake_volume(around(square), options, {});
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    const Eigen::Vector3d point = volume.grid->point(p);
    const std::vector<double> seen =
        over_square(point, static_cast<double>(kWidth), options.directions, [](const Eigen::Vector3d& s) {
          std::vector<double> y(kColumns);
          evaluate_basis(kLight, s.x(), s.y(), -s.z(), y.data());
          return y;
        });
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const double color = point.z() > 0.0 ? static_cast<double>(reflectance[static_cast<int>(c)]) : 0.0;
        EXPECT_NEAR(entry(volume, p, c, i / kColumns, i % kColumns), color * seen[i], 2e-4) << p;
      }
    }
  }
}

// An object that reflects all light cannot be seen under constant light.
TEST(SentToPoints, InAFurnaceNoObjectIsSeen) {
  for (const char* primitive : {"sphere", "torus"}) {
    const Mesh white = painted(with_one_normal(primitive), Eigen::Vector3f::Constant(0.9999F));
    const Transfer volume = bake_volume(around(white), cube(0.9, 4, 2048), {});
    const LightCoefficients light = constant_light(kLight);
    const TransferredRadiance reaching(volume, light);
    for (std::size_t p = 0; p < volume.receivers(); ++p) {
      if (volume.grid->point(p).cwiseAbs().maxCoeff() < 0.6) continue;  // may be inside, or beside the surface
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(static_cast<double>(reaching.at(p)[c * kRows]) / light.at(static_cast<int>(c), 0), 1.0, 5e-3);
        for (std::size_t i = 1; i < kRows; ++i) {
          EXPECT_NEAR(static_cast<double>(reaching.at(p)[c * kRows + i]) / light.at(static_cast<int>(c), 0), 0.0, 8e-3);
        }
      }
    }
  }
}

TEST(SentToPoints, OfABlackObjectIsNothingAndItsVisibilityIsTheSame) {
  const Mesh black = painted(primitive_mesh("torus"), Eigen::Vector3f::Zero());
  VolumeOptions options = cube(1.0, 3);
  const Transfer volume = bake_volume(around(black), options, {});
  for (const float number : volume.indirect) EXPECT_EQ(number, 0.0F);
  options.reflects = false;
  const Transfer plain = bake_volume(around(black), options, {});
  EXPECT_EQ(volume.coefficients, plain.coefficients);
  EXPECT_TRUE(plain.indirect.empty());
}

TEST(SentToPoints, AddsToTheLightThatReachesThem) {
  const Mesh mesh = painted(primitive_mesh("stairs"), {0.7F, 0.5F, 0.2F});
  VolumeOptions options = cube(1.2, 3);
  const Transfer volume = bake_volume(around(mesh), options, {});
  options.reflects = false;
  const Transfer plain = bake_volume(around(mesh), options, {});
  LightCoefficients light = constant_light(kLight);
  light.at(0, 3) = 0.7;
  light.at(2, 1) = -0.4;
  const TransferredRadiance all(volume, light);
  const TransferredRadiance direct(plain, light);
  const TransferredRadiance sent = TransferredRadiance::sent(volume, light);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < kRows; ++r) {
        double expected = 0.0;
        for (std::size_t l = 0; l < kColumns; ++l) {
          expected += entry(volume, p, c, r, l) * light.at(static_cast<int>(c), static_cast<int>(l));
        }
        EXPECT_NEAR(static_cast<double>(sent.at(p)[c * kRows + r]), expected, 1e-5);
        EXPECT_NEAR(static_cast<double>(all.at(p)[c * kRows + r] - direct.at(p)[c * kRows + r]), expected, 1e-5);
      }
    }
  }
  // A light of more bands than the matrices: these do not meet the others.
  const TransferredRadiance of_more = TransferredRadiance::sent(volume, constant_light(5));
  const TransferredRadiance of_two = TransferredRadiance::sent(volume, constant_light(2));
  EXPECT_EQ(of_more.at(1)[0], of_two.at(1)[0]);
}

TEST(SentToPoints, IsKeptByFilesInHalfPrecision) {
  const TemporaryFolder folder;
  const Mesh mesh = painted(primitive_mesh("torus"), {0.7F, 0.5F, 0.2F});
  const Transfer volume = bake_volume(around(mesh), cube(1.0, 3), {});
  write_transfer(folder.file("a.transfer"), volume);
  const Transfer read = read_transfer(folder.file("a.transfer"), volume_kinds());
  EXPECT_EQ(read.kind, &kReflectingNeighborhood);
  EXPECT_EQ(read.indirect_shape.result_degree, kResult);
  EXPECT_EQ(read.indirect_shape.degree, kLight);
  const LightCoefficients light = constant_light(kLight);
  const TransferredRadiance first(volume, light);
  const TransferredRadiance again(read, light);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    for (std::size_t i = 0; i < 3 * kRows; ++i) EXPECT_NEAR(again.at(p)[i], first.at(p)[i], 4e-3F);
  }
}

TEST(SentToPoints, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = painted(primitive_mesh("torus"), {0.7F, 0.5F, 0.2F});
  const Transfer one = bake_volume(around(mesh), cube(1.0, 4), {.threads = 1});
  EXPECT_EQ(one.indirect, bake_volume(around(mesh), cube(1.0, 4), {.threads = 2}).indirect);
}

// Far from the origin and in other units, the same object sends the same.
TEST(SentToPoints, DependsOnNoUnitAndNoPlace) {
  const Mesh mesh = painted(primitive_mesh("stairs"), {0.7F, 0.5F, 0.2F});
  const Transfer one = bake_volume(around(mesh), cube(1.0, 3), {});
  Mesh far = mesh;
  const Eigen::Vector3d place(4096.0, -8192.0, 0.0);
  for (Eigen::Vector3f& position : far.positions) position = 4.0F * position + place.cast<float>();
  VolumeOptions options = cube(1.0, 3);
  options.box.emplace(place - Eigen::Vector3d::Constant(4.0), place + Eigen::Vector3d::Constant(4.0));
  Scene scene = BakeJob(around(far)).scene;  // in a frame of its own
  const Transfer other = bake_volume(scene, options, {});
  double worst = 0.0;
  for (std::size_t i = 0; i < one.indirect.size(); ++i) {
    worst = std::max(worst, static_cast<double>(std::abs(one.indirect[i] - other.indirect[i])));
  }
  EXPECT_LT(worst, 0.02);
}

// What two objects send adds up where their boxes overlap; neither stands in the way of the other.
TEST(SentToPoints, OfSeveralObjectsAddsUp) {
  const auto object_at = [](float x, bool reflects) {
    Mesh mesh = painted(primitive_mesh("sphere", 48), {0.9F, 0.3F, 0.3F});
    for (Eigen::Vector3f& position : mesh.positions) position = 0.8F * position + Eigen::Vector3f(x, 0.0F, 0.6F);
    VolumeOptions options = cube(1.5, 4, 2048);
    options.reflects = reflects;
    return std::make_shared<const Transfer>(bake_volume(around(mesh), options, {}));
  };
  const LightCoefficients light = constant_light(kLight);
  const auto at_origin = [&](const std::vector<std::shared_ptr<const Transfer>>& volumes) {
    Stage stage;
    const auto receiver = std::make_shared<const Transfer>(baked(primitive_mesh("plane", 3), &kUnshadowed, 16, kLight));
    stage.objects.resize(1 + volumes.size());
    for (std::size_t i = 0; i < stage.objects.size(); ++i) {
      stage.objects[i].transfer = receiver;
      if (i > 0) stage.objects[i].volume = volumes[i - 1];
    }
    return Neighborhoods(stage, std::vector<Pose>(stage.objects.size()), light).at(0, Eigen::Vector3d::Zero()).value();
  };
  const auto left = object_at(-0.7F, true);
  const auto right = object_at(0.7F, true);
  const auto left_black = object_at(-0.7F, false);
  const auto right_black = object_at(0.7F, false);
  const LightCoefficients both = at_origin({left, right});
  const LightCoefficients neither = at_origin({left_black, right_black});
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < static_cast<int>(kColumns); ++i) {
      const double added = both.at(c, i) - neither.at(c, i);
      const double each = at_origin({left}).at(c, i) - at_origin({left_black}).at(c, i) + at_origin({right}).at(c, i) -
                          at_origin({right_black}).at(c, i);
      EXPECT_NEAR(added, each, 1e-5) << c << ' ' << i;
    }
  }
  EXPECT_GT(both.at(0, 0) - neither.at(0, 0), 0.05);
}

}  // namespace
}  // namespace sh::prt::test
