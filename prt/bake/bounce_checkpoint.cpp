#include "prt/bake/bounce_checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "numeric/output/machine_error.hpp"
#include "prt/bake/checkpoint_file.hpp"
#include "prt/transfer/checksum.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kRowsABlock = 4096;
constexpr int kLittle = 20;  // writing takes at most one part in so many of the time

std::size_t blocks_of(const Panel& panel) { return (panel.rows + kRowsABlock - 1) / kRowsABlock; }

// The bytes of a block.
std::pair<double*, std::size_t> block_of(Panel& panel, std::size_t block) {
  const std::size_t first = std::min(panel.rows, block * kRowsABlock);
  const std::size_t last = std::min(panel.rows, first + kRowsABlock);
  return std::pair{panel.row(first), (last - first) * panel.columns * sizeof(double)};
}

struct Head {
  std::uint32_t phase;
  std::uint32_t applications;
  double before;
};
static_assert(sizeof(Head) == 16);

// The rows first .. last - 1.
void fetch(const Panel& x, std::size_t first, std::size_t last, double* to) {
  std::copy(x.row(first), x.row(last), to);
}
void fetch(const OwnRows& x, std::size_t first, std::size_t last, double* to) { x.gather(first, last, to); }

// Where a state is written before it replaces the last one.
std::string next_to(const std::string& path) { return path + ".new"; }

}  // namespace

void remove_bounces(const std::string& path) {
  for (const std::string& file : {path, next_to(path)}) std::filesystem::remove(file);
}

std::string bounce_key(const std::string& bake_key, const BounceOptions& options,
                       const std::vector<Eigen::Vector3f>& albedo, const Panel& light) {
  auto key = nlohmann::ordered_json::parse(bake_key);
  key["solver"] = static_cast<int>(options.solver);
  key["tolerance"] = options.tolerance;
  key["bounce_directions"] = options.directions;
  key["albedo"] = checksum(albedo.data(), albedo.size() * sizeof(Eigen::Vector3f));
  key["light"] = checksum(light.values.data(), light.values.size() * sizeof(double));
  return key.dump();
}

std::optional<BounceState> BounceCheckpoint::read(Panel& x, Panel& r) const {
  const auto opened = [&] {
    try {
      return CheckpointFile(settings_.path, key_, settings_.restart);
    } catch (const output::MachineError&) {
      throw;
    } catch (const std::runtime_error&) {
      return CheckpointFile(settings_.path, key_, true);  // deletes the iterate of another system only
    }
  };
  CheckpointFile file = opened();
  if (!file.exists()) return std::nullopt;
  Panel kept_x(r.rows, r.columns);  // a file that lacks a block leaves x and r as they are
  Panel kept_r(r.rows, r.columns);
  std::optional<BounceState> state;
  std::vector<bool> has(2 * blocks_of(r), false);
  file.read([&](std::uint32_t index, std::string_view data) {
    if (index == 0) {
      Head head{};
      if (data.size() != sizeof head) return;
      std::memcpy(&head, data.data(), sizeof head);
      if (head.phase > 1) return;
      state = BounceState{static_cast<BounceState::Phase>(head.phase), head.applications, head.before};
      return;
    }
    const std::size_t place = index - 1;
    if (place >= has.size()) return;
    const auto [numbers, bytes] = block_of(place % 2 == 0 ? kept_x : kept_r, place / 2);
    if (data.size() != bytes) return;
    std::memcpy(numbers, data.data(), bytes);
    has[place] = true;
  });
  if (!state || std::find(has.begin(), has.end(), false) != has.end()) return std::nullopt;
  x = std::move(kept_x);
  r = std::move(kept_r);
  return state;
}

std::optional<BounceState> BounceCheckpoint::load(OwnRows& x, Panel& r) const {
  if (settings_.path.empty()) return std::nullopt;
  Panel all_x(0, r.columns);
  std::optional<BounceState> state;
  if (ranks_.is_first()) state = read(all_x, r);
  std::array<double, 4> head{};
  if (state) head = {1.0, static_cast<double>(state->phase), static_cast<double>(state->applications), state->before};
  tell(head.data(), head.size());
  if (head[0] == 0.0) return std::nullopt;
  std::vector<double> rows(Ranks::kRowsAtOnce * r.columns);
  for (std::size_t first = 0; first < r.rows; first += Ranks::kRowsAtOnce) {
    const std::size_t size = (std::min(r.rows, first + Ranks::kRowsAtOnce) - first) * r.columns;
    tell(r.row(first), size);
    if (ranks_.is_first()) std::copy_n(all_x.row(first), size, rows.data());
    tell(rows.data(), size);
    if (ranks_.owns(first)) std::copy_n(rows.data(), size, x.row(first));
  }
  return BounceState{static_cast<BounceState::Phase>(static_cast<std::uint32_t>(head[1])),
                     static_cast<std::uint32_t>(head[2]), head[3]};
}

bool BounceCheckpoint::is_time() const {
  const auto seconds = std::chrono::duration<double>(settings_.seconds);
  const auto least = std::max(std::chrono::duration_cast<Clock::duration>(seconds), kLittle * cost_);
  double is_time = !settings_.path.empty() && Clock::now() - last_ >= least ? 1.0 : 0.0;
  tell(&is_time, 1);
  return is_time != 0.0;
}

template <class R>
void BounceCheckpoint::keep(const BounceState& state, const OwnRows& x, const R& r) {
  if (settings_.path.empty() || !is_time()) return;
  const Clock::time_point began = Clock::now();
  const std::string next = next_to(settings_.path);
  {
    std::optional<CheckpointFile> file;
    const auto append = [&](std::size_t place, const void* data, std::size_t bytes) {
      if (file) file->append(static_cast<std::uint32_t>(place), {static_cast<const char*>(data), bytes});
    };
    if (ranks_.is_first()) file.emplace(next, key_, true);
    const Head head{static_cast<std::uint32_t>(state.phase), state.applications, state.before};
    append(0, &head, sizeof head);
    std::vector<double> rows(kRowsABlock * x.columns());
    std::size_t place = 1;
    for (std::size_t first = 0; first < x.rows(); first += kRowsABlock) {
      const std::size_t last = std::min(x.rows(), first + kRowsABlock);
      const auto append_rows = [&](const auto& panel) {
        fetch(panel, first, last, rows.data());
        append(place++, rows.data(), (last - first) * x.columns() * sizeof(double));
      };
      append_rows(x);
      append_rows(r);
    }
  }
  if (ranks_.is_first()) {
    std::error_code error;
    std::filesystem::rename(next, settings_.path, error);
    if (error) output::fail_by(error.value(), settings_.path + ": cannot write: " + error.message());
  }
  last_ = Clock::now();
  cost_ = last_ - began;
}

template void BounceCheckpoint::keep(const BounceState& state, const OwnRows& x, const Panel& r);
template void BounceCheckpoint::keep(const BounceState& state, const OwnRows& x, const OwnRows& r);

}  // namespace sh::prt
