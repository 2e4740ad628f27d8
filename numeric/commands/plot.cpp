// shcheck plot lobes|map: pictures of basis functions and of coefficient vectors.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/plot/coefficients.hpp"
#include "numeric/plot/lobes.hpp"
#include "numeric/plot/map.hpp"

namespace sh::numeric {
namespace {

struct Options {
  int degree = -1;
  int order = 0;
  int basis_grid = -1;
  std::string coefficients;
  std::string output;
  int size = 1000;
  std::string view = "35,20";
  std::string projection = "lat-long";
  CLI::App* command = nullptr;

  [[nodiscard]] bool has(const char* option) const { return command->count(option) > 0; }
};

void require_range(const char* option, int value, int least, int most) {
  if (value < least || value > most) {
    throw std::invalid_argument(fmt::format("{} is {}, must be {} to {}", option, value, least, most));
  }
}

// An argument in a message: a file's name whole, a long list not.
std::string shortened(const std::string& text) { return text.size() <= 80 ? text : text.substr(0, 77) + "..."; }

void require_one_subject(const Options& options, bool grid) {
  const int subjects =
      int(options.has("--degree")) + int(options.has("--coefficients")) + int(grid && options.has("--basis-grid"));
  if (subjects != 1) {
    throw std::invalid_argument(fmt::format("plot: give one of --degree, --coefficients{}; {} are given",
                                            grid ? ", --basis-grid" : "", subjects));
  }
  if (options.has("--order") && !options.has("--degree")) throw std::invalid_argument("--order: needs --degree");
}

// The function that is asked for and what the picture calls it.
struct Subject {
  plot::SphereFunction f;
  std::string title;
};

Subject subject_of(const Options& options) {
  if (options.has("--degree")) {
    require_range("--degree", options.degree, 0, plot::kLargestDegree);
    require_range("--order", options.order, -options.degree, options.degree);
    return {plot::basis_function(options.degree, options.order),
            fmt::format("Y({},{})", options.degree, options.order)};
  }
  const auto numbers = plot::numbers_from("--coefficients", options.coefficients);
  try {
    auto f = plot::function_of_coefficients(numbers);
    auto title = fmt::format("degree {}, {} coefficients{}", f.degree, numbers.size() / std::size_t(f.channels),
                             f.channels == 3 ? " a channel" : "");
    return {std::move(f), std::move(title)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--coefficients {}: {}", shortened(options.coefficients), error.what()));
  }
}

plot::View view_of(const Options& options) {
  const auto angles = plot::parse_numbers("--view", options.view);
  if (angles.size() != 2 || std::abs(angles[0]) > 360 || std::abs(angles[1]) > 90) {
    throw std::invalid_argument("--view: '" + options.view +
                                "' must be azimuth,elevation in degrees, within 360 and 90");
  }
  return {angles[0], angles[1]};
}

plot::Figure figure_of(const Options& options, std::string title) {
  require_range("--size", options.size, plot::kSmallestSize, plot::kLargestSize);
  return {std::move(title), plot::format_of(options.output), options.size};
}

void plot_lobes(const Options& options) {
  require_one_subject(options, true);
  const auto view = view_of(options);
  if (options.has("--basis-grid")) {
    require_range("--basis-grid", options.basis_grid, 0, plot::kLargestGrid);
    const auto title = fmt::format("Real spherical harmonics, degree 0 to {}", options.basis_grid);
    const auto figure = figure_of(options, title);
    output::write_file(options.output, plot::draw_basis_grid(options.basis_grid, view, figure));
    return;
  }
  const auto figure = figure_of(options, {});
  const auto subject = subject_of(options);
  output::write_file(options.output, plot::draw_lobes(subject.f, view, {subject.title, figure.format, figure.size}));
}

constexpr const char* kProjections = "lat-long, cube-map, angular-map, mirror-ball, vertical-cross or cube-strip";

ImageMapping mapping_of(const std::string& projection) {
  std::string name = projection == "cube-map" ? "horizontal-cross" : projection;
  std::replace(name.begin(), name.end(), '-', '_');
  const auto mapping = mapping_named(name);
  if (!mapping) throw std::invalid_argument(fmt::format("--projection: '{}' must be {}", projection, kProjections));
  return *mapping;
}

void plot_map(const Options& options) {
  require_one_subject(options, false);
  const auto mapping = mapping_of(options.projection);
  const auto figure = figure_of(options, {});
  const auto subject = subject_of(options);
  output::write_file(options.output, plot::draw_map(subject.f, mapping, {subject.title, figure.format, figure.size}));
}

// What both pictures take.
std::shared_ptr<Options> add_options(CLI::App* command) {
  auto options = std::make_shared<Options>();
  options->command = command;
  command->add_option("--degree", options->degree, "l of one basis function, 0 to 64");
  command->add_option("--order", options->order, "its m, -l to l (0)");
  command->add_option("--coefficients", options->coefficients,
                      "numbers separated by commas, or a file of them (# comments): bands^2, or three times that");
  command->add_option("-o,--output", options->output, "the picture, .svg or .png")->required();
  command->add_option("--size", options->size, "width in pixels, 16 to 8192")->capture_default_str();
  return options;
}

}  // namespace

void add_plot_command(CLI::App& tool, int& /*exit_code*/) {
  auto* command = tool.add_subcommand("plot", "draw a function on the sphere, from coefficients or one of the basis");
  command->require_subcommand(1);

  auto* lobes = command->add_subcommand("lobes", "the surface r = |f|, positive and negative in two colors");
  const auto lobes_options = add_options(lobes);
  lobes->add_option("--basis-grid", lobes_options->basis_grid, "every basis function to this degree, 0 to 12");
  lobes->add_option("--view", lobes_options->view, "azimuth,elevation of the viewer, degrees")->capture_default_str();
  lobes->callback([lobes_options] {
    output::stop_on_interrupt();
    plot_lobes(*lobes_options);
  });

  auto* map = command->add_subcommand("map", "values as colors, negative regions hatched");
  const auto map_options = add_options(map);
  map->add_option("--projection", map_options->projection, kProjections)->capture_default_str();
  map->callback([map_options] {
    output::stop_on_interrupt();
    plot_map(*map_options);
  });
}

}  // namespace sh::numeric
