// `prt grid SCENE -o FILE.png`: degree x size of the light x window in one picture.
#include <fmt/format.h>

#include <algorithm>

#include "numeric/output/atomic_file.hpp"
#include "prt/bake/bake.hpp"
#include "prt/commands/light_grid.hpp"
#include "prt/commands/medium_commands.hpp"

namespace sh::prt {
namespace {

struct GridOptions {
  std::string scene;
  std::string output;
  LightGrid grid;
  std::vector<double> direction;
  bool strict = false;
  int threads = 0;
};

Transfer shadowed(Scene scene, int degree) {
  scene.mesh.emission.clear();
  scene.bake.kind = &kShadowed;
  scene.bake.degree = degree;
  scene.plan.mode = PlanMode::kNone;
  return bake({std::move(scene)});
}

void run_grid_command(const GridOptions& options) {
  const Stopwatch stopwatch;
  require_output(options.output, {".png"});
  LightGrid grid = options.grid;
  if (!options.direction.empty()) grid.direction = Eigen::Map<const Eigen::Vector3d>(options.direction.data());
  const Scene scene = load_scene(options.scene, on_flaw(options.strict));
  require_meshes(scene, "a grid of lights");
  if (!scene.mesh.mirror.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: has mirrors, which the grid does not follow; expected a scene without mirrors", scene.name));
  }
  output::require_no_input(options.output, scene.files);
  const std::vector<GridRow> rows = grid_rows(grid);
  const int degree = *std::max_element(grid.degrees.begin(), grid.degrees.end());
  output::write_file(options.output, draw_light_grid(shadowed(scene, degree), scene.camera, grid, rows));
  report_time(stopwatch, fmt::format("drew {} under {} lights at {} degrees, without and with window", scene.name,
                                     grid.half_angles.size(), grid.degrees.size()));
}

}  // namespace

void add_grid_command(CLI::App& tool) {
  auto options = std::make_shared<GridOptions>();
  CLI::App& command = *tool.add_subcommand(
      "grid", "draw a scene's shadows under lights of several sizes, at several degrees, without and with window");
  command.add_option("SCENE", options->scene, "a scene's JSON file, `demo` or `disc`, the embedded scenes")->required();
  command.add_option("-o,--output", options->output, "PNG file to write")->required();
  command.add_option("--half-angles", options->grid.half_angles, "of the discs of light, in degrees: a row each")
      ->expected(1, 16);
  command.add_option("--degrees", options->grid.degrees, "of the light: a column each, twice")
      ->expected(1, kMaxDegree + 1)
      ->check(CLI::Range(0, kMaxDegree));
  command.add_option("--direction", options->direction, "X,Y,Z: towards the light; default: -0.5,0.5,0.7")
      ->delimiter(',')
      ->expected(3);
  command.add_option("--width", options->grid.width, "width of the picture in pixels");
  options->grid.window.add_to(command);
  command.add_flag("--strict", options->strict, "refuse input that would otherwise be mended with a warning");
  run_with_threads(command, options, run_grid_command);
}

}  // namespace sh::prt
