#include "tests/prt/transfer_bytes.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace sh::prt::test {
namespace {

layout::Prologue prologue_of(const std::string& bytes) {
  layout::Prologue prologue;
  std::memcpy(&prologue, bytes.data(), std::min(bytes.size(), sizeof prologue));
  return prologue;
}

std::vector<layout::Section> table_of(const std::string& bytes, std::size_t sections) {
  const std::size_t most = (bytes.size() - sizeof(layout::Prologue)) / sizeof(layout::Section);
  std::vector<layout::Section> table(std::min(sections, most));
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::memcpy(&table[i], bytes.data() + sizeof(layout::Prologue) + i * sizeof(layout::Section), sizeof table[i]);
  }
  return table;
}

// Whether the bytes from `first` on have `size` of them.
bool holds(const std::string& bytes, std::uint64_t first, std::uint64_t size) {
  return first <= bytes.size() && size <= bytes.size() - first;
}

}  // namespace

std::string with_checksums(std::string bytes, bool sizes) {
  if (bytes.size() < sizeof(layout::Prologue)) return bytes;
  layout::Prologue prologue = prologue_of(bytes);
  std::vector<layout::Section> table = table_of(bytes, prologue.sections);
  if (table.empty()) return bytes;
  const std::size_t header = sizeof prologue + table.size() * sizeof(layout::Section);
  if (sizes) prologue.file_size = bytes.size();
  if (holds(bytes, header, prologue.header_size)) {
    prologue.header_checksum = checksum(bytes.data() + header, prologue.header_size);
  }
  std::uint64_t next = header + prologue.header_size;
  for (layout::Section& section : table) {
    if (sizes) section.offset = next;
    next += bytes_of(section);
    if (holds(bytes, section.offset, bytes_of(section))) {
      section.checksum = checksum(bytes.data() + section.offset, bytes_of(section));
    }
  }
  prologue.checksum = layout::front_checksum(prologue, table);
  std::memcpy(bytes.data(), &prologue, sizeof prologue);
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::memcpy(bytes.data() + sizeof prologue + i * sizeof(layout::Section), &table[i], sizeof table[i]);
  }
  return bytes;
}

std::string with_table(const std::string& bytes, const std::function<void(std::vector<layout::Section>&)>& change) {
  layout::Prologue prologue = prologue_of(bytes);
  std::vector<layout::Section> table = table_of(bytes, prologue.sections);
  const std::string rest = bytes.substr(sizeof prologue + table.size() * sizeof(layout::Section));
  change(table);
  prologue.sections = static_cast<std::uint32_t>(table.size());
  std::string result(reinterpret_cast<const char*>(&prologue), sizeof prologue);
  result.append(reinterpret_cast<const char*>(table.data()), table.size() * sizeof(layout::Section));
  return result + rest;
}

std::size_t place_of(const std::string& bytes, std::string_view section) {
  for (const layout::Section& known : table_of(bytes, prologue_of(bytes).sections)) {
    if (known.name == layout::padded(section)) return known.offset;
  }
  throw std::out_of_range("no section of this name");
}

}  // namespace sh::prt::test
