// The commands of the tool `prt`. Each reads options, calls the library and writes a file or JSON. Results go to
// standard output, progress and messages to standard error. An error is an exception with one line.
#pragma once
#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/output/stopwatch.hpp"
#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
#include "prt/light/window.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

using Json = nlohmann::ordered_json;
using output::Stopwatch;

/// The exit code where the machine failed, not the input: EX_TEMPFAIL of sysexits.h.
inline constexpr int kRetry = 75;

/// Runs the command of a command line; an error is one line on standard error. Returns the exit code.
int run_tool(int argc, char** argv);
/// Says the error, one line on standard error. Returns the exit code.
int tell_error(const std::exception_ptr& error);

/// Each function adds its subcommand to the tool; parsing the command line then runs it.
void add_bake_command(CLI::App& tool);
void add_merge_command(CLI::App& tool);
void add_shards_command(CLI::App& tool);
void add_volume_command(CLI::App& tool);
void add_translucent_command(CLI::App& tool);
void add_relight_command(CLI::App& tool);
void add_render_command(CLI::App& tool);
void add_shader_command(CLI::App& tool);
void add_fix_view_command(CLI::App& tool);
void add_info_command(CLI::App& tool);
void add_project_command(CLI::App& tool);
void add_plan_command(CLI::App& tool);
void add_reconstruct_command(CLI::App& tool);
void add_light_at_command(CLI::App& tool);
void add_probes_command(CLI::App& tool);
void add_lightmap_command(CLI::App& tool);
void add_study_command(CLI::App& tool);
void add_compare_command(CLI::App& tool);
void add_grid_command(CLI::App& tool);
void add_export_command(CLI::App& tool);
void add_import_command(CLI::App& tool);
void add_splats_command(CLI::App& tool);
void add_view_command(CLI::App& tool);
void add_emit_command(CLI::App& tool);  // where the generator is built

/// A requested check found a difference: the tool exits 1.
struct CheckFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `--window` and `--keep`: a window on the sum of all lights.
struct WindowOptions {
  std::string window;  // empty: none; auto, KIND, KIND:NUMBER, sinc:WIDTH:POWER
  std::string keep = "radiance";

  void add_to(CLI::App& command);
};

/// The lights' coefficients under their own windows or under the window of the options. The effect of each window is
/// printed on standard error and, if `windowed` is not null, stored there. Throws std::runtime_error if both have a
/// window, or if a coefficient exceeds single precision.
LightCoefficients project_windowed(const std::vector<Light>& lights, int degree, const WindowOptions& options,
                                   std::vector<Deringing>* windowed = nullptr);

/// Options that several commands share: the light, from a scene or by name, and the treatment of flaws.
struct LightOptions {
  std::string scene;  // JSON file or `demo`: its lights (and camera)
  std::string light;  // instead of a scene: constant, overcast, an environment picture or a JSON file of lights
  std::string mapping = "lat_long";  // of the picture
  WindowOptions window;
  float turn_degrees = 0.0F;  // about +z, after the lights' own rotations
  bool strict = false;

  void add_to(CLI::App& command);
};

/// The lights that the options name, and the camera of their scene. Without any option the lights are `otherwise` or,
/// if that is empty, the CIE overcast sky.
struct ChosenLight {
  std::vector<Light> lights;
  std::optional<Camera> camera;
  std::vector<std::string> files;  // that they are read from
};
ChosenLight choose_light(const LightOptions& options, const std::vector<LightSpec>& otherwise = {});

/// Adds `--mapping`, one of numeric::kMappingNames.
void add_mapping_to(CLI::App& command, std::string& mapping);

/// The lights that a word or a file stands for: `constant`, `overcast`, a JSON file with one light of a scene or an
/// array of lights, else a picture of this mapping.
std::vector<LightSpec> named_lights(const std::string& name, const std::string& mapping);

/// `--checkpoint` and its like: where a stopped bake saves its results.
struct CheckpointOptions {
  std::string file;  // empty: beside the output
  bool none = false;
  bool restart = false;
  double seconds = CheckpointSettings().seconds;

  /// Returns the option of the file, with which others may not stand.
  CLI::Option* add_to(CLI::App& command);
  /// Of a bake into `output`; without a checkpoint if `none` is set or the output is a device. Throws std::runtime_error if
  /// the file cannot be written.
  [[nodiscard]] CheckpointSettings settings(const std::string& output) const;
};

/// The treatment of flaws, by the flag `--strict`.
inline OnFlaw on_flaw(bool strict) { return strict ? OnFlaw::kRefuse : OnFlaw::kMend; }

/// Runs `work` with at most `threads` threads; 0 uses every core.
void with_threads(int threads, const std::function<void()>& work);

/// Adds `--threads`, and calls run(options) after parsing, with so many threads.
template <class Options>
void run_with_threads(CLI::App& command, const std::shared_ptr<Options>& options, void (*run)(const Options&),
                      const std::string& more_help = {}) {
  command.add_option("--threads", options->threads, "number of threads; 0: every core" + more_help);
  command.callback([options, run] { with_threads(options->threads, [&] { run(*options); }); });
}

/// Refuses a value of `--exposure` beyond 64 stops.
void require_stops(float stops);

/// Prints a result on standard output; throws std::runtime_error if writing fails.
void print_out(std::string_view text);
void print_json(const Json& json);

/// The three components of a vector.
template <class Vector>
Json json_of(const Vector& v) {
  return {v.x(), v.y(), v.z()};
}

/// Throws std::runtime_error before long work starts if `file` cannot be written, or if its name does not end in one of
/// `endings`, such as `.png`; devices may have any name.
void require_output(const std::string& file, const std::vector<std::string>& endings = {});

/// Throws std::runtime_error if a number is not finite, with the file or option that made it.
void require_finite(const std::vector<Eigen::Vector3f>& radiance, const std::string& file);

/// Prints `prt: WHAT in S s` on standard error, with `what` and the seconds.
void report_time(const Stopwatch& stopwatch, const std::string& what);

}  // namespace sh::prt
