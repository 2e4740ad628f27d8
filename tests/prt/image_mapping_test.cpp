// Angular maps, mirror balls, crosses and strips: their axes, the solid angles of their pixels, and projections of
// pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/sampling/solid_angle.hpp"
#include "prt/image/environment.hpp"
#include "prt/light/light.hpp"
#include "prt/transfer/transfer.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// The columns and rows of a picture whose faces (or disc) have `edge` pixels; a lat-long picture is `edge` high.
Eigen::Vector2i size_of(ImageMapping mapping, int edge) {
  const MappingShape shape = mapping_shape(mapping);
  return {shape.width * edge, shape.height * edge};
}

/// Calls visit(column, row, nodes) for each pixel.
template <class Visit>
void for_each_pixel(ImageMapping mapping, int edge, const Visit& visit) {
  const Eigen::Vector2i size = size_of(mapping, edge);
  std::vector<PixelNode> nodes;
  for (int row = 0; row < size.y(); ++row) {
    for (int column = 0; column < size.x(); ++column) {
      if (mapping != ImageMapping::kLatLong) pixel_nodes(mapping, size.x(), column, row, nodes);
      visit(column, row, nodes);
    }
  }
}

Image black(ImageMapping mapping, int edge) {
  const Eigen::Vector2i size = size_of(mapping, edge);
  return {size.x(), size.y(), std::vector<Eigen::Vector3f>(size.prod(), Eigen::Vector3f::Zero()), 0};
}

Eigen::Vector3f& pixel(Image& image, int column, int row) { return image.pixels[row * image.width + column]; }

const std::vector<ImageMapping> kOthers{ImageMapping::kAngularMap, ImageMapping::kMirrorBall,
                                        ImageMapping::kHorizontalCross, ImageMapping::kVerticalCross,
                                        ImageMapping::kCubeStrip};

double solid_angle(const std::vector<PixelNode>& nodes) {
  double sum = 0.0;
  for (const PixelNode& node : nodes) sum += node.weight;
  return sum;
}

/// A bright pixel's mean direction, from its band 1, (y, z, x).
Eigen::Vector3d towards(ImageMapping mapping, int edge, double across, double down) {
  Image image = black(mapping, edge);
  pixel(image, static_cast<int>(across * image.width), static_cast<int>(down * image.height)).setOnes();
  const LightCoefficients light = project_image(image, mapping, 1);
  return Eigen::Vector3d(light.at(0, 3), light.at(0, 1), light.at(0, 2)).normalized();
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

TEST(ImageMapping, SingleBrightPixelsOfDiscsShineFromTheAxesOfTheHeader) {
  // With an odd size, the center of a pixel is the center of the disc. +-y and +-z lie half way to the rim of an
  // angular map, at sin 45 of a ball.
  const auto angular = [](double x, double y) { return towards(ImageMapping::kAngularMap, 201, x, y); };
  EXPECT_LT((angular(0.5, 0.5) - kX).norm(), 1e-9);
  EXPECT_LT((angular(0.25, 0.5) - kY).norm(), 0.01);
  EXPECT_LT((angular(0.75, 0.5) + kY).norm(), 0.01);
  EXPECT_LT((angular(0.5, 0.25) - kZ).norm(), 0.01);
  EXPECT_LT((angular(0.5, 0.75) + kZ).norm(), 0.01);
  EXPECT_LT((angular(0.0, 0.5) + kX).norm(), 0.03);
  const double r = 0.5 * std::sqrt(0.5);
  const auto ball = [](double x, double y) { return towards(ImageMapping::kMirrorBall, 201, x, y); };
  EXPECT_LT((ball(0.5, 0.5) - kX).norm(), 1e-9);
  EXPECT_LT((ball(0.5 + r, 0.5) - kY).norm(), 0.02);
  EXPECT_LT((ball(0.5 - r, 0.5) + kY).norm(), 0.02);
  EXPECT_LT((ball(0.5, 0.5 - r) - kZ).norm(), 0.02);
  EXPECT_LT((ball(0.5, 0.5 + r) + kZ).norm(), 0.02);
  EXPECT_LT((ball(0.999, 0.5) + kX).norm(), 0.3);
}

TEST(ImageMapping, SingleBrightPixelsOfCubesShineFromTheAxesOfTheHeader) {
  const auto at = [](ImageMapping mapping, int column, int row) {
    const Eigen::Vector2i size = size_of(mapping, 1);
    return towards(mapping, 31, (column + 0.5) / size.x(), (row + 0.5) / size.y());
  };
  const auto h = ImageMapping::kHorizontalCross;
  const auto v = ImageMapping::kVerticalCross;
  const auto s = ImageMapping::kCubeStrip;
  const auto expect = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { EXPECT_LT((a - b).norm(), 1e-9); };
  expect(at(h, 1, 0), kZ), expect(at(h, 0, 1), kY), expect(at(h, 1, 1), kX);
  expect(at(h, 2, 1), -kY), expect(at(h, 3, 1), -kX), expect(at(h, 1, 2), -kZ);
  expect(at(v, 1, 0), kZ), expect(at(v, 0, 1), kY), expect(at(v, 1, 1), kX);
  expect(at(v, 2, 1), -kY), expect(at(v, 1, 2), -kZ), expect(at(v, 1, 3), -kX);
  expect(at(s, 0, 0), kX), expect(at(s, 1, 0), -kX), expect(at(s, 2, 0), kY);
  expect(at(s, 3, 0), -kY), expect(at(s, 4, 0), kZ), expect(at(s, 5, 0), -kZ);
}

TEST(ImageMapping, FacesOfACrossMeetAtTheirEdges) {
  // Pixels on both sides of an edge between touching faces show nearly the same direction.
  const int n = 64;
  const auto near = [&](ImageMapping mapping, int c0, int r0, int c1, int r1) {
    std::vector<PixelNode> a;
    std::vector<PixelNode> b;
    pixel_nodes(mapping, size_of(mapping, n).x(), c0, r0, a);
    pixel_nodes(mapping, size_of(mapping, n).x(), c1, r1, b);
    ASSERT_FALSE(a.empty() || b.empty());
    EXPECT_LT((a.front().direction - b.front().direction).norm(), 3.0 / n);
  };
  for (const ImageMapping mapping : {ImageMapping::kHorizontalCross, ImageMapping::kVerticalCross}) {
    for (const int k : {0, 20, 63}) {
      near(mapping, n + k, n - 1, n + k, n);          // +z over +x
      near(mapping, n + k, 2 * n - 1, n + k, 2 * n);  // +x over -z
      near(mapping, n - 1, n + k, n, n + k);          // +y beside +x
      near(mapping, 2 * n - 1, n + k, 2 * n, n + k);  // +x beside -y
    }
  }
  near(ImageMapping::kHorizontalCross, 3 * n - 1, n + 5, 3 * n, n + 5);  // -y beside -x
  near(ImageMapping::kHorizontalCross, 4 * n - 1, n + 5, 0, n + 5);      // -x round to +y
  near(ImageMapping::kVerticalCross, n + 5, 3 * n - 1, n + 5, 3 * n);    // -z over -x
}

TEST(ImageMapping, PixelsOfEveryMappingCoverTheSphereOnce) {
  for (const ImageMapping mapping : kOthers) {
    for (const int edge : {1, 2, 7, 64}) {
      double sum = 0.0;
      for_each_pixel(mapping, edge, [&](int, int, const auto& nodes) { sum += solid_angle(nodes); });
      EXPECT_NEAR(sum / (4.0 * kPi), 1.0, 1e-9) << static_cast<int>(mapping) << ' ' << edge;
    }
  }
}

TEST(ImageMapping, TexelsHaveTheirExactSolidAngle) {
  std::vector<PixelNode> nodes;
  for (const int k : {0, 5, 15}) {
    pixel_nodes(ImageMapping::kCubeStrip, 6 * 16, k, 3, nodes);
    const auto exact = numeric::texel_solid_angle<double>((2 * k + 1) / 16.0 - 1.0, 7.0 / 16.0 - 1.0, 16);
    EXPECT_NEAR(solid_angle(nodes) / exact, 1.0, 1e-13);
  }
}

TEST(ImageMapping, ConstantPicturesLeakNothingIntoHigherBands) {
  for (const ImageMapping mapping : kOthers) {
    for (const int edge : {1, 2, 7, 64}) {
      Image image = black(mapping, edge);
      image.pixels.assign(image.pixels.size(), Eigen::Vector3f::Ones());
      LightCoefficients light = project_image(image, mapping, kMaxDegree);
      for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) -= std::sqrt(4.0 * kPi);
      EXPECT_LT(largest_difference(light, LightCoefficients::zero(kMaxDegree)), 1e-8)
          << static_cast<int>(mapping) << ' ' << edge;
    }
  }
}

TEST(ImageMapping, PictureOfAKnownFunctionGivesItsCoefficientsBack) {
  const LightCoefficients known = random_light(3, 3);
  for (const ImageMapping mapping : kOthers) {
    double error[2] = {};
    for (const int round : {0, 1}) {
      Image image = black(mapping, 32 << round);
      for_each_pixel(mapping, 32 << round, [&](int column, int row, const auto& nodes) {
        if (nodes.empty()) return;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // over the pixel
        for (const PixelNode& node : nodes) mean += node.weight * radiance(known, node.direction);
        pixel(image, column, row) = (mean / solid_angle(nodes)).template cast<float>();
      });
      error[round] = largest_difference(project_image(image, mapping, 3), known);
    }
    EXPECT_LT(error[1], 2e-2) << static_cast<int>(mapping);
    EXPECT_GT(error[0] / error[1], 2.0) << static_cast<int>(mapping) << ' ' << error[0] << ' ' << error[1];
  }
}

TEST(ImageMapping, LookupIsThePixelThatShowsTheDirection) {
  for (const ImageMapping mapping : kOthers) {
    const Eigen::Vector2i size = size_of(mapping, 15);
    const Image image = pattern_image(size.x(), size.y());
    for_each_pixel(mapping, 15, [&](int column, int row, const auto& nodes) {
      const bool is_disc = cube_faces(mapping).empty();
      const double radius = std::hypot((2.0 * column + 1.0) / 15 - 1.0, (2.0 * row + 1.0) / 15 - 1.0);
      if (nodes.empty() || (is_disc && radius >= 0.9)) return;
      const Eigen::Vector3d middle = nodes[nodes.size() / 2].direction;
      EXPECT_LT((lookup(image, mapping, middle) - image.at(column, row)).norm(), is_disc ? 1e-6F : 1.0F)
          << static_cast<int>(mapping) << ' ' << column << ' ' << row;
    });
    for (const Eigen::Vector3d& d : {kX, kY, kZ}) {
      EXPECT_TRUE(lookup(image, mapping, d).allFinite());
      EXPECT_TRUE(lookup(image, mapping, -d).allFinite());
    }
  }
}

TEST(ImageMapping, OtherShapesAreRefused) {
  const auto expect = [](int width, int height, ImageMapping mapping, const std::string& reason) {
    EXPECT_EQ(message_of([&] { require_shape("a.exr", pattern_image(width, height), mapping); }),
              "a.exr: the picture is " + reason + ", in whole faces");
  };
  expect(16, 8, ImageMapping::kMirrorBall, "16 x 8 pixels; the mapping mirror_ball needs 1:1");
  expect(12, 16, ImageMapping::kHorizontalCross, "12 x 16 pixels; the mapping horizontal_cross needs 4:3");
  expect(16, 12, ImageMapping::kVerticalCross, "16 x 12 pixels; the mapping vertical_cross needs 3:4");
  expect(13, 2, ImageMapping::kCubeStrip, "13 x 2 pixels; the mapping cube_strip needs 6:1");
}

TEST(ImageMapping, PlacesAndDirectionsAreInversesAndAgreeWithThePixels) {
  for (int i = 0; i < 6; ++i) {
    const auto mapping = static_cast<ImageMapping>(i);
    const Eigen::Vector2i size = size_of(mapping, 24);
    int shown = 0;
    for_each_pixel(mapping, 24, [&](int column, int row, const auto& nodes) {
      const double u = (column + 0.5) / size.x();
      const double v = (row + 0.5) / size.y();
      const auto direction = mapped_direction(mapping, u, v);
      if (mapping != ImageMapping::kLatLong && nodes.empty()) {
        EXPECT_FALSE(direction) << i;
      }
      if (!direction) return;
      ++shown;
      EXPECT_NEAR(direction->norm(), 1.0, 1e-14);
      const Eigen::Vector2d place = mapped_place(mapping, *direction);
      EXPECT_NEAR(place.x(), u, 1e-5) << i;
      EXPECT_NEAR(place.y(), v, 1e-5) << i;
      double nearest = nodes.empty() ? 1.0 : -1.0;
      for (const PixelNode& node : nodes) nearest = std::max(nearest, node.direction.dot(*direction));
      EXPECT_GT(nearest, std::cos(0.3)) << i;
    });
    EXPECT_GT(shown, size.prod() / 2 - 1) << i;
  }
}

}  // namespace
}  // namespace sh::prt::test
