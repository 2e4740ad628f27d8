// The whole of a file as text, or one line with the reason why not.
#pragma once
#include <cstddef>
#include <string>

namespace sh::output {

/// The bytes of a file or pipe. Throws std::runtime_error, `path: cannot read: reason` or, for more than `largest` bytes
/// (a device may have no end), `path: larger than N MB`.
std::string read_file(const std::string& path, std::size_t largest = 1'000'000'000);

}  // namespace sh::output
