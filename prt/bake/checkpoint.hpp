// Keeps track of the chunks of a bake that are done and of those on disk, so that it can go on where it was stopped.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "prt/bake/checkpoint_contents.hpp"
#include "prt/bake/checkpoint_file.hpp"
#include "prt/bake/job.hpp"

namespace sh::prt {

class Checkpoint {
 public:
  /// Takes what the file holds into `result`, which must outlive this. Throws as CheckpointFile does.
  Checkpoint(const CheckpointSettings& settings, const std::string& key, ShadowResult& result);
  /// The chunk came from the file.
  [[nodiscard]] bool has(std::size_t chunk) const { return restored_[chunk] != 0; }
  /// Notes a chunk whose results are complete, and writes what waits if it is time. From any thread. Throws
  /// std::runtime_error where it cannot be written.
  void finished(std::size_t chunk);
  /// All chunks are finished: writes what waits, unless all of it took no longer than `seconds`.
  void complete();
  /// The process is asked to end: writes what waits. Returns one line: what was kept and how to go on.
  std::string interrupted();

 private:
  using Clock = std::chrono::steady_clock;
  void restore();
  [[nodiscard]] bool is_due() const { return Clock::now() - last_write_ >= interval_; }
  void write_pending();

  ShadowResult& result_;
  std::vector<std::uint8_t> restored_;  // (chunks)
  Clock::duration interval_;
  std::mutex writing_;  // guards the next three
  std::optional<CheckpointFile> file_;
  Clock::time_point last_write_;
  std::size_t written_ = 0;
  std::mutex noting_;  // guards pending_
  std::vector<std::uint32_t> pending_;
};

}  // namespace sh::prt
