// Records which chunks of a bake are done and which are on disk, so that a stopped bake can continue. The checkpoint
// holds its key, which names everything that the results of rays depend on, and the results of each chunk of vertices:
//   transfer vectors: (vertices, bands^2) binary32; Sight of each vertex: (vertices, 3) binary32; with bounces, for each
//   vertex: 1 where its row of form factors is kept, else 0 (4 bytes); its length (4); its entries.
// The part of a shard is a checkpoint with the chunks of the shard and a record of its own, JSON that names the shard and the
// command that makes it.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/bake/checkpoint_file.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/chunks.hpp"
#include "prt/rays/gather.hpp"

namespace sh::prt {

/// References to the results of the rays.
struct ShadowResult {
  Transfer& transfer;        // its first vertices x bands^2 coefficients
  std::vector<Sight> sight;  // (vertices)
  FormFactors* factors;      // null if hits are not needed
};

/// A JSON object: counts and checksum of the mesh and of `open` (see Plan), kind, degree, directions, sampler, seed,
/// instruction set, and `points`, which describes receivers that are not the vertices. Albedo, tolerance and solver are
/// not in it: only the bounces use them, and rays do not depend on them.
std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open,
                     const std::string& points = {});

/// What the part of a shard says of itself. Throws std::runtime_error, one line with the file's name, if it is none.
struct ShardRecord {
  Shard shard;
  std::vector<std::string> command;
};
ShardRecord shard_of_part(const std::string& file);

/// Words as a line for a shell, quoted where they need it.
std::string shell_line(const std::vector<std::string>& words);

class Checkpoint {
 public:
  /// Loads the chunks of the file, or of the parts, into `result`, which must outlive this object. Throws like
  /// CheckpointFile; and, one line with what is to be done, for parts of which one is missing or there twice.
  Checkpoint(const CheckpointSettings& settings, const std::string& key, ShadowResult& result);
  /// True if the chunk came from a file.
  [[nodiscard]] bool has(std::size_t chunk) const { return restored_[chunk] != 0; }
  /// True if the chunk is to be traced here.
  [[nodiscard]] bool wants(std::size_t chunk) const { return !has(chunk) && shard_.has(chunk); }
  /// Notes that the results of a chunk are complete, and writes all pending chunks if it is time. Any thread may call
  /// it. Throws std::runtime_error if writing fails.
  void finished(std::size_t chunk);
  /// Call it when all chunks are finished: writes the pending chunks, unless it is a whole bake that took no longer than
  /// `seconds`.
  void complete();
  /// Call it when the process is asked to end: writes the pending chunks. Returns one line that says what was kept and
  /// how to continue.
  std::string interrupted();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due() const { return Clock::now() - last_write_ >= interval_; }
  void write_pending();
  // The index of the record of a chunk.
  [[nodiscard]] std::uint32_t index_of(std::uint32_t chunk) const;
  // Loads the chunk of a record; false if it is of another channel, its bytes cannot be results, or it is there already.
  bool load(std::uint32_t index, std::string_view data);
  void load_parts(const std::vector<std::string>& parts, const std::string& key);

  ShadowResult& result_;
  Shard shard_;
  std::uint32_t channel_;
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
