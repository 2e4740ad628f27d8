// Writes picture files for tests, with the OpenEXR library and byte by byte.
#pragma once
#include <OpenEXR/ImfCompression.h>

#include <string>
#include <vector>

#include "prt/image/image.hpp"

namespace sh::prt::test {

/// The format of an OpenEXR file.
struct ExrOptions {
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  bool tiled = false;
  int left = 0;  // data window's corner; the display window starts at 0
  int top = 0;
  std::vector<std::string> channels{"R", "G", "B"};  // red, green, blue; one name: red alone under that name
  bool alpha = false;                                // adds a channel A of 0.25
  bool half = false;                                 // 16-bit floats
};

void write_exr(const std::string& file, const Image& image, const ExrOptions& options = {});

/// Radiance RGBE bytes of a picture, run-length encoded or plain; `header` is inserted before the format line.
std::string radiance_bytes(const Image& image, bool run_length, const std::string& header = {});

/// A picture with smooth and with abrupt changes, all values exact in RGBE and in 16-bit floats.
Image pattern_image(int width, int height);

}  // namespace sh::prt::test
