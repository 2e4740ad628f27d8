// How bakes grow with the number of receivers: growth_bench [FILE.svg [MOST [MODEL]]]. A generated city of houses and copies of a
// sculpture on a ground, of 10^4 receivers and more, three sizes a decade, up to MOST (10^6); or copies of a model, from one on. Each bake is a process of its own,
// `prt bake` of the same build, so that its memory is its own. A kind ends where the next size would take more than the
// memory of the machine, or ten minutes of the processor. Prints processor time, memory and bytes, and draws them. Takes minutes.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/chart.hpp"
#include "prt/bake/estimate.hpp"
#include "tests/bench/city.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using sh::bench::Cost;
using sh::bench::run;
using sh::bench::write_city;
using sh::bench::write_copies;

constexpr double kFewest = 1e4;       // receivers
constexpr double kMostSeconds = 600;  // of the processor
const std::vector<std::pair<std::string, std::vector<std::string>>> kBakes = {
    {"DS", {"--kind", "shadowed"}},
    {"DI", {"--kind", "interreflected"}},
    {"DI, 64 directions for bounces", {"--kind", "interreflected", "--bounce-directions", "64"}},
    {"GS", {"--kind", "glossy_shadowed"}}};

// Whether what was measured last would be more than `most` if it grew in proportion.
bool is_too_much(const std::vector<sh::output::ChartPoint>& measured, double receivers, double most) {
  return !measured.empty() && measured.back().y / measured.back().x * receivers > most;
}

void measure(const std::string& picture, double most, const std::string& model) {
  const sh::test::TemporaryFolder folder;
  const std::string scene = folder.file("city.json");
  const std::string out = folder.file("city.transfer");
  sh::output::Chart chart{
      .title = (model.empty() ? "A city" : "Copies of a model") + std::string(": memory and processor time of bakes"),
      .x = {"receivers"},
      .y = {"MiB of memory (lines), seconds of the processor (dashes)"},
      .series = {},
      .width = 640,
      .height = 420,
      .legend = true};
  for (std::size_t k = 0; k < kBakes.size(); ++k) {
    const auto& [name, words] = kBakes[k];
    chart.series.push_back({.name = name, .color = static_cast<int>(k), .line = sh::output::Line::kStraight});
    chart.series.push_back({.name = {},
                            .color = static_cast<int>(k),
                            .filled = false,
                            .line = sh::output::Line::kStraight,
                            .dashed = true});
  }
  fmt::print("{:>10} {:<30} {:>8} {:>12} {:>8} {:>10} {:>10}\n", "receivers", "bake", "s", "us/receiver", "MiB",
             "B/receiver", "B in file");
  const double fewest = model.empty() ? kFewest : static_cast<double>(write_copies(scene, model, 1.0));
  for (double wanted = fewest; wanted <= most * 1.01; wanted *= std::cbrt(10.0)) {
    const std::size_t receivers = model.empty() ? write_city(scene, wanted) : write_copies(scene, model, wanted);
    const auto count = static_cast<double>(receivers);
    for (std::size_t k = 0; k < kBakes.size(); ++k) {
      if (is_too_much(chart.series[2 * k].points, count, sh::prt::memory_of_machine() / 1048576.0)) continue;
      if (is_too_much(chart.series[2 * k + 1].points, count, kMostSeconds)) continue;
      const std::string tool = std::string(SHFORGE_BIN_DIR) + "/prt";
      std::vector<std::string> words = {tool, "bake", scene, "--plan", "none", "--no-checkpoint", "-o", out};
      words.insert(words.end(), kBakes[k].second.begin(), kBakes[k].second.end());
      const Cost cost = run(words);
      fmt::print("{:>10} {:<30} {:>8.1f} {:>12.1f} {:>8.0f} {:>10.0f} {:>10.0f}\n", receivers, kBakes[k].first,
                 cost.seconds, 1e6 * cost.seconds / count, cost.bytes / 1048576.0, cost.bytes / count,
                 static_cast<double>(std::filesystem::file_size(out)) / count);
      std::fflush(stdout);
      chart.series[2 * k].points.push_back({count, cost.bytes / 1048576.0});
      chart.series[2 * k + 1].points.push_back({count, cost.seconds});
    }
  }
  if (!picture.empty()) sh::output::write_file(picture, sh::output::chart_file(chart));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const double most = argc > 2 ? std::strtod(argv[2], nullptr) : 1e6;
    if (argc > 4 || !(most >= kFewest)) {
      throw std::invalid_argument(
          fmt::format("expected a file and at least {:g} receivers: growth_bench [FILE.svg [MOST [MODEL]]]", kFewest));
    }
    measure(argc > 1 ? argv[1] : "", most, argc > 3 ? argv[3] : "");
  } catch (const std::exception& error) {
    fmt::print(stderr, "growth_bench: {}\n", error.what());
    return 2;
  }
  return 0;
}
