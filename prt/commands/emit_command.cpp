// `prt emit FILE --lang cpp -o DIR`: the run time of one transfer file as source code.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/emit/emit.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

struct EmitCommand {
  std::string file;
  std::string language = "cpp";
  std::string folder;
  std::string scene;
  std::string turns = "about_z";
  std::string shade = "vertex";
};

/// The coefficients that the lights of the scene have in any allowed rotation; empty: all of them.
std::vector<std::uint32_t> needed_by(const EmitCommand& options, int degree) {
  if (options.scene.empty()) return {};
  LightOptions light;
  light.scene = options.scene;
  const LightCoefficients coefficients = project_windowed(choose_light(light).lights, degree, {});
  std::vector<std::uint32_t> needed =
      TurningLight(coefficients, *value_called<LightTurns>(options.turns, kLightTurnsNames)).needed();
  if (needed.empty()) throw std::runtime_error(options.scene + ": expected lights, all of its coefficients are zero");
  if (needed.size() == coefficients.bands_squared()) needed.clear();
  return needed;
}

/// Letters, digits and _ of the file's name.
std::string name_of_file(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

void run_emit(const EmitCommand& options) {
  const Stopwatch stopwatch;
  const Transfer transfer = read_transfer(options.file);
  const EmitOptions emitted_options{name_of_file(options.file), needed_by(options, transfer.degree()),
                                    options.shade == "pixel"};
  Emitted emitted;
  try {
    emitted = options.language == "cpp" ? emit_cpp(transfer, emitted_options)
                                        : emit_glsl(transfer, emitted_options, options.language == "glsl-es");
  } catch (const std::invalid_argument& flaw) {
    throw std::runtime_error(fmt::format("{}: {}", options.file, flaw.what()));
  }
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed);
  if (failed)
    throw std::runtime_error(fmt::format("{}: cannot make this folder: {}", options.folder, failed.message()));
  const auto path_of = [&](const EmittedFile& file) {
    return (std::filesystem::path(options.folder) / file.name).string();
  };
  for (const EmittedFile& file : emitted.files) {
    output::require_no_input(path_of(file), {options.file, options.scene});
  }
  for (const EmittedFile& file : emitted.files) {
    output::write_file(path_of(file), file.bytes);
    say(fmt::format("{}: {} bytes", path_of(file), file.bytes.size()));
  }
  say(fmt::format("{} operations a vertex for the light, {} without the mask", emitted.cost.operations,
                  emitted.cost.unmasked));
  report_time(stopwatch, "emitted the run time of " + options.file);
}

}  // namespace

void add_emit_command(CLI::App& tool) {
  auto options = std::make_shared<EmitCommand>();
  CLI::App& command = *tool.add_subcommand("emit", "write the run time of one transfer file as source code");
  command.add_option("FILE", options->file, "transfer file from `prt bake`")->required();
  command.add_option("--lang", options->language, "language")->check(CLI::IsMember({"cpp", "glsl", "glsl-es"}));
  command
      .add_option(
          "-o,--output", options->folder,
          "folder to write relight.hpp (or relight.vert, relight.json and, for clusters, lit.vert) and relight.bin to")
      ->required();
  command
      .add_option("--shade", options->shade,
                  "where glossy surfaces meet the view: `vertex`, or `pixel`, with a fragment shader relight.frag and "
                  "normal maps")
      ->check(CLI::IsMember({"vertex", "pixel"}));
  command.add_option("--scene", options->scene,
                     "a scene whose lights are the only ones: coefficients that they lack cost nothing");
  command.add_option("--light-turns", options->turns, "later rotations of these lights")
      ->check(CLI::IsMember(std::vector<std::string>(kLightTurnsNames.begin(), kLightTurnsNames.end())));
  command.callback([options] { run_emit(*options); });
}

}  // namespace sh::prt
