// prt/commands/subject.hpp
#include "prt/commands/subject.hpp"

#include <filesystem>

#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

bool names_stage(const std::string& file) { return std::filesystem::path(file).extension() == ".json"; }

}  // namespace

void SubjectOptions::add_to(CLI::App& command) {
  command.add_option("FILE", file, "what `prt bake` made, or a stage of several (.json)")->required();
  command.add_option("--transfers", transfers, "folder of a stage's transfer files; default: the stage's own");
  light.add_to(command);
  command.add_option("--degree", shading.degree, "leave out the bands above; 1 takes 4 coefficients a vertex")
      ->capture_default_str();
  command.add_flag("--white", shading.white, "the light's luminance in every channel");
  command
      .add_option("--recolor", shading.recolour, "R G B: linear albedo instead of the transfer's (not with bounces)")
      ->expected(3);
}

Subject::Subject(const SubjectOptions& options)
    : is_stage_(names_stage(options.file)),
      on_flaw_(options.light.on_flaw()),
      stage_(is_stage_ ? load_stage(options.file, options.transfers) : stage_of(read_transfer(options.file))),
      camera_(stage_.camera),
      lights_([&] {
        ChosenLight chosen = choose_light(options.light, stage_.lights);
        if (!chosen.camera.empty()) {
          camera_ = chosen.camera;
        }
        return chosen.lights;
      }()),
      lighting_(
          stage_, [&](int degree) { return project_windowed(lights_, degree, options.light.window); },
          options.shading) {}

std::vector<Pose> Subject::poses_at(double time) {
  std::vector<Pose> poses = sh::prt::poses_at(stage_, time);
  for (const std::string& line : overlaps(stage_, poses)) {
    if (told_.insert(line).second) {
      report_flaw(on_flaw_, line);
    }
  }
  return poses;
}

}  // namespace sh::prt
