#include "prt/splats/splat_formats.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "prt/binary/input_file.hpp"
#include "prt/splats/glb_splats.hpp"
#include "prt/splats/ply_splats.hpp"
#include "prt/splats/spz_splats.hpp"

namespace sh::prt {
namespace {

// Scans have the axes of their cameras, y down, as do the PLY files of training; glTF and SPZ state theirs.
constexpr std::array kFormats = {
    SplatFormat{"3DGS PLY", ".ply", "RDF", false, read_ply_splats, write_ply_splats},
    SplatFormat{"KHR_gaussian_splatting GLB", ".glb", "LUF", true, read_glb_splats, write_glb_splats},
    SplatFormat{"SPZ", ".spz", "RUB", true, read_spz_splats, write_spz_splats}};

constexpr const SplatFormat& kPly = kFormats[0];
constexpr const SplatFormat& kGlb = kFormats[1];
constexpr const SplatFormat& kSpz = kFormats[2];

}  // namespace

std::span<const SplatFormat> splat_formats() { return kFormats; }

const SplatFormat& splat_format_of(const std::string& file) {
  const InputFile input(file);
  const std::string start = input.start(4);
  if (start.starts_with("ply")) return kPly;
  if (start == "glTF") return kGlb;
  if (start == "NGSP" || start.starts_with("\x1f\x8b")) return kSpz;
  input.fail(input.size() == 0
                 ? "the file is empty; expected Gaussian splats: a .ply, .glb or .spz file"
                 : "expected Gaussian splats: a .ply, .glb or .spz file, whose first bytes are `ply`, `glTF`, 1F 8B or "
                   "`NGSP`");
}

const SplatFormat& splat_format_named(const std::string& file) {
  for (const SplatFormat& format : kFormats) {
    if (file.ends_with(format.ending)) return format;
  }
  throw std::invalid_argument(fmt::format("{}: expected a name that ends in .ply, .glb or .spz", file));
}

}  // namespace sh::prt
