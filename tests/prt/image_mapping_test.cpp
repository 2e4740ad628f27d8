// Angular maps, mirror balls, crosses and strips: their axes, the solid angles of their pixels, and projections of
// pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/sampling/solid_angle.hpp"
#include "prt/image/environment.hpp"
#include "prt/light/project.hpp"
#include "prt/transfer/transfer.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/random_light.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

struct Size {
  int width;
  int height;
};

/// A picture whose faces (or disc) have `edge` pixels.
Size size_of(ImageMapping mapping, int edge) {
  switch (mapping) {
    case ImageMapping::kLatLong:
      return {2 * edge, edge};
    case ImageMapping::kHorizontalCross:
      return {4 * edge, 3 * edge};
    case ImageMapping::kVerticalCross:
      return {3 * edge, 4 * edge};
    case ImageMapping::kCubeStrip:
      return {6 * edge, edge};
    default:
      return {edge, edge};
  }
}

Image black(ImageMapping mapping, int edge) {
  const Size size = size_of(mapping, edge);
  const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {size.width, size.height, std::vector<Eigen::Vector3f>(pixels, Eigen::Vector3f::Zero()), 0};
}

Eigen::Vector3f& pixel(Image& image, int column, int row) {
  return image
      .pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column)];
}

const std::vector<ImageMapping> kOthers{ImageMapping::kAngularMap, ImageMapping::kMirrorBall,
                                        ImageMapping::kHorizontalCross, ImageMapping::kVerticalCross,
                                        ImageMapping::kCubeStrip};

double solid_angle(const std::vector<PixelNode>& nodes) {
  double sum = 0.0;
  for (const PixelNode& node : nodes) sum += node.weight;
  return sum;
}

double largest_difference(const LightCoefficients& a, const LightCoefficients& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
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
    const Size size = size_of(mapping, 1);
    return towards(mapping, 31, (column + 0.5) / size.width, (row + 0.5) / size.height);
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
    pixel_nodes(mapping, size_of(mapping, n).width, c0, r0, a);
    pixel_nodes(mapping, size_of(mapping, n).width, c1, r1, b);
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
      const Size size = size_of(mapping, edge);
      double sum = 0.0;
      std::vector<PixelNode> nodes;
      for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
          pixel_nodes(mapping, size.width, column, row, nodes);
          sum += solid_angle(nodes);
        }
      }
      EXPECT_NEAR(sum / (4.0 * kPi), 1.0, 1e-9) << static_cast<int>(mapping) << ' ' << edge;
    }
  }
}

TEST(ImageMapping, TexelsHaveTheirExactSolidAngle) {
  std::vector<PixelNode> nodes;
  for (const int k : {0, 5, 15}) {
    pixel_nodes(ImageMapping::kCubeStrip, 6 * 16, k, 3, nodes);
    const double exact = numeric::texel_solid_angle<double>((2 * k + 1) / 16.0 - 1.0, 7.0 / 16.0 - 1.0, 16);
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
  const LightCoefficients known = test::random_light(3, 3);
  for (const ImageMapping mapping : kOthers) {
    double error[2];
    for (const int round : {0, 1}) {
      Image image = black(mapping, 32 << round);
      std::vector<PixelNode> nodes;
      for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
          pixel_nodes(mapping, image.width, column, row, nodes);
          if (!nodes.empty()) {  // the mean over the pixel
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (const PixelNode& node : nodes) mean += node.weight * radiance(known, node.direction);
            pixel(image, column, row) = (mean / solid_angle(nodes)).cast<float>();
          }
        }
      }
      error[round] = largest_difference(project_image(image, mapping, 3), known);
    }
    EXPECT_LT(error[1], 2e-2) << static_cast<int>(mapping);
    EXPECT_GT(error[0] / error[1], 2.0) << static_cast<int>(mapping) << ' ' << error[0] << ' ' << error[1];
  }
}

TEST(ImageMapping, LookupIsThePixelThatShowsTheDirection) {
  for (const ImageMapping mapping : kOthers) {
    const Size size = size_of(mapping, 15);
    Image image = test::pattern_image(size.width, size.height);
    std::vector<PixelNode> nodes;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        pixel_nodes(mapping, size.width, column, row, nodes);
        const bool whole = cube_faces(mapping).empty()
                               ? std::hypot((2.0 * column + 1.0) / 15 - 1.0, (2.0 * row + 1.0) / 15 - 1.0) < 0.9
                               : !nodes.empty();
        if (whole) {
          const Eigen::Vector3d middle = nodes[nodes.size() / 2].direction;
          EXPECT_LT((lookup(image, mapping, middle) - image.at(column, row)).norm(),
                    cube_faces(mapping).empty() ? 1e-6F : 1.0F)
              << static_cast<int>(mapping) << ' ' << column << ' ' << row;
        }
      }
    }
    for (const Eigen::Vector3d& d : {kX, kY, kZ}) {
      EXPECT_TRUE(lookup(image, mapping, d).allFinite());
      EXPECT_TRUE(lookup(image, mapping, -d).allFinite());
    }
  }
}

TEST(ImageMapping, OtherShapesAreRefused) {
  const auto refusal = [](int width, int height, ImageMapping mapping) {
    return test::message_of([&] { require_shape("a.exr", test::pattern_image(width, height), mapping); });
  };
  EXPECT_EQ(refusal(16, 8, ImageMapping::kMirrorBall),
            "a.exr: the picture is 16 x 8 pixels; the mapping mirror_ball needs 1:1, in whole faces");
  EXPECT_EQ(refusal(12, 16, ImageMapping::kHorizontalCross),
            "a.exr: the picture is 12 x 16 pixels; the mapping horizontal_cross needs 4:3, in whole faces");
  EXPECT_EQ(refusal(16, 12, ImageMapping::kVerticalCross),
            "a.exr: the picture is 16 x 12 pixels; the mapping vertical_cross needs 3:4, in whole faces");
  EXPECT_EQ(refusal(13, 2, ImageMapping::kCubeStrip),
            "a.exr: the picture is 13 x 2 pixels; the mapping cube_strip needs 6:1, in whole faces");
}

TEST(ImageMapping, PlacesAndDirectionsAreInversesAndAgreeWithThePixels) {
  for (int i = 0; i < 6; ++i) {
    const auto mapping = static_cast<ImageMapping>(i);
    const MappingShape shape = mapping_shape(mapping);
    const int size = 24;
    int shown = 0;
    std::vector<PixelNode> nodes;
    for (int row = 0; row < shape.height * size; ++row) {
      for (int column = 0; column < shape.width * size; ++column) {
        const double u = (column + 0.5) / (shape.width * size);
        const double v = (row + 0.5) / (shape.height * size);
        const auto direction = mapped_direction(mapping, u, v);
        if (mapping != ImageMapping::kLatLong) {
          pixel_nodes(mapping, shape.width * size, column, row, nodes);
          if (nodes.empty()) {
            EXPECT_FALSE(direction) << i;
          }
        }
        if (!direction) continue;
        ++shown;
        EXPECT_NEAR(direction->norm(), 1.0, 1e-14);
        const Eigen::Vector2d place = mapped_place(mapping, *direction);
        EXPECT_NEAR(place.x(), u, 1e-5) << i;
        EXPECT_NEAR(place.y(), v, 1e-5) << i;
        const auto nearest = std::max_element(nodes.begin(), nodes.end(), [&](const auto& a, const auto& b) {
          return a.direction.dot(*direction) < b.direction.dot(*direction);
        });
        if (nearest != nodes.end()) {
          EXPECT_GT(nearest->direction.dot(*direction), std::cos(0.3)) << i;
        }
      }
    }
    EXPECT_GT(shown, shape.width * shape.height * size * size / 2 - 1) << i;
  }
}

}  // namespace
}  // namespace sh::prt
