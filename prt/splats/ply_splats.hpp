// Reads and writes the .ply files of 3D Gaussian splatting [Kerbl, Kopanas, Leimkuehler, Drettakis 2023].
#pragma once
#include <memory>
#include <string>

#include "prt/splats/splat_reader.hpp"
#include "prt/splats/splat_writer.hpp"

namespace sh::prt {

/// Throws std::runtime_error with one line for a file without the properties of splats, or with wrong counts.
std::unique_ptr<SplatReader> read_ply_splats(const std::string& file);

/// From a PLY file it takes the header, all other properties and elements, and the bytes of all that is not changed.
std::unique_ptr<SplatWriter> write_ply_splats(const SplatOutput& output);

}  // namespace sh::prt
