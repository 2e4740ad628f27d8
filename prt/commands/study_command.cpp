// `prt study SCENE --out DIR`: measures error against time for every setting of a bake; JSON and charts.
#include <fmt/format.h>

#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/study/error_picture.hpp"
#include "prt/study/study.hpp"

namespace sh::prt {
namespace {

struct StudyCommandOptions {
  std::string scene;
  std::string out;
  bool quick = false;
  bool strict = false;
  int threads = 0;
  std::optional<std::size_t> vertices;
  std::optional<int> most_directions;
  std::string instruction_set;
};

StudyOptions study_options(const StudyCommandOptions& options) {
  StudyOptions result;
  if (options.quick) {
    result.vertices = 250;
    result.most_directions = 4096;
    result.bounce_directions = 128;
    result.paths = 512;
    result.picture_reference = 1024;
  }
  result.vertices = options.vertices.value_or(result.vertices);
  result.most_directions = options.most_directions.value_or(result.most_directions);
  result.instruction_set = options.instruction_set;
  return result;
}

std::string study_file(const std::filesystem::path& folder) { return (folder / "study.json").string(); }

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw std::runtime_error(
        fmt::format("--out {}: cannot make this folder: {}", folder, error ? error.message() : "a file is in the way"));
  }
  require_output(study_file(folder));
}

// Writes the files of the last part; the files of earlier parts exist already.
void write_pictures(const std::filesystem::path& folder, const StudyPart& part, const Scene& scene) {
  if (part.fields.empty()) return;
  PictureSize size;
  size.samples = 9;
  const Tracer tracer(scene.mesh);
  for (const ErrorField& field : part.fields) {
    const std::string file = (folder / ("errors_" + field.name + ".png")).string();
    output::write_file(
        file, error_picture(scene.mesh, tracer, field.relative, scene.camera, size, field.title, "study: picture"));
  }
}

void write(const std::string& folder, const Study& study, const Scene& scene) {
  const std::filesystem::path path(folder);
  write_pictures(path, study.parts.back(), scene);
  for (const StudyChart& chart : study_charts(study)) output::write_file((path / chart.file).string(), chart.svg);
  if (const std::string table = table_csv(study); !table.empty()) {
    output::write_file((path / "table.csv").string(), table);
    output::write_file((path / "table.md").string(), table_markdown(study));
  }
  output::write_file(study_file(path),
                     study_json(study, scene).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void run_study_command(const StudyCommandOptions& options) {
  const Stopwatch stopwatch;
  make_folder(options.out);
  const Scene scene = load_scene(options.scene, on_flaw(options.strict));
  require_meshes(scene, "a study");
  output::require_no_input(study_file(options.out), scene.files);
  const Study study =
      run_study(scene, study_options(options), [&](const Study& so_far) { write(options.out, so_far, scene); });
  report_time(stopwatch, fmt::format("studied {} of {} vertices of {}, into {}", study.studied, study.vertices,
                                     study.scene, options.out));
}

}  // namespace

void add_study_command(CLI::App& tool) {
  auto options = std::make_shared<StudyCommandOptions>();
  CLI::App& command = *tool.add_subcommand(
      "study", "measure error against time: directions, degree, bounces, storage; of glossy scenes the run time");
  command.add_option("SCENE", options->scene, "a scene's JSON file, `demo` or `disc`, the embedded scenes")->required();
  command.add_option("--out", options->out, "folder for study.json and the charts; created if necessary")->required();
  command.add_flag("--quick", options->quick, "take a few seconds: fewer vertices and directions");
  command.add_option("--vertices", options->vertices, "approximate number of studied vertices, every k-th of the mesh")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--most-directions", options->most_directions,
                     "study 256, 512, ... up to this number; the reference has four times as many");
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays: sse4.2, avx, avx2 or avx512");
  command.add_flag("--strict", options->strict, "refuse input that would otherwise be mended with a warning");
  run_with_threads(command, options, run_study_command, "; timed work runs on one");
}

}  // namespace sh::prt
