// A file that appears complete or not at all: written beside its destination, then renamed over it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace sh::output {

/// After commit() the file and its name are on disk. Without commit() nothing remains, and an old file stays as it was. A
/// destination that exists and is no regular file (a device, a pipe) is written directly. Errors (no permission, a full
/// disk) throw std::runtime_error `path: cannot write: reason`.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  void write(const void* data, std::size_t size);
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  std::string path_;
  std::string temporary_;  // empty: path_ is written directly
  int descriptor_ = -1;
};

/// Writes `text` as the whole of the file. Throws as AtomicFile does.
void write_file(const std::string& path, std::string_view text);

}  // namespace sh::output
