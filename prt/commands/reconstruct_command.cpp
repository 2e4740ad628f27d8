// `prt reconstruct LIGHT -o picture.png`: draws a light and its SH reconstruction, with negative regions marked.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "numeric/output/atomic_file.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/light_figure.hpp"
#include "prt/light/sphere_extremes.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string light;
  std::string output;
  std::string mapping = "lat_long";
  std::string draw = "lat_long";
  std::string show = "both";
  int degree = 4;
  WindowOptions window;
  LightFigure figure;
  bool no_marks = false;
  bool strict = false;
};

/// The least and the largest value of any channel, and the part of the sphere on which a channel is negative.
nlohmann::ordered_json summary(const LightCoefficients& light) {
  const std::vector<double> all(static_cast<std::size_t>(light.degree) + 1, 1.0);
  SphereValue least{std::numeric_limits<double>::infinity()};
  SphereValue largest{-least.value};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const BandLimited f(&light.values[channel * light.bands_squared()], light.degree);
    const SphereValue low = f.least(all);
    const SphereValue high = f.largest(all);
    least = low.value < least.value ? low : least;
    largest = high.value > largest.value ? high : largest;
  }
  const auto nodes = numeric::fibonacci_nodes(20'000);
  const auto negative = std::count_if(nodes.begin(), nodes.end(), [&](const auto& node) {
    return radiance(light, {node.x, node.y, node.z}).minCoeff() < 0.0;
  });
  const auto place = [](const SphereValue& v) {
    return std::array<double, 3>{v.direction.x(), v.direction.y(), v.direction.z()};
  };
  return {{"degree", light.degree},
          {"least", least.value},
          {"least_towards", place(least)},
          {"largest", largest.value},
          {"largest_towards", place(largest)},
          {"negative_share", static_cast<double>(negative) / static_cast<double>(nodes.size())},
          {"unit", "W m^-2 sr^-1, of any channel"}};
}

std::vector<ImageMapping> mappings_named(const std::string& name) {
  if (name != "all") return {numeric::mapping_named(name).value()};
  std::vector<ImageMapping> out;
  for (const std::string_view mapping : numeric::kMappingNames) out.push_back(numeric::mapping_named(mapping).value());
  return out;
}

void run(const Options& options) {
  const Stopwatch stopwatch;
  require_writable(options.output);
  const std::vector<Light> lights =
      load_lights(named_lights(options.light, options.mapping), options.strict ? OnFlaw::kRefuse : OnFlaw::kMend);
  const LightCoefficients light = project_windowed(lights, options.degree, options.window);
  LightFigure figure = options.figure;
  if (figure.title.empty()) figure.title = std::filesystem::path(options.light).filename().string();
  figure.mappings = mappings_named(options.draw);
  figure.original = options.show != "reconstruction";
  figure.reconstruction = options.show != "original";
  figure.mark_negative = !options.no_marks;
  const std::string bytes = draw_lights(lights, light, figure);
  const nlohmann::ordered_json found = summary(light);
  output::write_file(options.output, bytes);
  print_out(found.dump(2) + "\n");
  report_time(stopwatch,
              fmt::format("drew {} at degree {}: least {:.3g}, largest {:.3g}, {:.1f} % of the sphere negative",
                          options.light, options.degree, found["least"].get<double>(), found["largest"].get<double>(),
                          100.0 * found["negative_share"].get<double>()));
}

}  // namespace

void add_reconstruct_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      tool.add_subcommand("reconstruct", "draw a light and its SH reconstruction, negative regions marked");
  command->add_option("LIGHT", options->light, "a picture, a .json file of lights, constant or overcast")->required();
  command->add_option("-o,--output", options->output, "PNG file to write")->required();
  add_mapping_to(*command, options->mapping);
  std::vector<std::string> words(numeric::kMappingNames.begin(), numeric::kMappingNames.end());
  words.emplace_back("all");
  command->add_option("--draw", options->draw, "mapping of the drawing, or all")
      ->check(CLI::IsMember(words))
      ->capture_default_str();
  command->add_option("--show", options->show, "original, reconstruction or both side by side")
      ->check(CLI::IsMember({"original", "reconstruction", "both"}))
      ->capture_default_str();
  command->add_option("--degree", options->degree, "SH degree, 0 to 10")->capture_default_str();
  options->window.add_to(*command);
  command->add_option("--exposure", options->figure.exposure_stops, "stops brighter than the automatic exposure")
      ->capture_default_str();
  command->add_option("--width", options->figure.width, "width in pixels")->capture_default_str();
  command->add_option("--title", options->figure.title, "title above the picture; default: the light's name");
  command->add_flag("--axes", options->figure.axes, "label the axes +x, -x, ...");
  command->add_flag("--no-marks", options->no_marks, "do not mark negative regions");
  command->add_flag("--strict", options->strict, "refuse input that would otherwise be mended with a warning");
  command->callback([options] { run(*options); });
}

}  // namespace sh::prt
