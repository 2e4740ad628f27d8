#include "prt/transfer/checksum.hpp"

#define XXH_INLINE_ALL  // nothing to link
#include <xxhash.h>

namespace sh::prt {

std::uint64_t checksum(const void* data, std::size_t size) { return XXH3_64bits(data, size); }

}  // namespace sh::prt
