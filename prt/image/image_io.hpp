// High-dynamic-range pictures from OpenEXR and Radiance files.
// The format is told by a file's first bytes, not by its name.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/mesh/mend.hpp"

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

}  // namespace sh::prt
