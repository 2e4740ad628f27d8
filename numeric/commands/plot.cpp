// shcheck plot lobes|map: pictures of basis functions and of coefficient vectors.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "numeric/commands/commands.hpp"
#include "numeric/oracle/require.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/plot/lobes.hpp"
#include "numeric/plot/map.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::optional<int> degree, order, basis_grid;
  std::string coefficients;
  bool has_coefficients = false;
  std::string output;
  int size = 1000;
  std::string view = "35,20";
  std::string projection = "lat-long";
};

void require_one_subject(const Options& options, const char* grid) {
  const int subjects =
      int(options.degree.has_value()) + int(options.has_coefficients) + int(options.basis_grid.has_value());
  if (subjects != 1) {
    throw std::invalid_argument(
        fmt::format("plot: expected one of --degree, --coefficients{}, got {}", grid, subjects));
  }
  if (options.order && !options.degree) throw std::invalid_argument("--order: expected --degree too");
}

// The function to draw and its title.
struct Subject {
  plot::SphereFunction f;
  std::string title;
};

Subject subject_of(const Options& options) {
  if (options.degree) {
    const int degree = *options.degree;
    const int order = options.order.value_or(0);
    require_range("--degree", degree, 0, plot::kLargestDegree);
    require_range("--order", order, -degree, degree);
    return {plot::basis_function(degree, order), fmt::format("Y({},{})", degree, order)};
  }
  const auto numbers = plot::numbers_from("--coefficients", options.coefficients);
  try {
    auto f = plot::function_of_coefficients(numbers);
    auto title = fmt::format("degree {}, {} coefficients{}", f.degree, numbers.size() / std::size_t(f.channels),
                             f.channels == 3 ? " a channel" : "");
    return {std::move(f), std::move(title)};
  } catch (const std::invalid_argument& error) {
    const auto& text = options.coefficients;  // the name of a file, or a list that may be long
    throw std::invalid_argument(
        fmt::format("--coefficients {}: {}", text.size() <= 80 ? text : text.substr(0, 77) + "...", error.what()));
  }
}

plot::View view_of(const std::string& text) {
  const auto angles = plot::parse_numbers("--view", text);
  if (angles.size() != 2 || std::abs(angles[0]) > 360 || std::abs(angles[1]) > 90) {
    throw std::invalid_argument(
        fmt::format("--view: expected azimuth,elevation in degrees, within 360 and 90, got '{}'", text));
  }
  return {angles[0], angles[1]};
}

plot::Figure figure_of(const Options& options) {
  require_range("--size", options.size, plot::kSmallestSize, plot::kLargestSize);
  return {"", plot::format_of(options.output), options.size};
}

std::string lobes(const Options& options) {
  require_one_subject(options, ", --basis-grid");
  const auto view = view_of(options.view);
  if (options.basis_grid) {
    require_range("--basis-grid", *options.basis_grid, 0, plot::kLargestGrid);
    auto figure = figure_of(options);
    figure.title = fmt::format("Real spherical harmonics, degree 0 to {}", *options.basis_grid);
    return plot::draw_basis_grid(*options.basis_grid, view, figure);
  }
  const auto figure = figure_of(options);
  const auto subject = subject_of(options);
  return plot::draw_lobes(subject.f, view, {subject.title, figure.format, figure.size});
}

constexpr const char* kProjections = "lat-long, cube-map, angular-map, mirror-ball, vertical-cross or cube-strip";

ImageMapping mapping_of(const std::string& projection) {
  std::string name = projection == "cube-map" ? "horizontal-cross" : projection;
  std::replace(name.begin(), name.end(), '-', '_');
  const auto mapping = mapping_named(name);
  if (!mapping)
    throw std::invalid_argument(fmt::format("--projection: expected {}, got '{}'", kProjections, projection));
  return *mapping;
}

std::string map(const Options& options) {
  require_one_subject(options, "");
  const auto mapping = mapping_of(options.projection);
  const auto figure = figure_of(options);
  const auto subject = subject_of(options);
  return plot::draw_map(subject.f, mapping, {subject.title, figure.format, figure.size});
}

// A picture with the options that both pictures share.
Command add_picture(Command& plot, const char* name, const char* help, const std::shared_ptr<Options>& options,
                    std::string (*draw)(const Options& options)) {
  auto command = plot.command(name, help);
  command.option("--degree", options->degree, "l of one basis function, 0 to 64");
  command.option("--order", options->order, "its m, -l to l (0)");
  const auto coefficients =
      command.option("--coefficients", options->coefficients,
                     "numbers separated by commas, or a file of them (# comments): bands^2, or three times that");
  command.option("-o,--output", options->output, "the picture, .svg or .png").required();
  command.option("--size", options->size, "width in pixels, 16 to 8192").with_default();
  command.run([=] {
    options->has_coefficients = coefficients.given();
    output::require_writable(options->output);
    output::require_no_input(options->output, {options->coefficients});
    output::stop_on_interrupt();
    output::write_file(options->output, draw(*options));
    return kDone;
  });
  return command;
}

}  // namespace

void add_plot_command(Command& tool) {
  auto plot = tool.command("plot", "draw a function on the sphere, from coefficients or one of the basis");
  plot.require_command();
  const auto options = std::make_shared<Options>();
  auto of_lobes =
      add_picture(plot, "lobes", "the surface r = |f|, positive and negative in two colors", options, lobes);
  of_lobes.option("--basis-grid", options->basis_grid, "every basis function to this degree, 0 to 12");
  of_lobes.option("--view", options->view, "azimuth,elevation of the viewer, degrees").with_default();
  auto of_map = add_picture(plot, "map", "values as colors, negative regions hatched", options, map);
  of_map.option("--projection", options->projection, kProjections).with_default();
}

}  // namespace sh::numeric
