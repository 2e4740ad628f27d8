// The parts of an SPZ file (Niantic Labs): six arrays of bytes, one for each attribute.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

class InputFile;

/// In the order of the file.
enum class SpzPart { kPosition, kOpacity, kColor, kScale, kRotation, kHarmonics };
inline constexpr std::size_t kSpzParts = 6;

struct SpzHeader {
  int version = 3;
  std::uint32_t count = 0;
  int degree = 0;
  int fractional_bits = 12;
  int flags = 0;
};
inline constexpr int kSpzAntialiased = 1;
inline constexpr int kSpzExtensions = 2;

struct SpzData {
  SpzHeader header;
  std::array<std::string, kSpzParts> parts;  // (count, spz_size) bytes each
  std::uint64_t extension_bytes = 0;         // of records that this program does not know
};

/// Bytes of a splat: 9, 1, 3, 3, 3 or 4 by version, 3 (bands^2 - 1).
std::size_t spz_size(SpzPart part, const SpzHeader& header);

/// Versions 2 and 3 (gzip) and 4 (zstd). Throws std::runtime_error with one line for what is no SPZ file, of another
/// version, truncated, damaged, or has other counts than its header.
SpzData read_spz(const InputFile& file);

/// The bytes of the file, in pieces. Compresses on all threads; the same bytes for any number of them.
std::vector<std::string> spz_file(const SpzData& data);

}  // namespace sh::prt
