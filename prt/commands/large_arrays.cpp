#include "prt/commands/large_arrays.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>

#include "prt/large_pages.hpp"

namespace sh::prt {

ScratchFull::ScratchFull(const std::string& line) noexcept { line.copy(line_, sizeof line_ - 1); }

namespace {

// The arrays in files of one folder.
class Scratch {
 public:
  explicit Scratch(const std::string& folder) : folder_(folder) {
    const int file = open_file();
    if (file < 0) {
      throw std::runtime_error(
          fmt::format("--scratch {}: {}; expected a folder that can be written", folder, std::strerror(errno)));
    }
    close(file);
  }

  void* map(std::size_t bytes) {
    constexpr std::size_t kMost = std::numeric_limits<off_t>::max();
    if (bytes > kMost) throw std::bad_alloc();
    const int file = open_file();
    int error =
        file < 0 ? errno : posix_fallocate(file, 0, static_cast<off_t>(bytes));  // a full disk: not SIGBUS later
    void* memory = MAP_FAILED;
    if (error == 0) {
      memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      if (memory == MAP_FAILED) error = errno;
    }
    if (file >= 0) close(file);
    if (error != 0) {
      throw ScratchFull(fmt::format("--scratch {}: no {} MiB: {}", folder_, bytes >> 20U, std::strerror(error)));
    }
    const std::lock_guard lock(using_sizes_);
    sizes_.emplace(memory, bytes);
    return memory;
  }

  // False for what map() has not given.
  bool unmap(void* memory) noexcept {
    decltype(sizes_)::node_type gone;  // its memory is given back when the lock is open
    {
      const std::lock_guard lock(using_sizes_);
      gone = sizes_.extract(memory);
    }
    if (gone.empty()) return false;
    munmap(memory, gone.mapped());
    return true;
  }

 private:
  // A file without a name; a negative number and errno where there can be none.
  [[nodiscard]] int open_file() const {
#if defined(O_TMPFILE)
    const int file = open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR)) return file;
#endif
    std::string name = folder_ + "/prt-scratch-XXXXXX";
    const int named = mkstemp(name.data());
    if (named >= 0) unlink(name.c_str());
    return named;
  }

  std::string folder_;
  std::mutex using_sizes_;
  std::map<void*, std::size_t> sizes_;
};

// For operator new, which may be called before other objects exist and after they are gone.
constinit std::atomic<Scratch*> scratch{nullptr};

constexpr std::size_t kInFiles = std::size_t{16} << 20U;      // bytes of arrays, from which on they are
constexpr std::size_t kOnLargePages = std::size_t{4} << 20U;  // smaller ones stay where others were

bool begins_page(void* memory) {
  constexpr std::uintptr_t kLeastPage = 4096;
  return reinterpret_cast<std::uintptr_t>(memory) % kLeastPage == 0;
}

}  // namespace

void use_scratch(const std::string& folder) {
  if (scratch != nullptr) throw std::logic_error("use_scratch: expected one call");
  scratch = new Scratch(folder);
}

}  // namespace sh::prt

void* operator new(std::size_t bytes) {
  using namespace sh::prt;
  Scratch* const used = bytes >= kInFiles ? scratch.load() : nullptr;
  if (used != nullptr) return used->map(bytes);
  while (true) {
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) {
      if (bytes >= kOnLargePages) ask_for_large_pages(memory, bytes);
      return memory;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

// The sanitizers have others of these two than the standard library, which calls those above and below.
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  try {
    return operator new(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept { operator delete(memory); }

void operator delete(void* memory) noexcept {
  using namespace sh::prt;
  Scratch* const used = scratch.load(std::memory_order_relaxed);
  if (used != nullptr && memory != nullptr && begins_page(memory) && used->unmap(memory)) return;
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
