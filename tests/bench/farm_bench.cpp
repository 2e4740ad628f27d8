// Bakes that several processes share, of a city of farm_bench [RECEIVERS], 100,000 by default: the processor time of shards
// against that of one bake, the merge against copying its files, bounces on ranks of MPI against one process, and the
// memory that a receiver takes. Every command is a process of its own, `prt` of the same build. Takes minutes. Exit 1 if a
// target is missed.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "prt/bake/estimate.hpp"
#include "prt/scene/scene.hpp"
#include "tests/bench/city.hpp"
#include "tests/bench/harness.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using sh::bench::Cost;
using sh::bench::run;
using sh::bench::Table;

constexpr int kShards = 8;
constexpr double kMiB = 1048576.0;

std::string tool() { return std::string(SHFORGE_BIN_DIR) + "/prt"; }

std::vector<std::string> bake_of(const std::string& scene, const std::vector<std::string>& more) {
  std::vector<std::string> words = {tool(), "bake", scene, "--plan", "none"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The parts of all shards, and what they took together.
struct Shards {
  std::vector<std::string> parts;
  double seconds = 0.0;
};

Shards bake_shards(const sh::test::TemporaryFolder& folder, const std::string& scene, int count,
                   const std::vector<std::string>& more) {
  Shards shards;
  for (int i = 1; i <= count; ++i) {
    shards.parts.push_back(folder.file(std::to_string(i) + "of" + std::to_string(count) + more.back()));
    std::vector<std::string> words = {"--shard", std::to_string(i) + "/" + std::to_string(count), "-o",
                                      shards.parts.back()};
    words.insert(words.end(), more.begin(), more.end());
    shards.seconds += run(bake_of(scene, words)).seconds;
  }
  return shards;
}

std::vector<std::string> merge_of(const Shards& shards, const std::string& out) {
  std::vector<std::string> words = {tool(), "merge"};
  words.insert(words.end(), shards.parts.begin(), shards.parts.end());
  words.insert(words.end(), {"-o", out, "--threads", "1"});
  return words;
}

void diffuse(Table& table, const sh::test::TemporaryFolder& folder, const std::string& scene, double receivers) {
  table.section("Shards of DS, 25 coefficients, 2,048 directions", "processor time of all of them against one bake");
  const std::string whole = folder.file("whole.transfer");
  const std::string merged = folder.file("merged.transfer");
  const Cost one = run(bake_of(scene, {"--no-checkpoint", "-o", whole, "--directions", "2048", "--kind", "shadowed"}));
  const Shards two = bake_shards(folder, scene, 2, {"--directions", "2048", "--kind", "shadowed"});
  const Shards many = bake_shards(folder, scene, kShards, {"--directions", "2048", "--kind", "shadowed"});
  table.ratio("2 shards", "s", two.seconds, one.seconds, "one bake", 1.03);
  table.ratio(std::to_string(kShards) + " shards", "s", many.seconds, one.seconds, "one bake", 1.03);
  // On paper: what every process repeats, from the difference between 8 shards and one bake, and the rest divided.
  const double repeated = std::max(0.0, (many.seconds - one.seconds) / (kShards - 1));
  constexpr double kProcesses = 1000.0;
  char line[160];
  std::snprintf(line, sizeof line, "on paper, 1,000 shards: %.2f s each, of which all repeat %.2f s; one bake %.1f s",
                repeated + (one.seconds - repeated) / kProcesses, repeated, one.seconds);
  table.remark(static_cast<const char*>(line));
  const Cost merge = run(merge_of(many, merged));
  const std::string parts = folder.file("*of" + std::to_string(kShards) + "shadowed");
  const std::string copy = folder.file("copy");
  const Cost copied = run({"sh", "-c", "cat " + parts + " > " + copy + " && sync " + copy});
  table.ratio("merge", "s", merge.elapsed, copied.elapsed, "copying its parts", 1.0);
  table.figure("memory of the merge", "MiB", merge.bytes / kMiB, 1024.0);
  run({"cmp", whole, merged});
  table.figure("memory of one bake, a receiver; 6 GiB for 10^7 are", "bytes", one.bytes / receivers,
               6.0 * 1024.0 * kMiB / 1e7);
}

void bounces(Table& table, const sh::test::TemporaryFolder& folder, const std::string& scene, double receivers) {
  table.section("Bounces of DI on ranks of MPI",
                "merges of the same parts, one thread each; half of one process is ideal");
  const Shards shards = bake_shards(folder, scene, 2, {"--kind", "interreflected"});
  const std::vector<std::string> words = merge_of(shards, folder.file("bounced.transfer"));
  const Cost one = run(words);
  const auto on_ranks = [&words](const std::string& count) {
    std::vector<std::string> line = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", count};
    line.insert(line.end(), words.begin(), words.end());
    return run(line);
  };
  const Cost two = on_ranks("2");
  table.ratio("2 ranks", "s", two.elapsed, 0.5 * one.elapsed, "half of one", 1.1);
  table.ratio("memory of a rank of 2", "MiB", two.bytes / kMiB, one.bytes / kMiB, "one", 0.6);
  table.ratio("memory of a rank of 4", "MiB", on_ranks("4").bytes / kMiB, one.bytes / kMiB, "one", 0.4);
  sh::prt::Scene loaded = sh::prt::load_scene(scene, sh::prt::OnFlaw::kMend);
  loaded.bake.kind = &sh::prt::kInterreflected;
  loaded.bake.bounces.directions = 64;
  const auto factors = static_cast<double>(sh::prt::estimate_bake({std::move(loaded), {}}).factor_bytes);
  table.figure("form factors along 64 directions, a receiver", "bytes", factors / receivers, 1536.0);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const double wanted = argc > 1 ? std::strtod(argv[1], nullptr) : 1e5;
    if (argc > 2 || !(wanted >= 1e4))
      throw std::invalid_argument("expected at least 10000 receivers: farm_bench [RECEIVERS]");
    const sh::test::TemporaryFolder folder;
    const std::string scene = folder.file("city.json");
    const auto receivers = static_cast<double>(sh::bench::write_city(scene, wanted));
    Table table;
    table.remark(std::to_string(static_cast<long>(receivers)) + " receivers");
    diffuse(table, folder, scene, receivers);
    bounces(table, folder, scene, receivers);
    return table.summary() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "farm_bench: %s\n", error.what());
    return 2;
  }
}
