// The time since a moment, by a steady clock.
#pragma once
#include <chrono>

namespace sh::output {

class Stopwatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// Seconds since construction.
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// The moment that many seconds after construction.
  [[nodiscard]] Clock::time_point after(double seconds) const {
    return start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

 private:
  Clock::time_point start_ = Clock::now();
};

}  // namespace sh::output
