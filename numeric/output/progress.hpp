// Progress of long operations on standard error (a bar on a terminal, plain lines elsewhere, or lines of JSON: log.hpp),
// and interruption.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <string>

namespace sh::output {

/// Progress::advance throws it after the user pressed ^C; a tool then exits 130 and leaves no half-written file.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From now on SIGINT and SIGTERM only ask to stop (see Interrupted); a second signal ends the process at once.
void stop_on_interrupt();
/// Throws Interrupted if a signal has asked to stop. Cheap.
void check_interrupt();

/// Counts `total` steps of `what`. Any thread may call advance(), which throws Interrupted if a signal has asked to stop.
/// finish() prints the elapsed time; the destructor leaves the terminal on a fresh line.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void advance(std::size_t steps = 1);
  void finish();

 private:
  [[nodiscard]] double seconds() const;
  void draw(std::size_t done);

  std::string what_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::mutex drawing_;
  bool terminal_;
  bool open_line_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace sh::output
