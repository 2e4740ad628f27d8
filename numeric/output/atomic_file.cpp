#include "numeric/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "numeric/output/machine_error.hpp"

namespace sh::output {

namespace {

// Whether a rename would replace a device or a pipe by mistake; false if the path does not exist.
bool is_special(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

// Whether both names stand for one file. It need not exist.
bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const std::filesystem::path first = std::filesystem::weakly_canonical(a, error);
  return !error && first == std::filesystem::weakly_canonical(b, error);
}

// Makes the new name of a file last through a power failure. The file is complete in any case: this function ignores
// errors, because some file systems have no fsync of folders.
void sync_folder(const std::string& path) {
  const auto slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    fsync(descriptor);
    close(descriptor);
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  if (!is_special(path_)) temporary_ = fmt::format("{}.{}.tmp", path_, getpid());
  const std::string& target = temporary_.empty() ? path_ : temporary_;
  descriptor_ = open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    const int error = errno;
    temporary_.clear();
    fail(error);
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, next, size);
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) {
      next += written;
      size -= static_cast<std::size_t>(written);
    }
  }
}

void AtomicFile::commit() {
  // A network or quota file system may report a full disk only here; devices and pipes have no fsync.
  if (!temporary_.empty() && fsync(descriptor_) != 0) fail(errno);
  if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (!temporary_.empty()) {
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    temporary_.clear();
    sync_folder(path_);
  }
}

void AtomicFile::fail(int error) const {
  fail_by(error, fmt::format("{}: cannot write: {}", path_, std::strerror(error)));
}

void write_file(const std::string& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void require_writable(const std::string& path) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{}: cannot write: is a folder; expected a file", path));
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const std::string& checked = std::filesystem::exists(path) ? path : folder.empty() ? "." : folder;
  if (access(checked.c_str(), W_OK) != 0) {
    throw std::runtime_error(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  }
}

void require_no_input(const std::string& path, const std::vector<std::string>& inputs) {
  if (is_special(path)) return;
  for (const std::string& input : inputs) {
    if (!input.empty() && is_same_file(path, input)) {
      throw std::runtime_error(
          fmt::format("{}: expected an output that is not an input too, got the input {}", path, input));
    }
  }
}

}  // namespace sh::output
