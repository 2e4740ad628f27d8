// The commands of the tool `prt`, one file each: options in, the work done by the library, a file or JSON out.
// Results go to standard output, progress and messages to standard error. An error is an exception with one line.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/output/stopwatch.hpp"
#include "prt/light/deringing.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// Each adds its subcommand to the tool; parsing the command line then runs it.
void add_bake_command(CLI::App& tool);
void add_relight_command(CLI::App& tool);
void add_render_command(CLI::App& tool);
void add_shader_command(CLI::App& tool);
void add_info_command(CLI::App& tool);
void add_project_command(CLI::App& tool);
void add_plan_command(CLI::App& tool);
void add_reconstruct_command(CLI::App& tool);
void add_study_command(CLI::App& tool);
void add_compare_command(CLI::App& tool);

/// A check that a command was asked for found a difference: the tool exits 1.
struct CheckFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `--window` and `--keep`: a window on the sum of all lights.
struct WindowOptions {
  std::string window;  // empty: none; auto, KIND, KIND:NUMBER, sinc:WIDTH:POWER
  std::string keep = "radiance";

  void add_to(CLI::App& command);
};

/// The lights' coefficients under their own windows or that of the options; what each window did is told on standard
/// error and, if given, in `windowed`. Throws std::runtime_error where both have one.
LightCoefficients project_windowed(const std::vector<Light>& lights, int degree, const WindowOptions& options,
                                   std::vector<Deringing>* windowed = nullptr);

/// What several commands take: the light, as a scene's or as a word, and how flaws are met.
struct LightOptions {
  std::string scene;                 // JSON file or `demo`: its lights (and camera)
  std::string light;                 // instead: constant, overcast, an environment picture or a JSON file of lights
  std::string mapping = "lat_long";  // of the picture
  WindowOptions window;
  float turn_degrees = 0.0F;  // about +z, on top of the lights' own rotations
  bool strict = false;

  void add_to(CLI::App& command);
  [[nodiscard]] OnFlaw on_flaw() const { return strict ? OnFlaw::kRefuse : OnFlaw::kMend; }
};

/// What replaces the scene's `bake`.
struct BakeOverrides {
  std::optional<int> degree;
  std::optional<int> directions;
  std::string sampler;
  std::optional<std::uint32_t> seed;
  std::string kind;

  void add_to(CLI::App& command);
  /// Throws std::invalid_argument for a degree that there is not.
  void apply_to(BakeOptions& bake) const;
};

/// What commands that plan take: all in place of what the scene says.
struct PlanArguments {
  std::string mode;  // none, exact, lossy; empty: the scene's
  std::optional<double> error;
  std::string turns;
  std::vector<std::string> without;

  void add_to(CLI::App& command);
  [[nodiscard]] PlanOptions applied_to(PlanOptions options) const;
};

/// The lights the options name and the camera of their scene; without a scene `camera` stays empty. Without any option
/// `otherwise`, and where that is empty the CIE overcast sky.
struct ChosenLight {
  std::vector<Light> lights;
  std::vector<Camera> camera;  // none or one
};
ChosenLight choose_light(const LightOptions& options, const std::vector<LightSpec>& otherwise = {});

/// Adds `--mapping`, one of numeric::kMappingNames.
void add_mapping_to(CLI::App& command, std::string& mapping);

/// What a word or a file stands for: `constant`, `overcast`, a JSON file that holds one light of a scene or an array of
/// them, else a picture of that mapping.
std::vector<LightSpec> named_lights(const std::string& name, const std::string& mapping);

/// `--threads N`: 0 takes every core. Runs `work` with at most that many threads.
void with_threads(int threads, const std::function<void()>& work);

/// Prints a result on standard output; throws std::runtime_error where it cannot be written.
void print_out(std::string_view text);

/// Throws std::runtime_error at once, before long work, where `file` could not be written at its end.
void require_writable(const std::string& file);

using output::Stopwatch;

/// `prt: what in S s` on standard error.
void report_time(const Stopwatch& stopwatch, const std::string& what);

}  // namespace sh::prt
