// A file that appears complete or not at all: written beside its destination, then renamed over it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sh::output {

/// After commit() the file and its name are on disk. Without commit() nothing remains, and an old file stays as it was. A
/// destination that exists and is no regular file (a device, a pipe) is written directly. Errors (no permission, a full
/// disk) throw as fail_by (machine_error.hpp) does: `path: cannot write: reason`.
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

/// For tools, before long work starts: throws std::runtime_error with one line if `path` is a folder or cannot be
/// written.
void require_writable(const std::string& path);

/// Throws std::runtime_error with one line if writing `path` would replace one of the files `inputs`, whatever its name.
/// Empty names do not count.
void require_no_input(const std::string& path, const std::vector<std::string>& inputs);

}  // namespace sh::output
