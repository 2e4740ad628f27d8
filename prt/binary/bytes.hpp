// Bytes of little-endian files.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace sh::prt {

static_assert(std::endian::native == std::endian::little, "files are written as numbers are in memory");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

inline void append_word(std::string& bytes, std::uint32_t word) { append(bytes, &word, 1); }

/// The word at `offset`. Precondition: it lies inside.
inline std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// Fills up to a multiple of four.
inline void pad(std::string& bytes, char with) { bytes.append((4 - bytes.size() % 4) % 4, with); }

}  // namespace sh::prt
