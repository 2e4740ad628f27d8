#include "numeric/output/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "numeric/output/log.hpp"

namespace sh::output {

namespace {

constexpr std::size_t kBarWidth = 32;
constexpr std::chrono::milliseconds kBarInterval{100};
constexpr std::chrono::milliseconds kLineInterval{5000};

volatile std::sig_atomic_t stop_asked = 0;

extern "C" void ask_to_stop(int /*signal*/) { stop_asked = 1; }

}  // namespace

void stop_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second signal ends the process
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void check_interrupt() {
  if (stop_asked != 0) throw Interrupted("interrupted; nothing was written");
}

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(log_format() == LogFormat::kText && isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_draw_(start_) {}

Progress::~Progress() {
  if (open_line_) fmt::print(stderr, "\n");
}

void Progress::advance(std::size_t steps) {
  check_interrupt();
  done_ += steps;
  const std::unique_lock lock(drawing_, std::try_to_lock);
  const auto now = std::chrono::steady_clock::now();
  if (lock.owns_lock() && now - last_draw_ >= (terminal_ ? kBarInterval : kLineInterval)) {
    last_draw_ = now;
    draw(done_);
  }
}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::draw(std::size_t done) {
  if (log_format() == LogFormat::kNone) return;
  if (log_format() == LogFormat::kJson) return log_progress(what_, done, total_, seconds());
  const std::size_t percent = total_ == 0 ? 100 : std::min<std::size_t>(100, done * 100 / total_);
  if (terminal_) {
    const std::size_t filled = percent * kBarWidth / 100;
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3} %", what_, "", filled, "", kBarWidth - filled, percent);
    std::fflush(stderr);
    open_line_ = true;
  } else {
    fmt::print(stderr, "{}: {} %\n", what_, percent);
  }
}

void Progress::finish() {
  const std::lock_guard lock(drawing_);
  if (log_format() == LogFormat::kNone) return;
  if (log_format() == LogFormat::kJson) return log_progress(what_, total_, total_, seconds());
  fmt::print(stderr, "{}{}: done in {:.1f} s{}\n", terminal_ ? "\r" : "", what_, seconds(),
             terminal_ ? std::string(kBarWidth, ' ') : "");
  open_line_ = false;
}

}  // namespace sh::output
