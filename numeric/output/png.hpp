// Pictures to PNG files (libpng).
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace sh::output {

/// The bytes of a PNG file. 8-bit sRGB, (height, width, 3) row-major, top row first.
std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb);
/// The same with a fourth channel, alpha, (height, width, 4).
std::string encode_png_rgba(int width, int height, std::span<const std::uint8_t> rgba);

/// encode_png to a file, which appears complete or not at all. Throws std::runtime_error as AtomicFile does.
void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace sh::output
