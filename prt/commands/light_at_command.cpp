// `prt light-at SUBJECT --at X,Y,Z`: the light at a point of a lit scene, as coefficients in JSON.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "prt/bake/bake.hpp"
#include "prt/commands/subject.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/runtime/sampled_light.hpp"
#include "prt/scene/coefficients_json.hpp"
#include "prt/scene/json_reader.hpp"

namespace sh::prt {
namespace {

// The sizes of the table of errors, and the size that they are compared with.
constexpr int kFaceSizes[] = {4, 8, 16, 32};
constexpr CubeSize kFinest{64, 4};

struct LightAtCommand {
  SubjectOptions subject;
  std::vector<double> at;
  int degree = 2;
  CubeSize size;
  double time = 0.0;
  bool errors = false;
  int threads = 0;
};

// Scenes have meshes, stages have objects.
bool is_scene(const std::string& file) {
  if (file == "demo" || file == "disc" || has_mesh_name(file)) return true;
  return std::filesystem::path(file).extension() == ".json" && !read_json(file).contains("objects");
}

// A scene is baked first, and lights itself unless the options name another light.
Subject subject_of(SubjectOptions options) {
  if (!is_scene(options.file)) return Subject(options);
  if (!options.without.empty()) {
    throw std::runtime_error(fmt::format("{}: --without: expected a stage, whose objects have names", options.file));
  }
  if (options.light.scene.empty() && options.light.light.empty()) options.light.scene = options.file;
  BakeSettings settings;
  settings.on_flaw = on_flaw(options.light.strict);
  Transfer transfer = bake(planned(BakeJob(load_scene(options.file, settings.on_flaw), settings)));
  return {options, std::move(transfer)};
}

// A subject at one time, ready for rays.
class LitPlace {
 public:
  LitPlace(Subject& subject, double time)
      : lights_(subject.lights()),
        poses_(subject.poses_at(time)),
        mesh_(subject.mesh(poses_)),
        tracer_(mesh_),
        surface_(subject.surface(poses_, mesh_, Eigen::Matrix3d::Identity())) {}

  [[nodiscard]] SampledLight at(const Eigen::Vector3d& point, const CubeSize& size, int degree) const {
    return sampled_light(mesh_, tracer_, surface_, lights_, point, size, degree);
  }

 private:
  const std::vector<Light>& lights_;
  std::vector<Pose> poses_;
  Mesh mesh_;
  Tracer tracer_;
  Surface surface_;
};

// The distance of two lights by the length of the second: the root of the squared error as the paper counts it.
double distance(const LightCoefficients& light, const LightCoefficients& reference) {
  const double length = reference.matrix().norm();
  return length > 0.0 ? (light.matrix() - reference.matrix()).norm() / length : 0.0;
}

Json errors_by_size(const LitPlace& place, const Eigen::Vector3d& point, int samples, int degree) {
  const LightCoefficients finest = place.at(point, kFinest, degree).light;
  Json errors = Json::array();
  for (const int face : kFaceSizes) {
    const double error = distance(place.at(point, {face, samples}, degree).light, finest);
    errors.push_back({{"face", face}, {"error", error}, {"squared_error", error * error}});
  }
  return errors;
}

void run_light_at(const LightAtCommand& options) {
  const Stopwatch stopwatch;
  require_degree(options.degree);
  if (!(options.time >= 0.0 && options.time <= 1.0)) {
    throw std::invalid_argument(fmt::format("--time {}: expected 0 to 1", options.time));
  }
  const Eigen::Vector3d point(options.at[0], options.at[1], options.at[2]);
  Subject subject = subject_of(options.subject);
  const LitPlace place(subject, options.time);
  const SampledLight sampled = place.at(point, options.size, options.degree);
  Json about = {{"point", json_of(point)},
                {"face", options.size.face},
                {"samples", options.size.samples},
                {"surface_share", sampled.surface_share}};
  if (options.errors) about["errors"] = errors_by_size(place, point, options.size.samples, options.degree);
  Json out = coefficients_json(sampled.light);
  out["sampled_from"] = about;
  print_json(out);
  report_time(stopwatch, fmt::format("sampled the light at {:g},{:g},{:g} by 6 x {} x {} pixels of {} rays", point.x(),
                                     point.y(), point.z(), options.size.face, options.size.face,
                                     options.size.samples * options.size.samples));
}

}  // namespace

void add_light_at_command(CLI::App& tool) {
  auto options = std::make_shared<LightAtCommand>();
  CLI::App& command =
      *tool.add_subcommand("light-at", "print the SH coefficients of the light at a point of a lit scene as JSON");
  options->subject.add_to(command);
  command.get_option("FILE")->description("transfer file, stage, or a scene, which is baked first");
  command.add_option("--at", options->at, "X,Y,Z: the point")->required()->delimiter(',')->expected(3);
  command.remove_option(command.get_option("--degree"));  // of surfaces: they keep their own here
  command.add_option("--degree", options->degree, "SH degree of the light, 0 to 10");
  command.add_option("--face", options->size.face, "pixels along the edge of each of the six pictures");
  command.add_option("--samples", options->size.samples, "rays along the edge of each pixel");
  command.add_option("--without", options->subject.without,
                     "an object of a stage that is not there: the one that the light is for");
  command.add_option("--time", options->time, "time of a stage that moves, 0 to 1");
  command.add_flag("--errors", options->errors,
                   "add the errors of pictures of 4 to 32 pixels, against 64 pixels of 4 x 4 rays");
  run_with_threads(command, options, run_light_at);
}

}  // namespace sh::prt
