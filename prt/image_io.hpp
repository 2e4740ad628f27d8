// High-dynamic-range pictures from OpenEXR and Radiance files, low-dynamic-range pictures to PNG.
// The format is told by a file's first bytes, not by its name.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "prt/image.hpp"
#include "prt/mend.hpp"

namespace sh::prt {

/// OpenEXR (any compression, DWA included; scanline or tiled; channels named R, G, B in any one layer, or Y alone;
/// alpha is ignored; the data window is the picture) or Radiance RGBE (.hdr). Values are taken as linear Rec. 709.
/// Throws std::runtime_error, one line naming the file, for anything missing, truncated, non-finite, absurdly large or
/// not such a picture. Negative pixels are a flaw to report (see mend_pixels).
Image read_image(const std::string& file, OnFlaw on_flaw);

/// The OpenEXR half of read_image, before mend_pixels.
Image read_exr(const std::string& file, OnFlaw on_flaw);

/// The Radiance half: `bytes` are the whole file, `file` its name for messages. A header's EXPOSURE is divided out.
Image read_radiance(const std::string& file, std::string_view bytes);

/// 8-bit sRGB, (height, width, 3) row-major, top row first. The file appears complete or not at all.
void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace sh::prt
