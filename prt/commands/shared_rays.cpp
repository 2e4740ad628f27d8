#include "prt/commands/shared_rays.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "prt/bake/bounce_checkpoint.hpp"
#include "prt/commands/scene_options.hpp"

namespace sh::prt {

namespace {

// I/N, from 1 on.
Shard shard_named(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool is_pair = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = is_pair ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!is_pair || count.ec != std::errc() || count.ptr != end || shard.count < 2 || shard.count > kMostShards ||
      shard.index < 1 || shard.index > shard.count) {
    throw std::invalid_argument(
        fmt::format("--shard {}: expected I/N, with N from 2 to {} and I from 1 to N", text, kMostShards));
  }
  --shard.index;
  return shard;
}

}  // namespace

void SharedOptions::add_to(CLI::App& app) {
  CheckpointOptions::add_to(app);
  app.add_option("--shard", shard, "I/N: trace the I-th of N parts of the rays into the output, for `prt merge`")
      ->excludes("--checkpoint")
      ->excludes("--no-checkpoint");
  app.add_option("--parts", parts, "the parts of all shards, in place of tracing (`prt merge` gives them)")
      ->default_str("")
      ->excludes("--shard")
      ->excludes("--checkpoint");
}

CheckpointSettings SharedOptions::settings(const std::string& output) const {
  if (!shard.empty()) {
    return {.path = output, .restart = restart, .seconds = seconds, .shard = shard_named(shard), .command = command};
  }
  if (parts.empty()) return CheckpointOptions::settings(output);
  const bool is_special = std::filesystem::exists(output) && !std::filesystem::is_regular_file(output);
  return {.path = {}, .parts = parts, .bounces = is_special ? std::string() : bounces_beside(output)};
}

std::vector<std::string> SharedOptions::given() const {
  std::vector<std::string> names;
  if (!file.empty()) names.emplace_back("--checkpoint");
  if (restart) names.emplace_back("--restart");
  if (!shard.empty()) names.emplace_back("--shard");
  if (!parts.empty()) names.emplace_back("--parts");
  return names;
}

std::vector<std::string> words_for_parts(const CLI::App& command) {
  return words_without(command, {"--shard", "--output", "--threads", "--restart", "--checkpoint-seconds", "--scratch"});
}

}  // namespace sh::prt
