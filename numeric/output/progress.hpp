// Progress of long operations on standard error (a bar on a terminal, plain lines elsewhere), and interruption.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <string>

namespace sh::output {

/// Thrown at the next Progress::advance after the user pressed ^C; a tool then exits 130 with nothing half-written.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From now on SIGINT and SIGTERM only ask to stop (see Interrupted); a second one ends the process at once.
void stop_on_interrupt();
/// Throws Interrupted once a stop has been asked for. Cheap.
void check_interrupt();

/// Counts `total` steps of `what`. advance() may be called from any thread; it throws Interrupted when asked to stop.
/// finish() prints the elapsed time; a Progress destroyed without it leaves the terminal on a fresh line.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void advance(std::size_t steps = 1);
  void finish();

 private:
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
