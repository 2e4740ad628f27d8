// Options and helpers that several commands share.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/machine_error.hpp"
#include "prt/commands/commands.hpp"
#include "prt/say.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

std::vector<LightSpec> lights_of_file(const std::string& file) {
  const nlohmann::json document = read_json(file);
  const JsonReader reader(file, document);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  if (!reader.is("array")) return {read_light(reader, folder)};
  std::vector<LightSpec> lights;
  for (const JsonReader& item : reader.items()) lights.push_back(read_light(item, folder));
  return lights;
}

double number_of(const std::string& window, const std::string& part) {
  double value = 0.0;
  const auto end = std::from_chars(part.data(), part.data() + part.size(), value);
  if (end.ec != std::errc() || end.ptr != part.data() + part.size()) {
    throw std::runtime_error(fmt::format("--window {}: `{}` is no number", window, part));
  }
  return value;
}

/// The option in the form of a scene's JSON, so that one reader checks both.
WindowChoice choice_of(const WindowOptions& options) {
  std::vector<std::string> parts;
  std::istringstream stream(options.window + ':');
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  const auto type = value_called<WindowType>(parts[0], kWindowNames);
  if (parts.size() > 3 || (parts.size() > 1 && !type)) {
    throw std::runtime_error(
        fmt::format("--window {}: expected auto, KIND, KIND:NUMBER or sinc:WIDTH:POWER", options.window));
  }
  nlohmann::json window = {{"type", parts[0]}, {"keep", options.keep}};
  if (parts.size() > 1) window[std::string(number_key(*type))] = number_of(options.window, parts[1]);
  if (parts.size() > 2) {
    const double power = number_of(options.window, parts[2]);
    const bool is_whole = power == std::round(power);
    window["power"] = is_whole ? nlohmann::json(static_cast<long long>(power)) : nlohmann::json(power);
  }
  const std::string where = "--window " + options.window;
  return read_window(JsonReader(where, window));
}

}  // namespace

void WindowOptions::add_to(CLI::App& command) {
  command.add_option(
      "--window", window,
      "window on all lights: auto, or hann|sinc|laplacian|gaussian|fejer[:NUMBER], sinc:WIDTH:POWER; without a "
      "number the least window that leaves no negative value");
  command.add_option("--keep", keep, "quantity that must not be negative")
      ->check(CLI::IsMember({"radiance", "irradiance"}));
}

LightCoefficients project_windowed(const std::vector<Light>& lights, int degree, const WindowOptions& options,
                                   std::vector<Deringing>* windowed) {
  const bool has_window = std::any_of(lights.begin(), lights.end(), [](const Light& l) { return l.spec.window; });
  if (has_window && !options.window.empty()) {
    throw std::runtime_error(fmt::format(
        "--window {}: a light has a window of its own; either all lights take one or each its own", options.window));
  }
  std::vector<Deringing> done;
  LightCoefficients light = project(lights, degree, &done);
  const auto fits = [](double value) {
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
  };
  if (!std::all_of(light.values.begin(), light.values.end(), fits)) {
    throw std::runtime_error("the lights exceed single precision; expected weaker ones, below 1e37");
  }
  if (!options.window.empty()) done.push_back(apply_window(choice_of(options), light));
  for (const Deringing& one : done) say(describe(one));
  if (windowed != nullptr) *windowed = done;
  return light;
}

std::vector<LightSpec> named_lights(const std::string& name, const std::string& mapping) {
  if (std::filesystem::path(name).extension() == ".json") return lights_of_file(name);
  if (name == "constant") return {{.type = LightType::kConstant}};
  if (name == "overcast") return {{.type = LightType::kCieOvercast}};
  return {{.type = LightType::kEnvironment, .file = name, .mapping = numeric::mapping_named(mapping).value()}};
}

void add_mapping_to(CLI::App& command, std::string& mapping) {
  command.add_option("--mapping", mapping, "mapping of a picture (prt/IMAGES.md)")
      ->check(CLI::IsMember(std::vector<std::string>(numeric::kMappingNames.begin(), numeric::kMappingNames.end())));
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
  const OnFlaw flaws = on_flaw(options.strict);
  ChosenLight chosen;
  std::vector<LightSpec> lights = otherwise;
  if (!options.scene.empty()) {
    const Scene scene = load_scene(options.scene, flaws);
    lights = scene.lights;
    chosen.camera = scene.camera;
    chosen.files = scene.files;
  } else if (!options.light.empty() || otherwise.empty()) {
    lights = named_lights(options.light.empty() ? "overcast" : options.light, options.mapping);
    chosen.files.push_back(options.light);
  }
  for (const LightSpec& light : lights) chosen.files.push_back(light.file);
  const auto degrees = static_cast<double>(options.turn_degrees);
  chosen.lights = turned(load_lights(lights, flaws), rotation_about(Eigen::Vector3d::UnitZ(), degrees));
  return chosen;
}

CLI::Option* CheckpointOptions::add_to(CLI::App& command) {
  auto* path = command.add_option("--checkpoint", file,
                                  "file in which a stopped bake saves its results; the same command continues from "
                                  "there; default: the output's name with .part");
  command.add_flag("--no-checkpoint", none, "write no checkpoint")->excludes(path);
  command.add_flag("--restart", restart, "delete the checkpoint and start again");
  command.add_option("--checkpoint-seconds", seconds, "seconds of work that a killed process loses at most")
      ->check(CLI::Range(0.0, 1e6));
  return path;
}

CheckpointSettings CheckpointOptions::settings(const std::string& output) const {
  CheckpointSettings made{file, restart, seconds};
  const bool is_special = std::filesystem::exists(output) && !std::filesystem::is_regular_file(output);
  if (made.path.empty() && !none && !is_special) made.path = output + ".part";
  if (made.path.empty()) return made;
  output::require_writable(made.path);
  output::require_no_input(made.path, {output});
  return made;
}

void with_threads(int threads, const std::function<void()>& work) {
  if (threads < 0) throw std::invalid_argument(fmt::format("--threads {}: expected 0 (every core) or more", threads));
  const auto count = static_cast<std::size_t>(threads == 0 ? tbb::info::default_concurrency() : threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  work();
}

void require_stops(float stops) {
  constexpr float kMostStops = 64.0F;
  if (!(std::abs(stops) <= kMostStops)) {
    throw std::invalid_argument(fmt::format("--exposure {0}: expected -{1} to {1} stops", stops, kMostStops));
  }
}

void print_out(std::string_view text) {
  std::cout << text << std::flush;
  if (!std::cout) throw output::MachineError("standard output: cannot write");
}

void print_json(const Json& json) { print_out(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); }

void require_output(const std::string& file, const std::vector<std::string>& endings) {
  const auto ends = [&](const std::string& ending) { return file.ends_with(ending); };
  const bool is_special = std::filesystem::exists(file) && !std::filesystem::is_regular_file(file);
  if (!is_special && !endings.empty() && std::none_of(endings.begin(), endings.end(), ends)) {
    throw std::runtime_error(fmt::format("{}: expected a name that ends in {}", file, fmt::join(endings, " or ")));
  }
  output::require_writable(file);
}

void require_finite(const std::vector<Eigen::Vector3f>& radiance, const std::string& file) {
  const auto flaw =
      std::find_if(radiance.begin(), radiance.end(), [](const auto& value) { return !value.allFinite(); });
  if (flaw == radiance.end()) return;
  throw std::runtime_error(
      fmt::format("{}: the exit radiance of vertex {} exceeds single precision; expected weaker lights, below 1e37",
                  file, flaw - radiance.begin()));
}

void report_time(const Stopwatch& stopwatch, const std::string& what) {
  say(fmt::format("{} in {:.2f} s", what, stopwatch.seconds()));
}

}  // namespace sh::prt
