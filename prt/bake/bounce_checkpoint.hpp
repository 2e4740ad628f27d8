// Keeps the iterate of the solver of bounces on disk, so that a stopped solver goes on from there. It then has the same
// bits as one that was never stopped: states are kept only where the solver reads nothing else.
//
// The file is a checkpoint (prt/bake/checkpoint_file.hpp). Record 0: the phase (4 bytes: 0 series, 1 Krylov), the count of
// applications (4), the excess before (binary64). Then blocks of rows of the iterate and of its residual by turns,
// binary64. A new state is written beside it and renamed.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "prt/bake/form_factors.hpp"
#include "prt/bake/ranks.hpp"
#include "prt/scene/options.hpp"

namespace sh::prt {

/// What the solver knows besides the iterate and its residual.
struct BounceState {
  enum class Phase : std::uint32_t { kSeries = 0, kKrylov = 1 };
  Phase phase = Phase::kSeries;
  std::uint32_t applications = 0;
  double before = 0.0;  // of the series: the excess of the term before
};

struct BounceCheckpointSettings {
  std::string path;      // empty: none
  bool restart = false;  // an existing file is deleted
  double seconds = 2.0;  // the most work that is lost, unless writing takes more than a twentieth of it
};

/// The file beside a checkpoint or an output.
inline std::string bounces_beside(const std::string& file) { return file + ".bounces"; }

/// Removes the file, and one that was being written, if they are there.
void remove_bounces(const std::string& path);

/// A JSON object of everything that the iterates depend on: `bake_key` (checkpoint.hpp), how the system is solved, the albedo
/// (vertices), and the light without bounces.
std::string bounce_key(const std::string& bake_key, const BounceOptions& options,
                       const std::vector<Eigen::Vector3f>& albedo, const Panel& light);

class BounceCheckpoint {
 public:
  /// `key`: a JSON object of everything that the iterates depend on. Rank 0 reads and writes.
  BounceCheckpoint(BounceCheckpointSettings settings, std::string key, const Ranks& ranks)
      : settings_(std::move(settings)), key_(std::move(key)), ranks_(ranks), last_(Clock::now()) {}

  /// The kept state, its iterate and residual in x and r; nothing if there is none, or that of another system. All ranks
  /// call it. Throws std::runtime_error, one line with the file's name, if the file is none of this format.
  std::optional<BounceState> load(OwnRows& x, Panel& r) const;
  /// Writes the state if it is time; all ranks call it. R: Panel or OwnRows. Throws std::runtime_error if writing fails.
  template <class R>
  void keep(const BounceState& state, const OwnRows& x, const R& r);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::optional<BounceState> read(Panel& x, Panel& r) const;
  [[nodiscard]] bool is_time() const;
  // What rank 0 knows, to all ranks.
  void tell(double* values, std::size_t size) const {
    if (ranks_.count > 1) ranks_.broadcast(values, size, 0);
  }

  BounceCheckpointSettings settings_;
  std::string key_;
  const Ranks& ranks_;
  Clock::time_point last_;
  Clock::duration cost_{};  // of the last write
};

}  // namespace sh::prt
