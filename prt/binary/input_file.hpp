// A file whose parts are read by several threads, or bytes in memory in its place.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sh::prt {

class InputFile {
 public:
  /// Throws std::runtime_error, `path: cannot read: reason`, and for what is no regular file.
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Reads bytes offset .. offset + count - 1. Throws std::runtime_error with one line if the file ends before.
  void read(std::uint64_t offset, void* to, std::size_t count) const;
  /// The same of as many bytes as are there, at most `count`.
  [[nodiscard]] std::string start(std::size_t count) const;

  /// Throws std::runtime_error, `path: what`, with control characters as hexadecimal numbers.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// A word of a file inside a message: its first 60 bytes at the most, no half of a character of UTF-8.
std::string shown(std::string_view word);

}  // namespace sh::prt
