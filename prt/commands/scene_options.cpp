#include "prt/commands/scene_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "prt/plan/plan.hpp"
#include "prt/rays/directions.hpp"

namespace sh::prt {

namespace {

template <class Names>
CLI::IsMember words(const Names& names) {
  return CLI::IsMember(std::vector<std::string>(std::begin(names), std::end(names)));
}

}  // namespace

void DirectionOptions::add_to(CLI::App& command) {
  command
      .add_option(
          "SCENE", scene,
          "a scene's JSON file, `demo`, the embedded scene, or a mesh file alone (.gltf, .obj, ...), which gets a "
          "ground and the overcast sky")
      ->required();
  command.add_option("--degree", degree, "SH degree, 0 to 10, instead of the scene's");
  command.add_option("--directions", directions, "directions over the whole sphere, instead of the scene's");
  command.add_option("--sampler", sampler, "method that chooses the directions, instead of the scene's")
      ->check(words(kSamplerNames));
  command.add_option("--seed", seed, "seed of all samplers except fibonacci, instead of the scene's")
      ->check(CLI::Range(0, kMaxSeed));
}

void DirectionOptions::apply_to(BakeOptions& bake) const {
  bake.degree = degree.value_or(bake.degree);
  bake.directions = directions.value_or(bake.directions);
  bake.sampler = value_called<Sampler>(sampler, kSamplerNames).value_or(bake.sampler);
  bake.seed = seed.value_or(bake.seed);
  require_degree(bake.degree);
}

void SceneOptions::add_to(CLI::App& command) {
  DirectionOptions::add_to(command);
  command
      .add_option("--bounce-directions", bounce_directions,
                  "directions along which surfaces see each other, fewer than for shadows; instead of the scene's")
      ->check(CLI::Range(1, kMaxDirections));
  command.add_option("--kind", kind, "kind of transfer, instead of the scene's")
      ->check(words(kind_names(&TransferKind::word)));
  command
      .add_option("--compress", compress,
                  "CLUSTERS VECTORS: store rows as clusters (prt/README.md), instead of the scene's; 0 0: as they are")
      ->default_str("")
      ->expected(2);
  command
      .add_flag("--compress-auto", compress_auto,
                "a plan with an error stores rows as clusters and chooses their counts, instead of the scene's")
      ->excludes("--compress");
  command.add_flag("--fit-lobes", fit_lobes,
                   "glossy kinds: the nearest lobes in place of BRDFs, which cost less and say what they miss");
  command.add_option(
      "--plan", plan,
      "none: leave nothing out; exact: change no number; lossy: stay within the error; or the file of `prt plan -o`, "
      "which holds all decisions and options");
  command.add_option("--error", error, "error limit of a lossy plan, instead of the scene's");
  command
      .add_option("--light-turns", turns, "later rotations of the lights that the plan allows, instead of the scene's")
      ->check(words(kLightTurnsNames));
  command.add_option("--without", without, "decisions to skip")->default_str("")->delimiter(',');
}

std::vector<std::string> SceneOptions::given() const {
  const std::pair<bool, const char*> all[] = {{degree.has_value(), "--degree"},
                                              {directions.has_value(), "--directions"},
                                              {bounce_directions.has_value(), "--bounce-directions"},
                                              {!sampler.empty(), "--sampler"},
                                              {seed.has_value(), "--seed"},
                                              {!kind.empty(), "--kind"},
                                              {!compress.empty(), "--compress"},
                                              {compress_auto, "--compress-auto"},
                                              {fit_lobes, "--fit-lobes"},
                                              {!plan.empty(), "--plan"},
                                              {error.has_value(), "--error"},
                                              {!turns.empty(), "--light-turns"},
                                              {!without.empty(), "--without"}};
  std::vector<std::string> names;
  for (const auto& [is_given, name] : all) {
    if (is_given) names.emplace_back(name);
  }
  return names;
}

std::string SceneOptions::plan_file() const {
  return value_called<PlanMode>(plan, kPlanModeNames) ? std::string() : plan;
}

void SceneOptions::apply_to(Scene& loaded) const {
  if (const std::string file = plan_file(); !file.empty()) {
    if (!std::filesystem::exists(file)) {
      throw std::invalid_argument(fmt::format("--plan {}: no such file; expected {} or a file that `prt plan -o` made",
                                              file, fmt::join(kPlanModeNames, ", ")));
    }
    for (const std::string& name : given()) {
      if (name == "--plan") continue;
      throw std::invalid_argument(fmt::format("{}: {} has decided it; expected one of both", name, file));
    }
    return;
  }
  BakeOptions& bake = loaded.bake;
  DirectionOptions::apply_to(bake);
  bake.bounces.directions = bounce_directions.value_or(bake.bounces.directions);
  if (!kind.empty()) bake.kind = find_kind(&TransferKind::word, kind);
  if (!compress.empty()) bake.compress = {compress[0], compress[1]};
  if (compress_auto) bake.compress = {};
  if (!compress.empty() || compress_auto) bake.compress_by_plan = compress_auto;
  bake.fit_lobes = bake.fit_lobes || fit_lobes;
  PlanOptions& made = loaded.plan;
  made.mode = value_called<PlanMode>(plan, kPlanModeNames).value_or(error ? PlanMode::kLossy : made.mode);
  made.error = error.value_or(made.error);
  made.turns = value_called<LightTurns>(turns, kLightTurnsNames).value_or(made.turns);
  made.without.insert(made.without.end(), without.begin(), without.end());
}

std::vector<std::string> words_without(const CLI::App& command, std::vector<std::string> left_out) {
  left_out.emplace_back("--log");  // changes no result
  std::vector<std::string> words = {command.get_name()};
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || std::find(left_out.begin(), left_out.end(), option->get_name()) != left_out.end()) {
      continue;
    }
    if (!option->get_positional()) words.push_back(option->get_name());
    if (option->get_items_expected_max() == 0) continue;  // a flag
    words.insert(words.end(), option->results().begin(), option->results().end());
  }
  return words;
}

}  // namespace sh::prt
