#include "tests/fuzz/entry.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace sh::fuzz {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: broken promise: %s\n", what);
  std::abort();
}

void require_one_line(std::string_view message) {
  const bool has_control = std::any_of(message.begin(), message.end(), [](unsigned char c) { return c < 0x20; });
  require(!message.empty() && !has_control, "an error is one line without control characters");
}

MemoryFile::MemoryFile() : descriptor_(memfd_create("input", MFD_CLOEXEC)) {
  require(descriptor_ >= 0, "a file in memory can be made");
  path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

MemoryFile::~MemoryFile() { close(descriptor_); }

void MemoryFile::hold(std::string_view bytes) const {
  const bool is_held = ftruncate(descriptor_, 0) == 0 &&
                       pwrite(descriptor_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
  require(is_held, "a file in memory holds the input");
}

void run_reader(void (*read)(const std::string& file), std::string_view bytes) {
  static const MemoryFile file;
  file.hold(bytes);
  try {
    read(file.path());
  } catch (const std::bad_alloc&) {
    require(false, "memory is asked for only after the size was checked");
  } catch (const std::exception& error) {
    require_one_line(error.what());
  }
}

}  // namespace sh::fuzz
