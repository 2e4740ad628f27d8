#include "codegen/output/processes.hpp"

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <vector>

namespace sh::codegen {
namespace {

struct Head {
  std::uint64_t index = 0;
  std::uint64_t size = 0;
  std::uint64_t failed = 0;  // 1: the bytes are the text of an exception
};

bool write_all(int file, const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t done = write(file, bytes, size);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool read_all(int file, void* data, std::size_t size) {
  char* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t done = read(file, bytes, size);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

// The next piece of work, in memory that all copies share.
class SharedCounter {
 public:
  SharedCounter() : page_(mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (page_ == MAP_FAILED) throw std::runtime_error("cannot share memory among processes");
    counter_ = new (page_) Counter(0);
  }
  ~SharedCounter() { munmap(page_, sizeof(Counter)); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  std::size_t next() { return counter_->fetch_add(1); }

 private:
  using Counter = std::atomic<std::size_t>;
  static_assert(Counter::is_always_lock_free);
  void* page_;
  Counter* counter_ = nullptr;
};

// The copies of this process and the pipes from them.
class Copies {
 public:
  Copies() = default;
  ~Copies() {
    for (const pid_t process : processes_) kill(process, SIGKILL);
    for (const pid_t process : processes_) waitpid(process, nullptr, 0);
    for (const pollfd& pipe : pipes_) {
      if (pipe.fd >= 0) close(pipe.fd);
    }
  }
  Copies(const Copies&) = delete;
  Copies& operator=(const Copies&) = delete;

  // Never returns in the copy, which calls run(pipe).
  template <class Run>
  void start(const Run& run) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe between processes");
    const pid_t process = fork();
    if (process == 0) {
      close(ends[0]);
      run(ends[1]);
      _exit(0);
    }
    close(ends[1]);
    pipes_.push_back({ends[0], POLLIN, 0});
    if (process < 0) throw std::runtime_error("cannot start a process");
    processes_.push_back(process);
  }

  // Gives every result to take(head, bytes), until all copies have ended.
  template <class Take>
  void collect(const Take& take) {
    for (std::size_t running = pipes_.size(); running > 0;) {
      if (poll(pipes_.data(), pipes_.size(), -1) < 0) continue;
      for (pollfd& pipe : pipes_) {
        if (pipe.fd < 0 || pipe.revents == 0) continue;
        Head head;
        std::string bytes;
        if (read_all(pipe.fd, &head, sizeof head)) {
          bytes.resize(head.size);
          if (!read_all(pipe.fd, bytes.data(), bytes.size())) throw std::runtime_error("a process ended too early");
          take(head, std::move(bytes));
        } else {
          close(pipe.fd);
          pipe.fd = -1;
          --running;
        }
      }
    }
  }

 private:
  std::vector<pid_t> processes_;
  std::vector<pollfd> pipes_;
};

}  // namespace

int core_count() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 1;
}

void in_processes(std::size_t count, int processes, const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& take) {
  if (processes <= 1) {
    for (std::size_t i = 0; i < count; ++i) take(i, work(i));
    return;
  }
  SharedCounter counter;
  Copies copies;
  for (std::size_t p = 0; p < std::min(count, static_cast<std::size_t>(processes)); ++p) {
    copies.start([&](int pipe) {
      for (std::size_t i = counter.next(); i < count; i = counter.next()) {
        Head head{i, 0, 0};
        std::string bytes;
        try {
          bytes = work(i);
        } catch (const std::exception& error) {
          bytes = error.what();
          head.failed = 1;
        }
        head.size = bytes.size();
        if (!write_all(pipe, &head, sizeof head) || !write_all(pipe, bytes.data(), bytes.size())) return;
      }
    });
  }
  std::size_t taken = 0;
  copies.collect([&](const Head& head, const std::string& bytes) {
    if (head.failed != 0) throw std::runtime_error(bytes);
    take(head.index, bytes);
    ++taken;
  });
  if (taken != count) throw std::runtime_error("a process ended too early");
}

}  // namespace sh::codegen
