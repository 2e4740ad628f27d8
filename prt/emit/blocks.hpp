// The numbers of an emitted run time: sections of blocks of 16 vertices, in each of them one number of all vertices after
// the other. Vertices beyond the last one are zeros.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "prt/transfer/storage.hpp"

namespace sh::prt {

/// As in the emitted code.
inline constexpr std::size_t kEmittedBlock = 16;

constexpr std::size_t emitted_blocks(std::size_t vertices) { return (vertices + kEmittedBlock - 1) / kEmittedBlock; }

class EmittedData {
 public:
  explicit EmittedData(std::size_t vertices);
  /// Appends a section and returns its offset. numbers (rows, size) of `bytes` each, one row after the other; its rows are
  /// those of vertices, or of clusters.
  std::size_t add(const void* numbers, std::size_t size, std::size_t bytes, std::size_t rows);
  std::size_t add(const std::vector<float>& numbers) {
    return add(numbers.data(), numbers.size() / vertices_, sizeof(float), vertices_);
  }
  /// The same of numbers that are nobody's: they stay one after the other.
  std::size_t add_shared(const std::vector<float>& numbers);
  /// The file: the checksum of all that follows it, then the sections, each at a multiple of 64 bytes.
  [[nodiscard]] std::string file() const;
  [[nodiscard]] std::uint64_t checksum() const;

 private:
  char* append(std::size_t bytes);

  std::size_t vertices_;
  std::string bytes_;
};

}  // namespace sh::prt
