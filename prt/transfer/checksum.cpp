#include "prt/transfer/checksum.hpp"

#include <fmt/core.h>

#define XXH_INLINE_ALL  // nothing to link
#include <xxhash.h>

namespace sh::prt {

std::uint64_t checksum(const void* data, std::size_t size) { return XXH3_64bits(data, size); }

std::string checksum_text(std::uint64_t sum) { return fmt::format("{:016x}", sum); }

}  // namespace sh::prt
