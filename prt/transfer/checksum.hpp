// The checksum of transfer files.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

/// XXH3-64 with seed 0.
std::uint64_t checksum(const void* data, std::size_t size);

template <class T>
std::uint64_t checksum_of(const std::vector<T>& values) {
  return checksum(values.data(), values.size() * sizeof(T));
}

/// As text: 16 hexadecimal digits.
std::string checksum_text(std::uint64_t sum);

}  // namespace sh::prt
