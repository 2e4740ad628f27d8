#include "prt/commands/lit_place.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "prt/bake/bake.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/say.hpp"
#include "prt/scene/json_reader.hpp"

namespace sh::prt {
namespace {

// Scenes have meshes, stages have objects.
bool is_scene(const std::string& file) {
  if (file == "demo" || file == "disc" || has_mesh_name(file)) return true;
  return std::filesystem::path(file).extension() == ".json" && !read_json(file).contains("objects");
}

// A scene is baked, and lights itself unless the options name another light.
Subject subject_of(SubjectOptions options) {
  if (!is_scene(options.file)) return Subject(options);
  if (!options.without.empty()) {
    throw std::runtime_error(fmt::format("{}: --without: expected a stage, whose objects have names", options.file));
  }
  if (options.light.scene.empty() && options.light.light.empty()) options.light.scene = options.file;
  BakeSettings settings;
  settings.on_flaw = on_flaw(options.light.strict);
  Scene scene = load_scene(options.file, settings.on_flaw);
  require_meshes(scene, "light that is sampled");
  return {options, bake(planned(BakeJob(std::move(scene), settings)))};
}

const LitPlaceOptions& checked(const LitPlaceOptions& options) {
  require_degree(options.degree);
  require_size(options.size);
  if (!(options.time >= 0.0 && options.time <= 1.0)) {
    throw std::invalid_argument(fmt::format("--time {}: expected 0 to 1", options.time));
  }
  return options;
}

}  // namespace

void LitPlaceOptions::add_to(CLI::App& command) {
  subject.add_to(command);
  command.get_option("FILE")->description("transfer file, stage, or a scene, which is baked first");
  command.remove_option(command.get_option("--degree"));  // of surfaces: they keep their own here
  command.add_option("--degree", degree, "SH degree of the light, 0 to 10");
  command.add_option("--face", size.face, "pixels along the edge of each of the six pictures");
  command.add_option("--samples", size.samples, "rays along the edge of each pixel");
  command.add_option("--without", subject.without,
                     "an object of a stage that is not there: the one that the light is for");
  command.add_option("--time", time, "time of a stage that moves, 0 to 1");
}

LitPlace::LitPlace(const LitPlaceOptions& options)
    : subject_(subject_of(checked(options).subject)),
      poses_(subject_.poses_at(options.time)),
      mesh_(subject_.mesh(poses_)),
      tracer_(mesh_),
      surface_(subject_.surface(poses_, Eigen::Matrix3d::Identity())) {
  if (subject_.has_media()) say(options.subject.file + ": the point sees no media, but the shadows of their volumes");
}

}  // namespace sh::prt
