// What several commands share: prt/commands.hpp.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "prt/commands.hpp"

namespace sh::prt {
namespace {

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1); }

LightSpec named_light(const std::string& name) {
  LightSpec spec;
  if (name == "constant") {
    spec.type = LightType::kConstant;
  } else if (name == "overcast") {
    spec.type = LightType::kCieOvercast;
  } else {
    spec.type = LightType::kEnvironment;
    spec.file = name;
  }
  return spec;
}

}  // namespace

void LightOptions::add_to(CLI::App& command) {
  auto* from_scene =
      command.add_option("--scene", scene, "take light and camera from this scene (JSON file or `demo`)");
  command
      .add_option("--light", light, "instead of the scene's: constant, overcast, or a lat-long .exr or .hdr picture")
      ->excludes(from_scene);
  command.add_option("--turn", turn_degrees, "turn the light about +z by this many degrees");
  command.add_flag("--strict", strict, "refuse input that would otherwise be mended with a warning");
}

ChosenLight choose_light(const LightOptions& options) {
  ChosenLight chosen;
  if (!options.scene.empty()) {
    const Scene scene = load_scene(options.scene, options.on_flaw());
    chosen.lights = load_lights(scene.lights, options.on_flaw());
    chosen.camera.push_back(scene.camera);
  } else {
    chosen.lights = load_lights({named_light(options.light.empty() ? "overcast" : options.light)}, options.on_flaw());
  }
  chosen.lights =
      turned(chosen.lights, rotation_about(Eigen::Vector3d::UnitZ(), static_cast<double>(options.turn_degrees)));
  return chosen;
}

void with_threads(int threads, const std::function<void()>& work) {
  if (threads < 0) {
    throw std::invalid_argument(fmt::format("--threads {}: must be 0 (every core) or more", threads));
  }
  const auto count = static_cast<std::size_t>(threads == 0 ? tbb::info::default_concurrency() : threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  work();
}

void require_writable(const std::string& file) {
  const std::filesystem::path path(file);
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{}: cannot write: is a folder; a file is needed", file));
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::string& checked = std::filesystem::exists(path) ? path.native() : folder.native();
  if (access(checked.c_str(), W_OK) != 0) {
    throw std::runtime_error(fmt::format("{}: cannot write: {}", file, std::strerror(errno)));
  }
}

Stopwatch::Stopwatch() : start_(now()) {}

void Stopwatch::report(const std::string& what) const {
  fmt::print(stderr, "prt: {} in {:.2f} s\n", what, static_cast<double>(now() - start_) * 1e-9);
}

}  // namespace sh::prt
