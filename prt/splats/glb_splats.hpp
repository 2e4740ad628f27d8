// Reads and writes GLB files with the glTF extension KHR_gaussian_splatting (Khronos Group, ratified 2026).
#pragma once
#include <memory>
#include <string>

#include "prt/splats/splat_reader.hpp"
#include "prt/splats/splat_writer.hpp"

namespace sh::prt {

/// The extension holds coefficients to this degree.
inline constexpr int kHighestGlbDegree = 3;

/// Reads the one primitive with the extension, whose attributes may be of any type that the extension allows. Its
/// node's transformation is the placement of the splats. Throws std::runtime_error with one line for a file without the
/// extension or with splats that are compressed, in another file, in several primitives or nodes, or not all there.
std::unique_ptr<SplatReader> read_glb_splats(const std::string& file);

/// One primitive whose attributes stand splat by splat, in single precision, with colors for viewers of points. Throws
/// std::invalid_argument with one line without splats, above degree 3, and for more than 4 GB; encode() throws
/// std::runtime_error for a scale beyond single precision.
std::unique_ptr<SplatWriter> write_glb_splats(const SplatOutput& output);

}  // namespace sh::prt
