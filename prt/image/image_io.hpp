// Reads pictures from OpenEXR, Radiance, PNG and JPEG files as linear values. The first bytes of a file decide the
// format, not its name.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/mesh/mend.hpp"

namespace sh::prt {

/// The encoding of a file's values. kOfFile: linear for OpenEXR and Radiance, sRGB for PNG and JPEG.
enum class ColorSpace { kOfFile, kLinear, kSrgb };

/// OpenEXR (any compression, DWA included; scanline or tiled; channels named R, G, B in any one layer, or Y alone;
/// alpha is ignored; the data window is the picture), Radiance RGBE (.hdr), or 8-bit PNG or JPEG, whose bytes become
/// 0..1. Values are taken as Rec. 709. Throws std::runtime_error, one line with the file's name, if the file is
/// missing, truncated or of another format, if the picture is too large or has non-finite values, and if sRGB is
/// requested of OpenEXR or Radiance. Reports negative pixels (see mend_pixels) and pixels that are not opaque as flaws.
Image read_image(const std::string& file, OnFlaw on_flaw, ColorSpace space = ColorSpace::kOfFile);

/// The OpenEXR part of read_image, before mend_pixels.
Image read_exr(const std::string& file, OnFlaw on_flaw);

/// The other parts of read_image: `bytes` are the whole file, `file` is its name for messages. Values are divided by
/// the EXPOSURE of a Radiance header.
Image read_radiance(const std::string& file, std::string_view bytes);
Image read_png(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw);
Image read_jpeg(const std::string& file, std::string_view bytes, ColorSpace space);

}  // namespace sh::prt
