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

// The bytes of a block, which a reader may fill.
template <class Numbers>
auto block_of(Numbers& panel, std::size_t block) {
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
  Panel kept_x(x.rows, x.columns);  // a file that lacks a block leaves x and r as they are
  Panel kept_r(x.rows, x.columns);
  std::optional<BounceState> state;
  std::vector<bool> has(2 * blocks_of(x), false);
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

std::optional<BounceState> BounceCheckpoint::load(Panel& x, Panel& r) const {
  if (settings_.path.empty()) return std::nullopt;
  std::optional<BounceState> state;
  if (ranks_.is_first()) state = read(x, r);
  if (ranks_.count < 2) return state;
  std::array<double, 4> head{};
  if (state) head = {1.0, static_cast<double>(state->phase), static_cast<double>(state->applications), state->before};
  ranks_.broadcast(head.data(), head.size(), 0);
  if (head[0] == 0.0) return std::nullopt;
  ranks_.broadcast(x.values.data(), x.values.size(), 0);
  ranks_.broadcast(r.values.data(), r.values.size(), 0);
  return BounceState{static_cast<BounceState::Phase>(static_cast<std::uint32_t>(head[1])),
                     static_cast<std::uint32_t>(head[2]), head[3]};
}

void BounceCheckpoint::keep(const BounceState& state, const Panel& x, const Panel& r) {
  if (settings_.path.empty() || !ranks_.is_first()) return;
  const auto seconds = std::chrono::duration<double>(settings_.seconds);
  if (Clock::now() - last_ < std::max(std::chrono::duration_cast<Clock::duration>(seconds), kLittle * cost_)) return;
  const Clock::time_point began = Clock::now();
  const std::string next = next_to(settings_.path);
  {
    CheckpointFile file(next, key_, true);
    const Head head{static_cast<std::uint32_t>(state.phase), state.applications, state.before};
    file.append(0, {reinterpret_cast<const char*>(&head), sizeof head});
    for (std::size_t place = 0; place < 2 * blocks_of(x); ++place) {
      const auto [numbers, bytes] = block_of(place % 2 == 0 ? x : r, place / 2);
      file.append(static_cast<std::uint32_t>(place + 1), {reinterpret_cast<const char*>(numbers), bytes});
    }
  }
  std::error_code error;
  std::filesystem::rename(next, settings_.path, error);
  if (error) output::fail_by(error.value(), settings_.path + ": cannot write: " + error.message());
  last_ = Clock::now();
  cost_ = last_ - began;
}

}  // namespace sh::prt
