#include "prt/binary/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "numeric/output/printable.hpp"

namespace sh::prt {

InputFile::InputFile(std::string path) : path_(std::move(path)) {
  descriptor_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe without a writer is refused below
  struct stat status = {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) fail(fmt::format("cannot read: {}", std::strerror(errno)));
  if (!S_ISREG(status.st_mode)) {
    close(descriptor_);
    fail("expected a file, got a folder, pipe or device");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { close(descriptor_); }

void InputFile::read(std::uint64_t offset, void* to, std::size_t count) const {
  char* next = static_cast<char*>(to);
  while (count > 0) {
    const ssize_t got = pread(descriptor_, next, count, static_cast<off_t>(offset));
    if (got < 0 && errno != EINTR) fail(fmt::format("cannot read: {}", std::strerror(errno)));
    if (got == 0) fail(fmt::format("truncated: expected {} more bytes at byte {}", count, offset));
    if (got > 0) {
      next += got;
      offset += static_cast<std::uint64_t>(got);
      count -= static_cast<std::size_t>(got);
    }
  }
}

std::string InputFile::start(std::size_t count) const {
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(count, size_)), '\0');
  read(0, bytes.data(), bytes.size());
  return bytes;
}

void InputFile::fail(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}: {}", path_, output::printable(what)));
}

std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 60;
  if (word.size() <= kLongest) return std::string(word);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U) --end;  // no half of a character
  return std::string(word.substr(0, end)) + "...";
}

}  // namespace sh::prt
