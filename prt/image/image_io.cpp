// Which reader a file needs: prt/image/image_io.hpp.
#include "prt/image/image_io.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "numeric/output/read_file.hpp"

namespace sh::prt {
namespace {

std::string read_bytes(const std::string& file) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(fmt::format("{}: is no file; an OpenEXR or Radiance .hdr picture is needed", file));
  }
  return output::read_file(file, std::numeric_limits<std::size_t>::max());
}

constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);

}  // namespace

Image read_image(const std::string& file, OnFlaw on_flaw) {
  const std::string bytes = read_bytes(file);
  Image image;
  if (bytes.starts_with(kExrMagic)) {
    image = read_exr(file, on_flaw);
  } else if (bytes.starts_with("#?")) {
    image = read_radiance(file, bytes);
  } else {
    throw std::runtime_error(
        fmt::format("{}: {} an OpenEXR or Radiance .hdr picture", file, bytes.empty() ? "is empty, not" : "is not"));
  }
  mend_pixels(file, image, on_flaw);
  return image;
}

}  // namespace sh::prt
