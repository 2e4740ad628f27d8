// The layout of a transfer file, shared by its writer and its reader. prt/README.md states it byte by byte.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sh::prt::layout {

static_assert(std::endian::native == std::endian::little, "transfer files are little-endian and read as they lie");

inline constexpr std::array<char, 8> kMagic = {'s', 'h', 'p', 'r', 't', '\r', '\n', '\x1a'};
inline constexpr std::uint32_t kVersion = 1;

/// First in the file; `checksum` is XXH3-64 of the bytes before it followed by the section table.
struct Prologue {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t sections = 0;
  std::uint64_t file_size = 0;
  std::uint64_t header_size = 0;      // of the JSON text after the table, a multiple of 16
  std::uint64_t header_checksum = 0;  // XXH3-64 of that text
  std::uint64_t checksum = 0;
};

/// One entry of the table after the prologue; its data lie at `offset`, one section right after the other.
struct Section {
  std::array<char, 8> name{};  // padded with zeros
  std::uint32_t type = 0;      // kFloat or kIndex
  std::uint32_t columns = 0;
  std::uint64_t rows = 0;
  std::uint64_t offset = 0;
  std::uint64_t checksum = 0;  // XXH3-64 of the data
};

inline constexpr std::uint32_t kFloat = 0;  // IEEE binary32
inline constexpr std::uint32_t kIndex = 1;  // unsigned, 32 bits

static_assert(sizeof(Prologue) == 48 && sizeof(Section) == 40);

/// The sections in their order.
struct Kind {
  std::string_view name;
  std::uint32_t type;
  std::uint32_t columns;  // 0: channels * bands^2
};
inline constexpr std::array<Kind, 7> kSections = {{{"position", kFloat, 3},
                                                   {"normal", kFloat, 3},
                                                   {"geonorm", kFloat, 3},
                                                   {"albedo", kFloat, 3},
                                                   {"face", kIndex, 3},
                                                   {"remap", kIndex, 1},
                                                   {"transfer", kFloat, 0}}};

}  // namespace sh::prt::layout
