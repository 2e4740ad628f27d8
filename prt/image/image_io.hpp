// Pictures from OpenEXR, Radiance, PNG and JPEG files, linear.
// The format is told by a file's first bytes, not by its name.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/mesh/mend.hpp"

namespace sh::prt {

/// How a file's values are encoded. kOfFile: linear for OpenEXR and Radiance, sRGB for PNG and JPEG.
enum class ColorSpace { kOfFile, kLinear, kSrgb };

/// OpenEXR (any compression, DWA included; scanline or tiled; channels named R, G, B in any one layer, or Y alone;
/// alpha is ignored; the data window is the picture), Radiance RGBE (.hdr), or 8-bit PNG or JPEG, whose bytes become
/// 0..1. Values are taken as Rec. 709. Throws std::runtime_error, one line naming the file, for anything missing,
/// truncated, non-finite, absurdly large or not such a picture, and for sRGB asked of OpenEXR or Radiance. Negative
/// pixels (see mend_pixels) and pixels that are not opaque are flaws to report.
Image read_image(const std::string& file, OnFlaw on_flaw, ColorSpace space = ColorSpace::kOfFile);

/// The OpenEXR part of read_image, before mend_pixels.
Image read_exr(const std::string& file, OnFlaw on_flaw);

/// The other parts: `bytes` are the whole file, `file` its name for messages. A Radiance header's EXPOSURE is divided
/// out.
Image read_radiance(const std::string& file, std::string_view bytes);
Image read_png(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw);
Image read_jpeg(const std::string& file, std::string_view bytes, ColorSpace space);

}  // namespace sh::prt
