// Reading HDR pictures in every form, refusing bad ones, writing PNG.
#include "prt/image/image.hpp"

#include <OpenEXR/ImfCompression.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include "numeric/output/png.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

float largest_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  float largest = 0.0F;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, (a.pixels[i] - b.pixels[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// A bad file must be refused in one line that names it and contains `reason`.
void expect_refused(const std::string& file, const std::string& reason, OnFlaw on_flaw = OnFlaw::kMend) {
  const std::string message = message_of([&] { read_image(file, on_flaw); });
  EXPECT_NE(message.find(file), std::string::npos) << message;
  EXPECT_NE(message.find(reason), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

struct Form {
  const char* name;
  ExrOptions options;
  float tolerance = 0.0F;  // DWA at its default level on values of 0.25..1: measured 0.0032 and 0.0025, B44 0.0078
};

TEST(Image, ExrIsReadInEveryCompressionLayoutAndLayer) {
  const std::vector<Form> forms = {
      {"none", {.compression = Imf::NO_COMPRESSION}},
      {"rle", {.compression = Imf::RLE_COMPRESSION}},
      {"zip", {}},
      {"zips half", {.compression = Imf::ZIPS_COMPRESSION, .half = true}},
      {"piz", {.compression = Imf::PIZ_COMPRESSION}},
      {"b44 half", {.compression = Imf::B44_COMPRESSION, .half = true}, 0.02F},
      {"dwaa half", {.compression = Imf::DWAA_COMPRESSION, .half = true}, 0.008F},
      {"dwab half tiled", {.compression = Imf::DWAB_COMPRESSION, .tiled = true, .half = true}, 0.008F},
      {"tiled", {.tiled = true}},
      {"alpha", {.alpha = true}},
      {"layer", {.channels = {"View.Combined.R", "View.Combined.G", "View.Combined.B"}}},
      {"data window", {.left = -7, .top = 11}},
      {"tiled data window", {.tiled = true, .left = 5, .top = -3}}};
  const TemporaryFolder folder;
  const Image image = pattern_image(64, 32);
  for (const Form& form : forms) {
    write_exr(folder.file("a.exr"), image, form.options);
    const Image read = read_image(folder.file("a.exr"), OnFlaw::kRefuse);
    EXPECT_LE(largest_difference(read, image), form.tolerance) << form.name;
  }
}

TEST(Image, ExrOfOneLuminanceChannelBecomesGrey) {
  const TemporaryFolder folder;
  const Image image = pattern_image(8, 4);
  write_exr(folder.file("y.exr"), image, {.channels = {"Y"}});
  const Image read = read_image(folder.file("y.exr"), OnFlaw::kRefuse);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_EQ(read.pixels[i], Eigen::Vector3f::Constant(image.pixels[i].x()));
  }
}

TEST(Image, RadianceIsReadRunLengthEncodedAndPlain) {
  const TemporaryFolder folder;
  for (const int width : {4, 64, 256}) {  // below 8 pixels a row is never encoded
    const Image image = pattern_image(width, width / 2);
    for (const bool run_length : {false, true}) {
      write_all(folder.file("a.hdr"), radiance_bytes(image, run_length && width >= 8));
      EXPECT_EQ(largest_difference(read_image(folder.file("a.hdr"), OnFlaw::kRefuse), image), 0.0F);
    }
  }
}

TEST(Image, RadianceExposureIsDividedOut) {
  const TemporaryFolder folder;
  const Image image = pattern_image(16, 8);
  write_all(folder.file("a.hdr"), radiance_bytes(image, true, "EXPOSURE=4\nEXPOSURE=0.5\n"));
  Image expected = image;
  for (Eigen::Vector3f& pixel : expected.pixels) pixel /= 2.0F;
  EXPECT_EQ(largest_difference(read_image(folder.file("a.hdr"), OnFlaw::kRefuse), expected), 0.0F);
}

TEST(Image, RepeatedPixelsOfOldRadianceFilesAreExpanded) {
  const TemporaryFolder folder;
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 600\n";
  bytes += {'\x80', '\x80', '\x80', '\x81', 1, 1, 1, '\x57', 1, 1, 1, 2};  // one, 87 more, 2 * 256 more
  write_all(folder.file("old.hdr"), bytes);
  const Image image = read_image(folder.file("old.hdr"), OnFlaw::kRefuse);
  for (const Eigen::Vector3f& pixel : image.pixels) EXPECT_EQ(pixel, Eigen::Vector3f::Ones());
}

TEST(Image, NegativePixelsAreSetToZeroCountedAndRefusedWhenStrict) {
  const TemporaryFolder folder;
  Image image = pattern_image(16, 8);
  image.pixels[3] = {-0.5F, 1.0F, 2.0F};
  image.pixels[9] = {1.0F, -0.001F, -1.0F};
  write_exr(folder.file("negative.exr"), image);
  testing::internal::CaptureStderr();
  const Image read = read_image(folder.file("negative.exr"), OnFlaw::kMend);
  const std::string warning = testing::internal::GetCapturedStderr();
  EXPECT_EQ(read.negative_pixels, 2U);
  EXPECT_EQ(read.pixels[3], Eigen::Vector3f(0.0F, 1.0F, 2.0F));
  EXPECT_EQ(read.pixels[9], Eigen::Vector3f(1.0F, 0.0F, 0.0F));
  EXPECT_NE(warning.find("2 of 128 pixels"), std::string::npos) << warning;
  EXPECT_EQ(std::count(warning.begin(), warning.end(), '\n'), 1) << warning;
  expect_refused(folder.file("negative.exr"), "2 of 128 pixels", OnFlaw::kRefuse);
}

TEST(Image, NotFinitePixelsAreRefusedWithTheirPlace) {
  const TemporaryFolder folder;
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Image image = pattern_image(16, 8);
    image.pixels[2 * 16 + 5].y() = bad;
    write_exr(folder.file("bad.exr"), image);
    expect_refused(folder.file("bad.exr"), "column 5, row 2");
  }
}

TEST(Image, MissingEmptyAndForeignFilesAreRefused) {
  const TemporaryFolder folder;
  expect_refused(folder.file("missing.exr"), "No such file");
  expect_refused("/", "is no file");
  write_all(folder.file("empty.hdr"), "");
  expect_refused(folder.file("empty.hdr"), "is empty");
  write_all(folder.file("text.exr"), "not a picture");
  expect_refused(folder.file("text.exr"), "is not an OpenEXR, Radiance .hdr, PNG or JPEG picture");
  write_all(folder.file("a.bmp"), "BM and so on");
  expect_refused(folder.file("a.bmp"), "is not an OpenEXR, Radiance .hdr, PNG or JPEG picture");
}

TEST(Image, FilesTruncatedAnywhereAreRefused) {
  const TemporaryFolder folder;
  const Image image = pattern_image(64, 32);
  write_exr(folder.file("0"), image);
  write_exr(folder.file("1"), image, {.tiled = true});
  write_exr(folder.file("2"), image, {.compression = Imf::DWAA_COMPRESSION, .half = true});
  write_all(folder.file("3"), radiance_bytes(image, true));
  write_all(folder.file("4"), radiance_bytes(image, false));
  for (const char* name : {"0", "1", "2", "3", "4"}) {
    const std::string bytes = read_all(folder.file(name));
    for (std::size_t size = 1; size < bytes.size(); size += 1 + bytes.size() / 97) {
      write_all(folder.file("cut"), bytes.substr(0, size));
      expect_refused(folder.file("cut"), "");
    }
    write_all(folder.file("cut"), bytes.substr(0, bytes.size() - 1));
    expect_refused(folder.file("cut"), "");
  }
}

TEST(Image, DamagedExrBytesNeverCrash) {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), pattern_image(16, 8));
  const std::string bytes = read_all(folder.file("a.exr"));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x5A);
    write_all(folder.file("damaged.exr"), damaged);
    const std::string message = message_of([&] { read_image(folder.file("damaged.exr"), OnFlaw::kRefuse); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

// The library would first take 2 GB.
TEST(Image, AnExrAttributeLongerThanTheFileIsRefused) {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), pattern_image(16, 8));
  std::string bytes = read_all(folder.file("a.exr"));
  const std::string name("compression\0compression\0", 24);
  const std::size_t size = bytes.find(name) + name.size();
  for (const char* wrong : {"\xff\xff\xff\x7f", "\xff\xff\xff\xff"}) {
    write_all(folder.file("a.exr"), bytes.replace(size, 4, wrong, 4));
    expect_refused(folder.file("a.exr"), "its header has an attribute of");
  }
}

TEST(Image, RadianceHeadersThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, const std::string& reason) {
    write_all(folder.file("a.hdr"), bytes);
    expect_refused(folder.file("a.hdr"), reason);
  };
  refuse("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n", "xyze");
  refuse("#?RADIANCE\n\n-Y 1 +X 2\n12345678", "no line FORMAT");
  refuse("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+X 2 -Y 1\n12345678", "+X 2 -Y 1");
  refuse("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 2\n", "2 x 0 pixels");
  refuse("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 900000 +X 900000\n", "900000 x 900000 pixels");
  refuse("#?RADIANCE\nEXPOSURE=-1\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n1234", "exposure");
  refuse(std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n\2\2") + '\0' + '\x8' + std::string(8, '\0'),
         "run length");
}

TEST(Image, ExrWithoutColorChannelsIsRefusedWithItsChannels) {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), pattern_image(8, 4), {.channels = {"depth", "u", "v"}});
  expect_refused(folder.file("a.exr"), "depth, u, v");
}

TEST(Image, PngHoldsTheBytesAndSaysSrgb) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> bytes{0, 1, 2, 253, 254, 255, 9, 8, 7, 100, 101, 102};
  output::write_png(folder.file("a.png"), 2, 2, bytes);
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&picture, folder.file("a.png").c_str()), 0);
  picture.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(picture));
  ASSERT_NE(png_image_finish_read(&picture, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, bytes);
  EXPECT_EQ(picture.width, 2U);
  EXPECT_NE(read_all(folder.file("a.png")).find("sRGB"), std::string::npos);
}

TEST(Image, PngThatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> bytes(12, 0);
  EXPECT_NE(message_of([&] { output::write_png(folder.file("no/a.png"), 2, 2, bytes); }).find("no/a.png"),
            std::string::npos);
  EXPECT_NE(message_of([&] { output::write_png("/dev/full", 2, 2, bytes); }).find("No space left"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace sh::prt::test
