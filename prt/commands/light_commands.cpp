// `prt project LIGHT --degree N`: the SH coefficients of a picture, or of the lights of a JSON file, as JSON.
// `prt reconstruct LIGHT -o picture.png`: a drawing of a light and its SH reconstruction, with negative regions marked.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/light_figure.hpp"
#include "prt/light/sphere_extremes.hpp"
#include "prt/names.hpp"
#include "prt/scene/coefficients_json.hpp"

namespace sh::prt {
namespace {

/// The options of both commands.
struct LightCommand {
  std::string light;
  std::string mapping = "lat_long";
  int degree = 2;
  WindowOptions window;
  int threads = 0;
  bool strict = false;

  void add_to(CLI::App& command, const std::string& light_help, const std::string& strict_help);
  [[nodiscard]] std::vector<Light> load() const { return load_lights(named_lights(light, mapping), on_flaw(strict)); }
  [[nodiscard]] std::string file_name() const { return std::filesystem::path(light).filename().string(); }
};

struct ReconstructCommand : LightCommand {
  ReconstructCommand() { degree = 4; }

  std::string output;
  std::string draw = "lat_long";
  std::string show = "both";
  LightFigure figure;
  bool no_marks = false;
};

void LightCommand::add_to(CLI::App& command, const std::string& light_help, const std::string& strict_help) {
  command.add_option("LIGHT", light, light_help)->required();
  add_mapping_to(command, mapping);
  window.add_to(command);
  command.add_option("--degree", degree, "SH degree, 0 to 10");
  command.add_flag("--strict", strict, strict_help);
}

/// Facts about a picture, and its sun if that was extracted; nothing for other lights.
Json described(const LightCommand& options, const std::vector<Light>& lights) {
  Json out = {{"file", options.file_name()}};
  for (const Light& light : lights) {
    if (light.image) {
      out.update({{"width", light.image->width},
                  {"height", light.image->height},
                  {"negative_pixels", light.image->negative_pixels},
                  {"mapping", name_of(light.spec.mapping)}});
    }
    if (light.share_of_picture > 0.0) {
      out["suns"].push_back({{"direction", json_of(light.rotation * light.spec.direction)},
                             {"one_minus_cos_half_angle", light.spec.one_minus_cos},
                             {"radiance", json_of(light.spec.radiance)},
                             {"share_of_picture", light.share_of_picture}});
    }
  }
  return out;
}

Json described(const Deringing& done) {
  const Window& window = done.choice.window;
  Json out = {{"type", done.needed ? word_of(window.type, kWindowNames) : "none"}};
  if (done.needed) out[std::string(number_key(window.type))] = window.size;
  if (window.type == WindowType::kSinc) out["power"] = window.power;
  out.update({{"keep", word_of(done.choice.keep, kKeepNames)},
              {"least_over_peak_before", done.least_before},
              {"least_over_peak", done.least_after},
              {"peak_kept", done.peak_kept},
              {"contrast_kept", done.contrast_kept}});
  return out;
}

void run_project(const LightCommand& options) {
  const Stopwatch stopwatch;
  require_degree(options.degree);
  const std::vector<Light> lights = options.load();
  std::vector<Deringing> windowed;
  const LightCoefficients light = project_windowed(lights, options.degree, options.window, &windowed);
  Json out = described(options, lights);
  for (const Deringing& done : windowed) out["windows"].push_back(described(done));
  out.update(coefficients_json(light));
  print_json(out);
  report_time(stopwatch, fmt::format("projected {} on degree {}", options.light, options.degree));
}

/// The least and the largest value of any channel, and the part of the sphere on which a channel is negative.
Json summary(const LightCoefficients& light) {
  const std::vector<double> all(light.degree + 1, 1.0);
  SphereValue least{std::numeric_limits<double>::infinity()};
  SphereValue largest{-least.value};
  for (int channel = 0; channel < 3; ++channel) {
    const BandLimited f(&light.at(channel, 0), light.degree);
    const SphereValue low = f.least(all);
    const SphereValue high = f.largest(all);
    least = low.value < least.value ? low : least;
    largest = high.value > largest.value ? high : largest;
  }
  const auto nodes = numeric::fibonacci_nodes(20'000);
  const auto negative = std::count_if(nodes.begin(), nodes.end(), [&](const auto& node) {
    return radiance(light, {node.x, node.y, node.z}).minCoeff() < 0.0;
  });
  return {{"degree", light.degree},
          {"least", least.value},
          {"least_towards", json_of(least.direction)},
          {"largest", largest.value},
          {"largest_towards", json_of(largest.direction)},
          {"negative_share", static_cast<double>(negative) / static_cast<double>(nodes.size())},
          {"unit", "W m^-2 sr^-1, of any channel"}};
}

std::vector<ImageMapping> mappings_named(const std::string& name) {
  std::vector<ImageMapping> out;
  for (const std::string_view word : numeric::kMappingNames) {
    if (name == "all" || name == word) out.push_back(numeric::mapping_named(word).value());
  }
  return out;
}

void run_reconstruct(const ReconstructCommand& options) {
  const Stopwatch stopwatch;
  require_output(options.output, {".png"});
  const std::vector<Light> lights = options.load();
  output::require_no_input(options.output, {options.light});
  for (const Light& light : lights) output::require_no_input(options.output, {light.spec.file});
  const LightCoefficients light = project_windowed(lights, options.degree, options.window);
  LightFigure figure = options.figure;
  if (figure.title.empty()) figure.title = options.file_name();
  figure.mappings = mappings_named(options.draw);
  figure.original = options.show != "reconstruction";
  figure.reconstruction = options.show != "original";
  figure.mark_negative = !options.no_marks;
  const std::string bytes = draw_lights(lights, light, figure);
  const Json found = summary(light);
  output::write_file(options.output, bytes);
  print_json(found);
  report_time(stopwatch,
              fmt::format("drew {} at degree {}: least {:.3g}, largest {:.3g}, {:.1f} % of the sphere negative",
                          options.light, options.degree, found["least"].get<double>(), found["largest"].get<double>(),
                          100.0 * found["negative_share"].get<double>()));
}

}  // namespace

void add_project_command(CLI::App& tool) {
  auto options = std::make_shared<LightCommand>();
  CLI::App& command = *tool.add_subcommand("project", "print the SH coefficients of a picture or of lights as JSON");
  options->add_to(command, "a picture (.exr, .hdr, .png, .jpg), a .json file of lights, constant or overcast",
                  "refuse negative pixels instead of setting them to 0");
  run_with_threads(command, options, run_project);
}

void add_reconstruct_command(CLI::App& tool) {
  auto options = std::make_shared<ReconstructCommand>();
  CLI::App& command =
      *tool.add_subcommand("reconstruct", "draw a light and its SH reconstruction, negative regions marked");
  options->add_to(command, "a picture, a .json file of lights, constant or overcast",
                  "refuse input that would otherwise be mended with a warning");
  command.add_option("-o,--output", options->output, "PNG file to write")->required();
  std::vector<std::string> words(numeric::kMappingNames.begin(), numeric::kMappingNames.end());
  words.emplace_back("all");
  command.add_option("--draw", options->draw, "mapping of the drawing, or all")->check(CLI::IsMember(words));
  command.add_option("--show", options->show, "original, reconstruction or both side by side")
      ->check(CLI::IsMember({"original", "reconstruction", "both"}));
  command.add_option("--exposure", options->figure.exposure_stops, "stops brighter than the automatic exposure");
  command.add_option("--width", options->figure.width, "width in pixels");
  command.add_option("--title", options->figure.title, "title above the picture; default: the light's name");
  command.add_flag("--axes", options->figure.axes, "label the axes +x, -x, ...");
  command.add_flag("--no-marks", options->no_marks, "do not mark negative regions");
  run_with_threads(command, options, run_reconstruct);
}

}  // namespace sh::prt
