#include "prt/commands/subject.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

/// Reports the reductions that a time limit caused in a bake.
std::string coarseness(const std::string& file, const Transfer& transfer) {
  std::string line = fmt::format("{}: coarser than was asked for:", file);
  if (transfer.missing.directions > 0) {
    line += fmt::format(" {} of {} directions", transfer.directions, transfer.missing.directions);
  }
  if (transfer.missing.tolerance > 0.0) {
    line += fmt::format("{} bounces to {:.2g} of the largest coefficient, not {:.2g}",
                        transfer.missing.directions > 0 ? "," : "", transfer.bounces.bound / transfer.bounces.largest,
                        transfer.missing.tolerance);
  }
  return line;
}

bool names_stage(const std::string& file) { return std::filesystem::path(file).extension() == ".json"; }

}  // namespace

void SubjectOptions::add_to(CLI::App& command) {
  command.add_option("FILE", file, "transfer file from `prt bake`, or a stage (.json)")->required();
  command.add_option("--transfers", transfers, "folder of a stage's transfer files; default: the stage's own");
  light.add_to(command);
  command.add_option("--degree", shading.degree, "ignore higher bands; 1 takes 4 coefficients for each vertex")
      ->capture_default_str();
  command.add_flag("--white", shading.white, "use the light's luminance in every channel");
  command
      .add_option("--recolor", shading.recolour, "R G B: linear albedo instead of the transfer's (not with bounces)")
      ->expected(3);
  command
      .add_option("--local", local,
                  "sample sphere and polygon lights at this many points of the mesh, or at the corners of an "
                  "`octahedron` around it (not with bounces)")
      ->excludes("--window");
}

Subject::Subject(const SubjectOptions& options)
    : is_stage_(names_stage(options.file)),
      on_flaw_(options.light.on_flaw()),
      stage_(is_stage_ ? load_stage(options.file, options.transfers) : stage_of(read_transfer(options.file))),
      camera_(stage_.camera),
      lights_([&] {
        ChosenLight chosen = choose_light(options.light, stage_.lights);
        if (!chosen.camera.empty()) camera_ = chosen.camera;
        return chosen.lights;
      }()),
      lighting_(
          stage_, [&](int degree) { return project_windowed(lights_, degree, options.light.window); },
          options.shading) {
  for (const StageObject& object : stage_.objects) {
    if (object.transfer->missing.any()) tell_once(coarseness(is_stage_ ? object.name : options.file, *object.transfer));
  }
  if (!options.local.empty()) local_.emplace(options, stage_, is_stage_, lights_);
}

void Subject::tell_once(const std::string& line) {
  if (told_.insert(line).second) report_flaw(on_flaw_, line);
}

std::vector<Pose> Subject::poses_at(double time) {
  std::vector<Pose> poses = sh::prt::poses_at(stage_, time);
  for (const std::string& line : overlaps(stage_, poses)) tell_once(line);
  return poses;
}

}  // namespace sh::prt
