// Options and helpers that several commands share.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "prt/commands/commands.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

std::vector<LightSpec> lights_of_file(const std::string& file) {
  const nlohmann::json document = read_json(file);
  const JsonReader reader(file, document);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  if (!reader.is_array()) return {read_light(reader, folder)};
  std::vector<LightSpec> lights;
  for (const JsonReader& item : reader.items()) lights.push_back(read_light(item, folder));
  return lights;
}

}  // namespace

std::vector<LightSpec> named_lights(const std::string& name, const std::string& mapping) {
  if (std::filesystem::path(name).extension() == ".json") return lights_of_file(name);
  LightSpec spec;
  if (name == "constant") {
    spec.type = LightType::kConstant;
  } else if (name == "overcast") {
    spec.type = LightType::kCieOvercast;
  } else {
    spec.type = LightType::kEnvironment;
    spec.file = name;
    spec.mapping = numeric::mapping_named(mapping).value();
  }
  return {spec};
}

void add_mapping_to(CLI::App& command, std::string& mapping) {
  const std::vector<std::string> words(numeric::kMappingNames.begin(), numeric::kMappingNames.end());
  command.add_option("--mapping", mapping, "mapping of a picture (prt/IMAGES.md)")
      ->check(CLI::IsMember(words))
      ->capture_default_str();
}

void LightOptions::add_to(CLI::App& command) {
  auto* from_scene =
      command.add_option("--scene", scene, "take light and camera from this scene (JSON file or `demo`)");
  command
      .add_option("--light", light,
                  "light instead of the scene's: constant, overcast, a picture (.exr, .hdr, .png, .jpg) or a .json "
                  "file of lights")
      ->excludes(from_scene);
  add_mapping_to(command, mapping);
  window.add_to(command);
  command.add_option("--turn", turn_degrees, "turn the light about +z by this many degrees");
  command.add_flag("--strict", strict, "refuse input that would otherwise be mended with a warning");
}

ChosenLight choose_light(const LightOptions& options, const std::vector<LightSpec>& otherwise) {
  ChosenLight chosen;
  if (!options.scene.empty()) {
    const Scene scene = load_scene(options.scene, options.on_flaw());
    chosen.lights = load_lights(scene.lights, options.on_flaw());
    chosen.camera.push_back(scene.camera);
  } else if (options.light.empty() && !otherwise.empty()) {
    chosen.lights = load_lights(otherwise, options.on_flaw());
  } else {
    chosen.lights = load_lights(named_lights(options.light.empty() ? "overcast" : options.light, options.mapping),
                                options.on_flaw());
  }
  chosen.lights =
      turned(chosen.lights, rotation_about(Eigen::Vector3d::UnitZ(), static_cast<double>(options.turn_degrees)));
  return chosen;
}

void with_threads(int threads, const std::function<void()>& work) {
  if (threads < 0) throw std::invalid_argument(fmt::format("--threads {}: expected 0 (every core) or more", threads));
  const auto count = static_cast<std::size_t>(threads == 0 ? tbb::info::default_concurrency() : threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  work();
}

void print_out(std::string_view text) {
  std::cout << text << std::flush;
  if (!std::cout) throw std::runtime_error("standard output: cannot write");
}

void require_writable(const std::string& file) {
  const std::filesystem::path path(file);
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{}: cannot write: is a folder; expected a file", file));
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::string& checked = std::filesystem::exists(path) ? path.native() : folder.native();
  if (access(checked.c_str(), W_OK) != 0) {
    throw std::runtime_error(fmt::format("{}: cannot write: {}", file, std::strerror(errno)));
  }
}

void report_time(const Stopwatch& stopwatch, const std::string& what) {
  fmt::print(stderr, "prt: {} in {:.2f} s\n", what, stopwatch.seconds());
}

void BakeOverrides::add_to(CLI::App& command) {
  command.add_option("--degree", degree, "SH degree, 0 to 10, instead of the scene's");
  command.add_option("--directions", directions, "directions over the whole sphere, instead of the scene's");
  command.add_option("--sampler", sampler, "method that chooses the directions, instead of the scene's")
      ->check(CLI::IsMember(std::vector<std::string>(kSamplerNames.begin(), kSamplerNames.end())));
  command.add_option("--seed", seed, "seed of all samplers except fibonacci, instead of the scene's")
      ->check(CLI::Range(0, kMaxSeed));
  const auto words = kind_words();
  command
      .add_option("--kind", kind, "kind of transfer: unshadowed, shadowed or interreflected, instead of the scene's")
      ->check(CLI::IsMember(std::vector<std::string>{words.begin(), words.end()}));
}

void BakeOverrides::apply_to(BakeOptions& bake) const {
  bake.degree = degree.value_or(bake.degree);
  bake.directions = directions.value_or(bake.directions);
  bake.sampler = sampler_called(sampler).value_or(bake.sampler);
  bake.seed = seed.value_or(bake.seed);
  if (!kind.empty()) bake.kind = kind_called(kind);
  require_degree(bake.degree);
}

}  // namespace sh::prt
