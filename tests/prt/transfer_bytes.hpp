// The bytes of a transfer file: its checksums made good after a change, for files with valid checksums and bad content.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "prt/transfer/transfer_layout.hpp"

namespace sh::prt::test {

/// The same bytes with all checksums right, as far as the parts that they cover lie inside of the file. With `sizes`
/// the size of the file and the offsets of its sections are made right, too.
std::string with_checksums(std::string bytes, bool sizes = false);

/// The same bytes with a changed section table; the sections keep their places, or move by the change in its size.
std::string with_table(const std::string& bytes, const std::function<void(std::vector<layout::Section>&)>& change);

/// The start of a section in a file that can be read; throws std::out_of_range if it has none of this name.
std::size_t place_of(const std::string& bytes, std::string_view section);

}  // namespace sh::prt::test
