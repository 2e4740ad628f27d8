#include "prt/bake/checkpoint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "prt/transfer/checksum.hpp"

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

template <class T>
std::uint64_t checksum_of(const std::vector<T>& values) {
  return checksum(values.data(), values.size() * sizeof(T));
}

// A new member of Mesh does not compile here until somebody decides whether rays depend on it.
std::string mesh_checksum(const Mesh& mesh) {
  [[maybe_unused]] const auto& [positions, normals, geometric_normals, albedo, emission, mirror, specular, exponent,
                                brdf, texture, normal_map, albedo_map, tint, chart, atlas, faces, remap, brdfs,
                                normal_maps, albedo_maps, atlases, frame] = mesh;
  const std::array<std::uint64_t, 6> parts = {
      checksum_of(positions), checksum_of(normals), checksum_of(geometric_normals),
      checksum_of(mirror),    checksum_of(faces),   checksum_of(atlases.reach)};
  return fmt::format("{:016x}", checksum(parts.data(), sizeof parts));
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

}  // namespace

std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open,
                     const std::string& points) {
  [[maybe_unused]] const auto& [degree, directions, sampler, seed, kind, bounces, keep, compress, by_plan, fit_lobes] =
      scene.bake;  // as above
  nlohmann::ordered_json key = {{"vertices", scene.mesh.positions.size()},
                                {"faces", scene.mesh.faces.size()},
                                {"mesh", mesh_checksum(scene.mesh)},
                                {"open_vertices", std::count(open.begin(), open.end(), 1)},
                                {"open", fmt::format("{:016x}", checksum_of(open))},
                                {"transfer", kind->word},
                                {"degree", degree},
                                {"directions", directions},
                                {"sampler", name_of(sampler)},
                                {"seed", seed},
                                {"instruction_set", instruction_set}};
  if (!points.empty()) key["points"] = points;
  return key.dump();
}

Checkpoint::Checkpoint(const CheckpointSettings& settings, const std::string& key, ShadowResult& result)
    : result_(result),
      restored_(chunk_count(result.sight.size()), 0),
      interval_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.seconds))) {
  if (!settings.path.empty()) {
    file_.emplace(settings.path, key, settings.restart);
    file_->read([&](std::uint32_t chunk, std::string_view data) {
      if (chunk < restored_.size() && restored_[chunk] == 0 &&
          decode_chunk(data, chunk_range(chunk, result.sight.size()), result)) {
        restored_[chunk] = 1;
        ++written_;
      }
    });
  }
  if (written_ > 0) fmt::print(stderr, "going on from {}: {} of {} parts\n", file_->path(), written_, restored_.size());
  last_write_ = Clock::now();
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
