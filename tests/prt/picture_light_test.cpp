// 8-bit pictures as lights, and suns taken out of pictures.
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "numeric/output/png.hpp"
#include "numeric/output/srgb.hpp"
#include "prt/image/image.hpp"
#include "prt/light/extract_sun.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_shapes.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
using Bytes = std::vector<std::uint8_t>;

Bytes ramp() {  // 16 x 8: every second byte in red, the others shifted
  Bytes rgb;
  for (int i = 0; i < 128; ++i) {
    rgb.insert(rgb.end(), {static_cast<std::uint8_t>(2 * i), static_cast<std::uint8_t>(2 * i + 1),
                           static_cast<std::uint8_t>(255 - i)});
  }
  return rgb;
}

std::string jpeg_of(const Bytes& rgb, int width, int height) {
  const std::unique_ptr<void, decltype(&tjDestroy)> coder(tjInitCompress(), &tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(coder.get(), rgb.data(), width, 0, height, TJPF_RGB, &bytes, &size, TJSAMP_444, 100, 0);
  std::string out(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  return out;
}

TEST(Srgb, DecodesAsTheStandardSays) {
  EXPECT_EQ(output::srgb_decode(0.0), 0.0);
  EXPECT_NEAR(output::srgb_decode(1.0), 1.0, 1e-15);
  EXPECT_NEAR(output::srgb_decode(0.5), 0.21404114048223255, 1e-15);
  EXPECT_NEAR(output::srgb_decode(0.04045), 0.04045 / 12.92, 1e-15);
}

TEST(EightBitPictures, PngIsLinearisedExactlyAndStaysLinearWhereItIs) {
  const TemporaryFolder folder;
  const Bytes rgb = ramp();
  output::write_png(folder.file("a.png"), 16, 8, rgb);
  const Image srgb = read_image(folder.file("a.png"), OnFlaw::kRefuse);
  const Image linear = read_image(folder.file("a.png"), OnFlaw::kRefuse, ColorSpace::kLinear);
  ASSERT_EQ(srgb.pixels.size(), 128U);
  for (std::size_t i = 0; i < 3 * srgb.pixels.size(); ++i) {
    const double byte = rgb[i] / 255.0;
    const auto channel = static_cast<Eigen::Index>(i % 3);
    EXPECT_EQ(srgb.pixels[i / 3][channel], static_cast<float>(output::srgb_decode(byte))) << i;
    EXPECT_EQ(linear.pixels[i / 3][channel], static_cast<float>(byte)) << i;
  }
}

TEST(EightBitPictures, JpegIsReadAndCutFilesOfBothAreRefused) {
  const TemporaryFolder folder;
  const Bytes gray(3 * 64 * 32, 128);
  const std::string jpeg = jpeg_of(gray, 64, 32);
  write_all(folder.file("a.jpg"), jpeg);
  const Image image = read_image(folder.file("a.jpg"), OnFlaw::kRefuse);
  ASSERT_EQ(image.width, 64);
  EXPECT_NEAR(image.at(40, 20).y(), output::srgb_decode(128.0 / 255.0), 0.01);
  const std::string png = output::encode_png(16, 8, ramp());
  for (const std::string& whole : {jpeg, png}) {
    for (const std::size_t size : {whole.size() / 4, whole.size() / 2, whole.size() - 20}) {
      write_all(folder.file("cut"), whole.substr(0, size));
      EXPECT_THROW(static_cast<void>(read_image(folder.file("cut"), OnFlaw::kMend)), std::runtime_error) << size;
    }
  }
}

TEST(EightBitPictures, SrgbAskedOfALinearFormatIsRefused) {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), pattern_image(16, 8));
  EXPECT_THROW(static_cast<void>(read_image(folder.file("a.exr"), OnFlaw::kMend, ColorSpace::kSrgb)),
               std::runtime_error);
}

/// A sky brighter towards +z with a disc, each pixel the mean over 4 x 4 points.
Image sky_with_disc(ImageMapping mapping, int unit, const Eigen::Vector3d& sun, double half_angle, float radiance) {
  const MappingShape shape = mapping_shape(mapping);
  Image image{shape.width * unit, shape.height * unit, {}, 0};
  const double one_minus_cos = numeric::one_minus_cos(kPi / 180.0 * half_angle);
  constexpr int kSide = 4;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int k = 0; k < kSide * kSide; ++k) {
        const int down = k / kSide, across = k % kSide;
        const auto d = mapped_direction(mapping, (column + (across + 0.5) / kSide) / image.width,
                                        (row + (down + 0.5) / kSide) / image.height);
        if (d) {
          const auto sky = static_cast<float>(0.6 + 0.4 * d->z());
          sum += cap_covers(sun, one_minus_cos, *d) ? Eigen::Vector3f(radiance, 0.9F * radiance, 0.8F * radiance)
                                                    : Eigen::Vector3f(0.7F * sky, 0.8F * sky, sky);
        }
      }
      image.pixels.emplace_back(sum / (kSide * kSide));
    }
  }
  return image;
}

TEST(ExtractSun, RecoversADiscOfKnownPlaceSizeAndRadianceInEveryMapping) {
  for (int i = 0; i < 6; ++i) {
    const auto mapping = static_cast<ImageMapping>(i);
    const std::string_view name = numeric::name_of(mapping);
    const int unit = mapping_shape(mapping).width > 2 ? 48 : 128;
    for (const Eigen::Vector3d& towards :
         {Eigen::Vector3d(0.5, -0.3, 0.6), Eigen::Vector3d(0.02, 0.01, 1.0), Eigen::Vector3d(0.7, 0.7, 0.3)}) {
      const Eigen::Vector3d sun = towards.normalized();
      const Image image = sky_with_disc(mapping, unit, sun, 4.0, 500.0F);
      const SunSearch search = extract_sun(image, mapping);
      ASSERT_TRUE(search.sun) << search.why_none << name;
      const double pixel = 2.0 * kPi / (4.0 * unit);  // about, in radian
      EXPECT_LT((search.sun->direction - sun).norm(), pixel) << name;
      EXPECT_NEAR(search.sun->one_minus_cos / numeric::one_minus_cos(kPi / 180.0 * 4.0), 1.0, 0.06) << name;
      EXPECT_NEAR(search.sun->radiance.x(), 500.0, 3.0) << name;
      EXPECT_NEAR(search.sun->radiance.z(), 400.0, 3.0) << name;
      float brightest = 0.0F;
      for (const Eigen::Vector3f& left : search.sun->rest.pixels) brightest = std::max(brightest, left.maxCoeff());
      EXPECT_LT(brightest, 1.3F) << name;
    }
  }
}

TEST(ExtractSun, KeepsTheLightOfThePicture) {
  for (const auto mapping : {ImageMapping::kLatLong, ImageMapping::kAngularMap, ImageMapping::kHorizontalCross}) {
    const Image image = sky_with_disc(mapping, 48, Eigen::Vector3d(0.5, -0.3, 0.6).normalized(), 5.0, 2000.0F);
    const SunSearch search = extract_sun(image, mapping);
    ASSERT_TRUE(search.sun) << search.why_none;
    const LightCoefficients before = project_image(image, mapping, 4);
    LightCoefficients after = project_image(search.sun->rest, mapping, 4);
    const std::vector<double> cap = project_cap(search.sun->direction, search.sun->one_minus_cos, 4);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t k = 0; k < cap.size(); ++k) {
        after.at(channel, k) += search.sun->radiance[static_cast<int>(channel)] * cap[k];
      }
      EXPECT_NEAR(after.at(channel, 0) / before.at(channel, 0), 1.0, 1e-6);  // float pixels
      for (std::size_t k = 1; k < cap.size(); ++k) {
        EXPECT_NEAR(after.at(channel, k), before.at(channel, k), 0.04 * before.at(channel, 0));  // 7 degrees a pixel
      }
    }
  }
}

TEST(ExtractSun, PicturesWithoutASunSaySo) {
  Image constant{32, 16, std::vector<Eigen::Vector3f>(512, Eigen::Vector3f::Ones()), 0};
  EXPECT_FALSE(extract_sun(constant, ImageMapping::kLatLong).sun);
  EXPECT_FALSE(extract_sun(constant, ImageMapping::kLatLong).why_none.empty());
  constant.pixels.assign(512, Eigen::Vector3f::Zero());
  EXPECT_FALSE(extract_sun(constant, ImageMapping::kLatLong).sun);
  const Image sky = sky_with_disc(ImageMapping::kLatLong, 32, Eigen::Vector3d::UnitX(), 5.0, 3.0F);
  EXPECT_FALSE(extract_sun(sky, ImageMapping::kLatLong).sun);  // too dim
  const Image wide = sky_with_disc(ImageMapping::kLatLong, 32, Eigen::Vector3d::UnitX(), 30.0, 3000.0F);
  EXPECT_FALSE(extract_sun(wide, ImageMapping::kLatLong).sun);  // no disc
}

}  // namespace
}  // namespace sh::prt::test
