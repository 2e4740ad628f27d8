#include "tests/prt/image_files.hpp"

#include <ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <half.h>

#include <array>
#include <cmath>

namespace sh::prt::test {
namespace {

using Rgbe = std::array<unsigned char, 4>;

/// The channels of a file in memory, all pixels of one after all of another.
struct Planes {
  std::vector<float> floats;
  std::vector<half> halves;
};

Rgbe rgbe(const Eigen::Vector3f& color) {
  const float peak = color.maxCoeff();
  if (peak <= 0.0F) return {0, 0, 0, 0};
  int exponent = 0;
  std::frexp(peak, &exponent);
  Rgbe out{0, 0, 0, static_cast<unsigned char>(exponent + 128)};
  for (int c = 0; c < 3; ++c) {
    out[c] = static_cast<unsigned char>(std::ldexp(color[c], 8 - exponent));
  }
  return out;
}

void append_run_length(std::string& bytes, const std::vector<Rgbe>& row) {
  bytes += {2, 2, static_cast<char>(row.size() >> 8U), static_cast<char>(row.size() & 255U)};
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < row.size();) {
      std::size_t run = 1;
      while (run < 127 && i + run < row.size() && row[i + run][c] == row[i][c]) ++run;
      if (run > 2) {
        bytes += {static_cast<char>(128 + run), static_cast<char>(row[i][c])};
        i += run;
      } else {
        bytes += {1, static_cast<char>(row[i][c])};
        ++i;
      }
    }
  }
}

}  // namespace

Image pattern_image(int width, int height) {
  Image image{width, height, {}, 0};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto x = static_cast<float>(column % 16);
      const auto y = static_cast<float>(row % 16);
      image.pixels.emplace_back(0.5F + x / 32.0F, column < width / 2 ? 0.25F : 0.75F, 0.5F + y / 64.0F);
    }
  }
  return image;
}

void write_exr(const std::string& file, const Image& image, const ExrOptions& options) {
  const Imath::Box2i display({0, 0}, {image.width - 1, image.height - 1});
  const Imath::Box2i data({options.left, options.top},
                          {options.left + image.width - 1, options.top + image.height - 1});
  Imf::Header header(display, data);
  header.compression() = options.compression;
  const Imf::PixelType type = options.half ? Imf::HALF : Imf::FLOAT;
  std::vector<std::string> names = options.channels;
  if (options.alpha) names.emplace_back("A");
  const auto width = static_cast<std::size_t>(image.width);
  Planes planes;
  planes.floats.reserve(names.size() * image.pixels.size());
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    const bool alpha = options.alpha && c + 1 == names.size();
    for (const Eigen::Vector3f& pixel : image.pixels) {
      planes.floats.push_back(alpha ? 0.25F : pixel[static_cast<int>(c)]);
    }
  }
  planes.halves.assign(planes.floats.begin(), planes.floats.end());
  for (std::size_t c = 0; c < names.size(); ++c) {
    const std::size_t first = c * image.pixels.size();
    if (options.half) {
      buffer.insert(names[c], Imf::Slice::Make(type, &planes.halves[first], data, 2, 2 * width));
    } else {
      buffer.insert(names[c], Imf::Slice::Make(type, &planes.floats[first], data, 4, 4 * width));
    }
  }
  if (options.tiled) {
    header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
    Imf::TiledOutputFile out(file.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  } else {
    Imf::OutputFile out(file.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(image.height);
  }
}

std::string radiance_bytes(const Image& image, bool run_length, const std::string& header) {
  std::string bytes =
      fmt::format("#?RADIANCE\n{}FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", header, image.height, image.width);
  for (int row = 0; row < image.height; ++row) {
    std::vector<Rgbe> pixels;
    pixels.reserve(image.width);
    for (int column = 0; column < image.width; ++column) pixels.push_back(rgbe(image.at(column, row)));
    if (run_length) {
      append_run_length(bytes, pixels);
      continue;
    }
    for (const Rgbe& pixel : pixels) bytes.append(pixel.begin(), pixel.end());
  }
  return bytes;
}

}  // namespace sh::prt::test
