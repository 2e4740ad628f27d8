// Reads and writes SPZ files of versions 2 to 4 (Niantic Labs).
#pragma once
#include <memory>
#include <string>

#include "prt/splats/splat_reader.hpp"
#include "prt/splats/splat_writer.hpp"

namespace sh::prt {

/// Reads the whole file into memory. Throws std::runtime_error with one line; see read_spz.
std::unique_ptr<SplatReader> read_spz_splats(const std::string& file);

/// Rounds the numbers (spz_codes.hpp). Positions have 12 fractional bits, or as many as the box of all splats leaves.
/// Throws std::invalid_argument with one line for other versions and bits, for degree 4 below version 4, and for
/// positions beyond 2^23.
std::unique_ptr<SplatWriter> write_spz_splats(const SplatOutput& output);

}  // namespace sh::prt
