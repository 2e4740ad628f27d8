#include "prt/emit/blocks.hpp"

#include <cstring>

#include "prt/transfer/checksum.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLine = 64;

}  // namespace

EmittedData::EmittedData(std::size_t vertices) : vertices_(vertices), bytes_(kLine, '\0') {}

std::size_t EmittedData::add(const void* numbers, std::size_t size, std::size_t bytes, std::size_t rows) {
  const std::size_t offset = bytes_.size();
  char* to = append(emitted_blocks(rows) * kEmittedBlock * size * bytes);
  const char* from = static_cast<const char*>(numbers);
  for (std::size_t v = 0; v < rows; ++v) {
    for (std::size_t k = 0; k < size; ++k, from += bytes) {
      const std::size_t place = (v / kEmittedBlock * size + k) * kEmittedBlock + v % kEmittedBlock;
      std::memcpy(to + place * bytes, from, bytes);
    }
  }
  return offset;
}

std::size_t EmittedData::add_shared(const std::vector<float>& numbers) {
  const std::size_t offset = bytes_.size();
  std::memcpy(append(numbers.size() * sizeof(float)), numbers.data(), numbers.size() * sizeof(float));
  return offset;
}

// Zeros at the end, and their place.
char* EmittedData::append(std::size_t bytes) {
  const std::size_t offset = bytes_.size();
  bytes_.resize(offset + (bytes + kLine - 1) / kLine * kLine);
  return &bytes_[offset];
}

std::uint64_t EmittedData::checksum() const {
  return prt::checksum(bytes_.data() + sizeof(std::uint64_t), bytes_.size() - sizeof(std::uint64_t));
}

std::string EmittedData::file() const {
  std::string file = bytes_;
  const std::uint64_t sum = checksum();
  std::memcpy(file.data(), &sum, sizeof sum);
  return file;
}

}  // namespace sh::prt
