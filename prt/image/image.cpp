// Reads pictures: the format by the first bytes, the checks of all formats, and the 8-bit formats, PNG with libpng and
// JPEG with libjpeg-turbo.
#include "prt/image/image.hpp"

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>

#include "numeric/output/read_file.hpp"
#include "numeric/output/srgb.hpp"
#include "prt/image/exr_header.hpp"

namespace sh::prt {
namespace {

constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);
constexpr std::string_view kPngMagic("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegMagic("\xff\xd8\xff", 3);

/// The linear value of each byte.
std::array<float, 256> table_for(ColorSpace space) {
  std::array<float, 256> table{};
  for (std::size_t byte = 0; byte < table.size(); ++byte) {
    const double value = static_cast<double>(byte) / 255.0;
    table[byte] = static_cast<float>(space == ColorSpace::kLinear ? value : output::srgb_decode(value));
  }
  return table;
}

/// A pixel has `channels` bytes; the first three are red, green and blue.
Image linear_image(int width, int height, const std::vector<unsigned char>& bytes, std::size_t channels,
                   ColorSpace space) {
  const std::array<float, 256> table = table_for(space);
  Image image{width, height, {}, 0};
  image.pixels.reserve(bytes.size() / channels);
  for (std::size_t i = 0; i + channels <= bytes.size(); i += channels) {
    image.pixels.emplace_back(table[bytes[i]], table[bytes[i + 1]], table[bytes[i + 2]]);
  }
  return image;
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, why));
}

void report_alpha(const std::string& file, const std::vector<unsigned char>& rgba, OnFlaw on_flaw) {
  std::size_t clear = 0;
  for (std::size_t i = 3; i < rgba.size(); i += 4) clear += rgba[i] != 255 ? 1 : 0;
  if (clear > 0) {
    report_flaw(on_flaw,
                fmt::format("{}: {} of {} pixels are not opaque (alpha is ignored)", file, clear, rgba.size() / 4));
  }
}

}  // namespace

void require_sane_size(const std::string& file, long long width, long long height) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  constexpr long long limit = 4096;  // large pictures only take time
#else
  constexpr auto limit = static_cast<long long>(kMaxPixels);
#endif
  if (width > 0 && height > 0 && width <= limit && height <= limit / width) return;
  throw std::runtime_error(
      fmt::format("{}: the picture is {} x {} pixels; expected 1 to {} pixels", file, width, height, limit));
}

void mend_pixels(const std::string& file, Image& image, OnFlaw on_flaw) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Eigen::Vector3f& pixel = image.pixels[i];
    if (!pixel.allFinite()) {
      const auto width = static_cast<std::size_t>(image.width);
      throw std::runtime_error(fmt::format("{}: the pixel in column {}, row {} is ({}, {}, {}); expected finite values",
                                           file, i % width, i / width, pixel.x(), pixel.y(), pixel.z()));
    }
    if ((pixel.array() < 0.0F).any()) {
      ++image.negative_pixels;
      pixel = pixel.cwiseMax(0.0F);
    }
  }
  if (image.negative_pixels > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} pixels are negative in some channel (set to 0)", file,
                                     image.negative_pixels, image.pixels.size()));
  }
}

std::string read_picture_file(const std::string& file) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(
        fmt::format("{}: is no file; expected an OpenEXR, Radiance .hdr, PNG or JPEG picture", file));
  }
  return output::read_file(file, std::numeric_limits<std::size_t>::max());
}

Image read_png_or_jpeg(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw) {
  if (bytes.starts_with(kPngMagic)) return read_png(file, bytes, space, on_flaw);
  if (bytes.starts_with(kJpegMagic)) return read_jpeg(file, bytes, space);
  refuse(file, "it is neither PNG nor JPEG");
}

Image read_image(const std::string& file, OnFlaw on_flaw, ColorSpace space) {
  const std::string bytes = read_picture_file(file);
  if (bytes.starts_with(kPngMagic) || bytes.starts_with(kJpegMagic)) {
    return read_png_or_jpeg(file, bytes, space, on_flaw);
  }
  const bool is_exr = bytes.starts_with(kExrMagic);
  if (!is_exr && !bytes.starts_with("#?")) {
    throw std::runtime_error(fmt::format("{}: {} an OpenEXR, Radiance .hdr, PNG or JPEG picture", file,
                                         bytes.empty() ? "is empty, not" : "is not"));
  }
  if (space == ColorSpace::kSrgb) {
    throw std::runtime_error(fmt::format("{}: is linear by its format; sRGB is for 8-bit pictures", file));
  }
  if (is_exr) check_exr_attributes(file, bytes);
  Image image = is_exr ? read_exr(file, on_flaw) : read_radiance(file, bytes);
  mend_pixels(file, image, on_flaw);
  return image;
}

Image read_png(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> closer(&png, &png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) refuse(file, png.message);
  require_sane_size(file, png.width, png.height);
  if ((png.format & PNG_FORMAT_FLAG_LINEAR) != 0) {
    refuse(file, "it has 16 bits a channel; 8 bits are needed, or OpenEXR or Radiance .hdr for more");
  }
  png.format = PNG_FORMAT_RGBA;
  std::vector<unsigned char> rgba(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr) == 0 || png.warning_or_error != 0) {
    refuse(file, png.message);
  }
  report_alpha(file, rgba, on_flaw);
  return linear_image(static_cast<int>(png.width), static_cast<int>(png.height), rgba, 4, space);
}

Image read_jpeg(const std::string& file, std::string_view bytes, ColorSpace space) {
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), &tjDestroy);
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0;
  int height = 0;
  int chroma = 0;
  int colors = 0;
  if (tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &chroma, &colors) != 0) {
    refuse(file, tjGetErrorStr2(decoder.get()));
  }
  require_sane_size(file, width, height);
  std::vector<unsigned char> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;  // a cut file is refused
  if (tjDecompress2(decoder.get(), data, bytes.size(), rgb.data(), width, 0, height, TJPF_RGB, kFlags) != 0) {
    refuse(file, tjGetErrorStr2(decoder.get()));
  }
  return linear_image(width, height, rgb, 3, space);
}

}  // namespace sh::prt
