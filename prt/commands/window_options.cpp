// Windows on a command line.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "prt/commands/commands.hpp"
#include "prt/light/project.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
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
nlohmann::json as_in_a_scene(const WindowOptions& options) {
  const std::vector<std::string> parts = parts_of(options.window);
  const auto* const name = std::find(std::begin(kWindowNames), std::end(kWindowNames), parts[0]);
  nlohmann::json window = {{"type", parts[0]}, {"keep", options.keep}};
  if (parts.size() > 3 || (parts.size() > 1 && name == std::end(kWindowNames))) {
    throw std::runtime_error(
        fmt::format("--window {}: expected auto, KIND, KIND:NUMBER or sinc:WIDTH:POWER", options.window));
  }
  if (parts.size() > 1) {
    const auto type = static_cast<WindowType>(name - std::begin(kWindowNames));
    window[std::string(number_key(type))] = number_of(options.window, parts[1]);
  }
  if (parts.size() > 2) {
    const double power = number_of(options.window, parts[2]);
    window["power"] =
        power == std::round(power) ? nlohmann::json(static_cast<long long>(power)) : nlohmann::json(power);
  }
  return window;
}

WindowChoice choice_of(const WindowOptions& options) {
  const std::string where = "--window " + options.window;
  const nlohmann::json window = as_in_a_scene(options);
  return read_window(JsonReader(where, window));
}

}  // namespace

void WindowOptions::add_to(CLI::App& command) {
  command.add_option(
      "--window", window,
      "window on all lights: auto, or hann|sinc|laplacian|gaussian|fejer[:NUMBER], sinc:WIDTH:POWER; without a "
      "number the least window that leaves no negative value");
  command.add_option("--keep", keep, "quantity that must not be negative")
      ->check(CLI::IsMember({"radiance", "irradiance"}))
      ->capture_default_str();
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
  if (!options.window.empty()) done.push_back(apply_window(choice_of(options), light));
  for (const Deringing& one : done) fmt::print(stderr, "prt: {}\n", describe(one));
  if (windowed != nullptr) *windowed = done;
  return light;
}

}  // namespace sh::prt
