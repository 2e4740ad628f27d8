#include "prt/bake/checkpoint.hpp"

#include <fmt/core.h>

#include <utility>

namespace sh::prt {

Checkpoint::Checkpoint(const CheckpointSettings& settings, const std::string& key, ShadowResult& result)
    : result_(result),
      restored_(chunk_count(result.sight.size()), 0),
      interval_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.seconds))) {
  if (!settings.path.empty()) {
    file_.emplace(settings.path, key, settings.restart);
    restore();
  }
  last_write_ = Clock::now();
}

void Checkpoint::restore() {
  file_->read([&](std::uint32_t chunk, std::string_view data) {
    if (chunk < restored_.size() && restored_[chunk] == 0 &&
        decode_chunk(data, chunk_range(chunk, result_.sight.size()), result_)) {
      restored_[chunk] = 1;
      ++written_;
    }
  });
  if (written_ > 0) fmt::print(stderr, "going on from {}: {} of {} parts\n", file_->path(), written_, restored_.size());
}

void Checkpoint::finished(std::size_t chunk) {
  if (!file_) return;
  {
    const std::lock_guard lock(noting_);
    pending_.push_back(static_cast<std::uint32_t>(chunk));
  }
  const std::unique_lock lock(writing_, std::try_to_lock);  // while one thread writes, the others go on
  if (lock.owns_lock() && is_due()) write_pending();
}

void Checkpoint::complete() {
  const std::lock_guard lock(writing_);
  if (file_ && (written_ > 0 || is_due())) write_pending();
  pending_.clear();  // the next steps change the results in place
}

std::string Checkpoint::interrupted() {
  const std::lock_guard lock(writing_);
  write_pending();
  if (written_ == 0) return "interrupted; nothing was written";
  return fmt::format("interrupted; {} holds {} of {} parts, and the same command goes on from there", file_->path(),
                     written_, restored_.size());
}

void Checkpoint::write_pending() {
  std::vector<std::uint32_t> chunks;
  {
    const std::lock_guard lock(noting_);
    std::swap(chunks, pending_);
  }
  for (const std::uint32_t chunk : chunks) {
    file_->append(chunk, encode_chunk(result_, chunk_range(chunk, result_.sight.size())));
    ++written_;
  }
  last_write_ = Clock::now();
}

}  // namespace sh::prt
