// The checksum of transfer files.
#pragma once
#include <cstddef>
#include <cstdint>

namespace sh::prt {

/// XXH3-64 with seed 0.
std::uint64_t checksum(const void* data, std::size_t size);

}  // namespace sh::prt
