// `prt export LIGHT --to FORMAT -o OUT`: a light as an engine's file, or as code to paste.
// `prt export FILE --to FORMAT -o OUT`: the transfer of a mesh as glTF, PLY or NumPy arrays.
// `prt import FILE`: the coefficients of an engine's light as JSON, which is a light for every other command.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/formats/formats.hpp"
#include "prt/say.hpp"
#include "prt/scene/coefficients_json.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

using formats::LightFormat;
using formats::TransferFormat;

struct ExportCommand {
  std::string subject;
  std::string format;
  std::string output;
  std::optional<int> degree;
  std::string mapping = "lat_long";
  WindowOptions window;
  bool strict = false;
  int threads = 0;
};

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const LightFormat& format : formats::light_formats()) names.emplace_back(format.name);
  for (const TransferFormat& format : formats::transfer_formats()) names.emplace_back(format.name);
  return names;
}

/// The degree of the light before it meets the format: that of its coefficients, else 2, which gives all that
/// irradiance shows.
int natural_degree(const std::vector<Light>& lights) {
  int degree = -1;
  for (const Light& light : lights) {
    if (light.spec.type == LightType::kCoefficients) degree = std::max(degree, light.spec.coefficients.degree);
  }
  return degree < 0 ? 2 : degree;
}

/// The bands above `degree`, and their part of the squares of all, for messages.
std::string loss_above(const LightCoefficients& light, int degree) {
  const double all = light.matrix().squaredNorm();
  const double kept = first_bands(light, degree).matrix().squaredNorm();
  return fmt::format("bands {} to {}, {:.2g} % of the light in squares", degree + 1, light.degree,
                     all > 0.0 ? 100.0 * (all - kept) / all : 0.0);
}

void export_light(const ExportCommand& options, const LightFormat& format) {
  const Stopwatch stopwatch;
  require_output(options.output, {std::string(format.ending)});
  if (is_transfer_file(options.subject)) {
    throw std::runtime_error(
        fmt::format("{}: {} holds a light, and this is a transfer file; expected a light, or --to glb, ply or npz",
                    options.subject, format.name));
  }
  const std::vector<Light> lights =
      load_lights(named_lights(options.subject, options.mapping), on_flaw(options.strict));
  output::require_no_input(options.output, {options.subject});
  for (const Light& light : lights) output::require_no_input(options.output, {light.spec.file});
  const int degree = options.degree.value_or(natural_degree(lights));
  const LightCoefficients light = project_windowed(lights, degree, options.window);
  if (degree > format.degree) {
    const std::string loss = loss_above(light, format.degree);
    if (options.degree) {
      throw std::runtime_error(fmt::format("--degree {}: {} holds degree 0 to {}; {}, would be lost", degree,
                                           format.name, format.degree, loss));
    }
    say(fmt::format("{} holds degree 0 to {}: {}, are left out", format.name, format.degree, loss));
  }
  LightCoefficients held = LightCoefficients::zero(format.degree);
  const Eigen::Index rows = std::min(held.matrix().rows(), light.matrix().rows());
  held.matrix().topRows(rows) = light.matrix().topRows(rows);
  if (format.degree == kMaxDegree) held = light;  // holds any degree
  output::write_file(options.output, format.write({format.convention.to(held), &format.convention, &light}));
  report_time(stopwatch,
              fmt::format("{}: {} as {}, degree {}", options.output, options.subject, format.name, held.degree));
}

void export_transfer(const ExportCommand& options, const TransferFormat& format) {
  const Stopwatch stopwatch;
  require_output(options.output, {std::string(format.ending)});
  if (options.degree || !options.window.window.empty()) {
    throw std::runtime_error(
        fmt::format("--degree, --window: {} holds transfer as it was baked; expected neither", format.name));
  }
  if (std::filesystem::is_regular_file(options.subject) && !is_transfer_file(options.subject)) {
    throw std::runtime_error(
        fmt::format("{}: {} holds transfer; expected a file of `prt bake`", options.subject, format.name));
  }
  output::require_no_input(options.output, {options.subject});
  const Transfer transfer = read_transfer(options.subject, vertex_kinds());
  if (!transfer.mesh.brdf.empty() || !transfer.mesh.normal_map.empty()) {
    say(fmt::format("{} holds no tables of BRDFs and no normal maps: they are left out", format.name));
  }
  std::string bytes;
  try {
    bytes = format.write(transfer);
  } catch (const std::runtime_error& flaw) {
    throw std::runtime_error(fmt::format("{}: {}: {}", options.subject, format.name, flaw.what()));
  }
  output::write_file(options.output, bytes);
  report_time(stopwatch,
              fmt::format("{}: {} vertices as {}", options.output, transfer.mesh.positions.size(), format.name));
}

void run_export(const ExportCommand& options) {
  if (const LightFormat* format = formats::find_light_format(options.format)) return export_light(options, *format);
  export_transfer(options, *formats::find_transfer_format(options.format));
}

void run_import(const std::string& file) {
  const Stopwatch stopwatch;
  const formats::ImportedLight imported = formats::import_light(file);
  Json out = {{"file", std::filesystem::path(file).filename().string()}, {"format", imported.format->name}};
  out.update(coefficients_json(imported.light));
  print_json(out);
  report_time(stopwatch, fmt::format("{}: {}, degree {}", file, imported.format->name, imported.light.degree));
}

}  // namespace

void add_export_command(CLI::App& tool) {
  auto options = std::make_shared<ExportCommand>();
  CLI::App& command = *tool.add_subcommand("export", "write a light or transfer in the format of an engine");
  command
      .add_option("SUBJECT", options->subject,
                  "a light (constant, overcast, a picture, a .json file of lights or of `prt project`), or a transfer "
                  "file for glb, ply and npz")
      ->required();
  command.add_option("--to", options->format, "format (prt/FORMATS.md)")
      ->required()
      ->check(CLI::IsMember(format_names()));
  command.add_option("-o,--output", options->output, "file to write")->required();
  command.add_option("--degree", options->degree,
                     "SH degree of the light; default: that of its coefficients as far as the format goes, else 2");
  add_mapping_to(command, options->mapping);
  options->window.add_to(command);
  command.add_flag("--strict", options->strict, "refuse input that would otherwise be mended with a warning");
  run_with_threads(command, options, run_export);
}

void add_import_command(CLI::App& tool) {
  auto file = std::make_shared<std::string>();
  CLI::App& command = *tool.add_subcommand("import", "print the SH coefficients of an engine's light as JSON");
  command.add_option("FILE", *file, "a light that `prt export` or an engine wrote (prt/FORMATS.md)")->required();
  command.callback([file] { run_import(*file); });
}

}  // namespace sh::prt
