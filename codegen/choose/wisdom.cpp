#include "codegen/choose/wisdom.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "codegen/output/output_tree.hpp"

namespace sh::codegen {
namespace {

constexpr const char* kHead =
    "# How long each recipe takes: family, degree, recipe, ns a call, ns a lane (float, one core).\n"
    "# Written by `shgen tune`; `shgen write` picks the fastest recipes from it and its siblings.\n";
constexpr const char* kMachine = "# Measured on: ";

}  // namespace

Wisdom Wisdom::read(const std::filesystem::path& file) {
  Wisdom wisdom;
  std::ifstream stream(file);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.rfind(kMachine, 0) == 0) wisdom.machine_ = line.substr(std::string(kMachine).size());
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string family;
    std::string recipe;
    int degree = 0;
    Timing timing;
    if (!(words >> family >> degree >> recipe >> timing.call >> timing.lane) || timing.call <= 0) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) +
                               ": not a measurement: expected family degree recipe ns-per-call ns-per-lane");
    }
    wisdom.set(family, degree, recipe, timing);
  }
  return wisdom;
}

void Wisdom::set(const std::string& family, int degree, const std::string& recipe, Timing timing) {
  timings_[{family, degree, recipe}] = timing;
}

std::optional<Timing> Wisdom::find(const std::string& family, int degree, const std::string& recipe) const {
  const auto found = timings_.find({family, degree, recipe});
  return found == timings_.end() ? std::nullopt : std::optional(found->second);
}

std::string Wisdom::to_string() const {
  std::string text = kHead + (machine_.empty() ? "" : kMachine + machine_ + "\n");
  for (const auto& [key, timing] : timings_) {
    const auto& [family, degree, recipe] = key;
    text += fmt::format("{} {} {} {:.3g} {:.3g}\n", family, degree, recipe, timing.call, timing.lane);
  }
  return text;
}

std::filesystem::path wisdom_folder() { return installed_or("share/shforge/wisdom", SHFORGE_WISDOM); }

const std::map<std::string, Wisdom>& committed_wisdom() {
  static const std::map<std::string, Wisdom> kMachines = [] {
    std::map<std::string, Wisdom> machines;
    if (!std::filesystem::is_directory(wisdom_folder())) return machines;
    for (const auto& entry : std::filesystem::directory_iterator(wisdom_folder())) {
      if (entry.path().extension() == ".txt") machines[entry.path().stem().string()] = Wisdom::read(entry.path());
    }
    return machines;
  }();
  return kMachines;
}

std::vector<double> mean_slowdowns(const std::map<std::string, Wisdom>& machines, const std::string& family, int degree,
                                   const std::vector<std::string>& recipes) {
  std::vector<double> sums;  // of logarithms
  int counted = 0;
  for (const auto& [name, wisdom] : machines) {
    std::vector<double> times;
    for (const std::string& recipe : recipes) {
      if (const std::optional<Timing> timing = wisdom.find(family, degree, recipe)) times.push_back(timing->call);
    }
    if (times.empty() || times.size() != recipes.size()) continue;
    const double least = *std::min_element(times.begin(), times.end());
    sums.resize(recipes.size());
    for (std::size_t i = 0; i < times.size(); ++i) sums[i] += std::log(times[i] / least);
    ++counted;
  }
  for (double& sum : sums) sum = std::exp(sum / counted);
  return sums;
}

}  // namespace sh::codegen
