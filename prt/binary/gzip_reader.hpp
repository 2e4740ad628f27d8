// gzip streams [RFC 1952] by zlib, inflated piece by piece.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace sh::prt {

class InputFile;

/// Inflates a file from a byte on. Throws std::runtime_error with one line for what is no gzip stream, is truncated,
/// damaged (CRC-32, once the end is read) or followed by further bytes.
class GzipReader {
 public:
  explicit GzipReader(const InputFile& file, std::uint64_t first_byte = 0);
  ~GzipReader();
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;

  /// The next `count` bytes; fewer only at the end of the stream.
  std::string read(std::size_t count);

 private:
  void refill();
  void end();

  struct State;
  const InputFile& file_;
  std::unique_ptr<State> state_;
};

}  // namespace sh::prt
