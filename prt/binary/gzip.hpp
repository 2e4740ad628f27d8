// gzip streams [RFC 1952] by zlib, compressed on all threads.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sh::prt {

/// One gzip member with the data of all parts, one after another: every reader takes it as one stream. The same bytes
/// for any number of threads.
std::vector<std::string> gzip(const std::vector<std::string_view>& parts);

}  // namespace sh::prt
