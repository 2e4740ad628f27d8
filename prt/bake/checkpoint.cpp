#include "prt/bake/checkpoint.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "numeric/output/parse_json.hpp"
#include "prt/mesh/mesh_checksum.hpp"
#include "prt/say.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/whole_number.hpp"

namespace sh::prt {

namespace {

template <class T>
void put(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

// Takes values off the front of the data; false if there are too few.
template <class T>
bool take(std::string_view& data, T* values, std::size_t count) {
  if (data.size() / sizeof(T) < count) return false;
  if (count > 0) std::memcpy(values, data.data(), count * sizeof(T));
  data.remove_prefix(count * sizeof(T));
  return true;
}

struct RowHead {
  std::uint32_t kept = 0;
  std::uint32_t length = 0;
};

constexpr float kMostOfHemisphere = 2.0F;  // with few directions, the cosines of a hemisphere do not sum to 1

// Whether the entries are what prt/bake/form_factors.hpp says of a row.
bool is_row(const FormFactorRow& row, std::size_t vertices) {
  constexpr double kLeast = -1e-6;  // rounding of barycentric coordinates
  double sum = 0.0;
  for (const FormFactor& entry : row) {
    const double weight = entry.weight;
    if (entry.vertex >= vertices || !(weight >= kLeast)) return false;
    sum += weight;
  }
  return sum <= static_cast<double>(kMostOfHemisphere);
}

bool take_row(std::string_view& data, std::size_t vertices, FormFactorRow& row, RowHead& head) {
  if (!take(data, &head, 1) || head.kept > 1 || data.size() / sizeof(FormFactor) < head.length) return false;
  row.resize(head.length);
  return take(data, row.data(), row.size()) && is_row(row, vertices);
}

// The same for a row that another process keeps and checks.
bool skip_row(std::string_view& data) {
  RowHead head;
  if (!take(data, &head, 1) || data.size() / sizeof(FormFactor) < head.length) return false;
  data.remove_prefix(head.length * sizeof(FormFactor));
  return true;
}

std::string encode_chunk(const ShadowResult& result, const VertexRange& range) {
  const std::size_t count = result.transfer.shape.length();
  std::string bytes;
  put(bytes, result.transfer.coefficients.data() + range.first * count, range.size() * count);
  put(bytes, result.sight.data() + range.first, range.size());
  for (std::size_t v = range.first; result.factors != nullptr && v < range.last; ++v) {
    const FormFactorRow& row = result.factors->row(v);
    const RowHead head{result.factors->is_kept(v) ? 1U : 0U, static_cast<std::uint32_t>(row.size())};
    put(bytes, &head, 1);
    put(bytes, row.data(), row.size());
  }
  return bytes;
}

bool is_possible(const Sight& sight) {
  const auto is_part = [](float part) { return part >= 0.0F && part <= 1.0F; };
  return sight.visible >= 0.0F && sight.visible <= kMostOfHemisphere && is_part(sight.buried) && is_part(sight.covered);
}

bool are_results(const std::vector<float>& transfer, const std::vector<Sight>& sight) {
  return std::all_of(transfer.begin(), transfer.end(), [](float value) { return std::isfinite(value); }) &&
         std::all_of(sight.begin(), sight.end(), is_possible);
}

// Returns false, and changes no finished result, if the data do not have the shape of the chunk or cannot be results of
// rays, whatever their checksum.
bool decode_chunk(std::string_view data, const VertexRange& range, ShadowResult& result) {
  const std::size_t count = result.transfer.shape.length();
  std::vector<float> transfer(range.size() * count);
  std::vector<Sight> sight(range.size());
  if (!take(data, transfer.data(), transfer.size()) || !take(data, sight.data(), sight.size()) ||
      !are_results(transfer, sight)) {
    return false;
  }
  std::vector<std::pair<std::size_t, FormFactorRow>> rows;
  for (std::size_t v = range.first; result.factors != nullptr && v < range.last; ++v) {
    if (!result.factors->ranks().owns(v)) {
      if (!skip_row(data)) return false;
      continue;
    }
    FormFactorRow row;
    RowHead head;
    if (!take_row(data, result.sight.size(), row, head)) return false;
    if (head.kept != 0) rows.emplace_back(v, std::move(row));
  }
  if (!data.empty()) return false;
  std::copy(transfer.begin(), transfer.end(), result.transfer.coefficients.data() + range.first * count);
  std::copy(sight.begin(), sight.end(), result.sight.data() + range.first);
  for (auto& [vertex, row] : rows) result.factors->keep(vertex, std::move(row));
  return true;
}

// The index of the record of a shard, which no chunk has.
constexpr std::uint32_t kShardRecord = 0xFFFFFFFFU;

std::string to_json(const CheckpointSettings& settings) {
  const nlohmann::ordered_json json = {
      {"shard", settings.shard.index + 1}, {"shards", settings.shard.count}, {"command", settings.command}};
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

[[noreturn]] void refuse_part(const std::string& file) {
  throw std::runtime_error(fmt::format("{}: no part of a bake; expected a part that `--shard` made", file));
}

ShardRecord record_from(const std::string& file, std::string_view data) {
  try {
    const auto json = output::parse_json<nlohmann::ordered_json>(std::string(data));
    const auto index = whole_number<std::uint32_t>(json.at("shard"), "shard");
    const auto count = whole_number<std::uint32_t>(json.at("shards"), "shards");
    if (index >= 1 && index <= count && count >= 2 && count <= kMostShards) {
      return {{index - 1, count}, json.at("command").get<std::vector<std::string>>()};
    }
  } catch (const std::exception&) {  // of the wrong type, or none
  }
  throw std::runtime_error(fmt::format("{}: damaged: the record of its shard cannot be read", file));
}

// A file holds one shard.
void require_same(const CheckpointSettings& settings, const Shard& found) {
  if (settings.shard.index == found.index && settings.shard.count == found.count) return;
  throw std::runtime_error(fmt::format("{}: holds shard {}/{}; expected another output for shard {}/{}, or --restart",
                                       settings.path, found.index + 1, found.count, settings.shard.index + 1,
                                       settings.shard.count));
}

}  // namespace

std::string shell_line(const std::vector<std::string>& words) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+@%-";
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

ShardRecord shard_of_part(const std::string& file) {
  std::optional<ShardRecord> found;
  CheckpointFile::of_any_bake(file).read([&](std::uint32_t chunk, std::string_view data) {
    if (chunk == kShardRecord) found = record_from(file, data);
  });
  if (!found) refuse_part(file);
  return *found;
}

std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open,
                     const std::string& points) {
  [[maybe_unused]] const auto& [degree, directions, sampler, seed, kind, bounces, keep, compress, by_plan, fit_lobes] =
      scene.bake;  // a new one does not compile here until somebody decides, too
  nlohmann::ordered_json key = {{"vertices", scene.mesh.positions.size()},
                                {"faces", scene.mesh.faces.size()},
                                {"mesh", checksums_of(scene.mesh).rays},
                                {"open_vertices", std::count(open.begin(), open.end(), 1)},
                                {"open", checksum_text(checksum_of(open))},
                                {"transfer", kind->word},
                                {"degree", degree},
                                {"directions", directions},
                                {"sampler", name_of(sampler)},
                                {"seed", seed},
                                {"instruction_set", instruction_set}};
  if (const int fewer = scene.bake.fewer_for_bounces(); fewer > 0) key["bounce_directions"] = fewer;
  if (const Halving& halving = scene.mesh.halving; !halving.empty()) {
    key["cut_faces"] = halving.faces.size();
    key["cuts"] = halving.cuts.size();
  }
  if (!points.empty()) key["points"] = points;
  return key.dump();
}

Checkpoint::Checkpoint(const CheckpointSettings& settings, const std::string& key, ShadowResult& result)
    : result_(result),
      shard_(settings.shard),
      channel_(settings.channel),
      restored_(chunk_count(result.sight.size()), 0),
      interval_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.seconds))) {
  if (!settings.parts.empty()) {
    load_parts(settings.parts, key);
    return;
  }
  bool is_named = false;
  if (!settings.path.empty()) {
    file_.emplace(settings.path, key, settings.restart);
    file_->read([&](std::uint32_t chunk, std::string_view data) {
      if (chunk == kShardRecord && !shard_.is_whole()) {
        is_named = true;
        require_same(settings, record_from(settings.path, data).shard);
      }
      written_ += load(chunk, data) ? 1 : 0;
    });
  }
  if (written_ > 0) say(fmt::format("going on from {}: {} of {} parts", file_->path(), written_, restored_.size()));
  if (file_ && !shard_.is_whole() && !is_named) file_->append(kShardRecord, to_json(settings));
  last_write_ = Clock::now();
}

std::uint32_t Checkpoint::index_of(std::uint32_t chunk) const {
  return channel_ * static_cast<std::uint32_t>(restored_.size()) + chunk;
}

bool Checkpoint::load(std::uint32_t index, std::string_view data) {
  const std::uint32_t chunk = index - index_of(0);
  if (index < index_of(0) || chunk >= restored_.size() || restored_[chunk] != 0 ||
      !decode_chunk(data, chunk_range(chunk, result_.sight.size()), result_)) {
    return false;
  }
  restored_[chunk] = 1;
  return true;
}

void Checkpoint::load_parts(const std::vector<std::string>& parts, const std::string& key) {
  std::map<std::uint32_t, ShardRecord> known;  // by the index of the shard
  std::map<std::uint32_t, std::string> files;
  for (const std::string& part : parts) {
    std::optional<ShardRecord> record;
    CheckpointFile::for_reading(part, key).read([&](std::uint32_t chunk, std::string_view data) {
      if (chunk == kShardRecord) {
        record = record_from(part, data);
      } else {
        load(chunk, data);
      }
    });
    if (!record) refuse_part(part);
    const Shard& shard = record->shard;
    if (!known.empty() && known.begin()->second.shard.count != shard.count) {
      throw std::runtime_error(fmt::format("{}: shard {} of {}, but {} is one of {}; expected the parts of one bake",
                                           part, shard.index + 1, shard.count, files.begin()->second,
                                           known.begin()->second.shard.count));
    }
    if (const auto twice = files.find(shard.index); twice != files.end()) {
      throw std::runtime_error(fmt::format("{}: shard {} of {}, as {} is; expected each once", part, shard.index + 1,
                                           shard.count, twice->second));
    }
    known[shard.index] = *record;
    files[shard.index] = part;
  }
  const std::uint32_t count = known.begin()->second.shard.count;
  std::set<std::uint32_t> missing;
  for (std::size_t chunk = 0; chunk < restored_.size(); ++chunk) {
    if (restored_[chunk] == 0) missing.insert(static_cast<std::uint32_t>(chunk % count));
  }
  if (missing.empty()) return;
  const std::uint32_t first = *missing.begin();
  const std::string file = files.count(first) != 0 ? shell_line({files[first]}) : std::string("FILE");
  std::vector<std::string> names;
  for (const std::uint32_t index : missing) names.push_back(fmt::format("{}/{}", index + 1, count));
  throw std::runtime_error(fmt::format(
      "{} of {} chunks of vertices are missing, those of {} {}; expected complete parts of all shards: run `prt {} "
      "--shard "
      "{} -o {}`",
      std::count(restored_.begin(), restored_.end(), 0), restored_.size(), names.size() == 1 ? "shard" : "the shards",
      fmt::join(names, ", "), shell_line(known.begin()->second.command), names.front(), file));
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
  if (file_ && (written_ > 0 || is_due() || !shard_.is_whole())) write_pending();
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
    file_->append(index_of(chunk), encode_chunk(result_, chunk_range(chunk, result_.sight.size())));
    ++written_;
  }
  last_write_ = Clock::now();
}

}  // namespace sh::prt
