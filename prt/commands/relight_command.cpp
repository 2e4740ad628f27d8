// `prt relight FILE -o out.ply`: exit radiance per vertex under a light, of a baked mesh or of a stage.
#include <fmt/format.h>

#include <memory>

#include "prt/commands/frames.hpp"
#include "prt/commands/subject.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {
namespace {

struct Options {
  SubjectOptions subject;
  std::string output;
  int frames = 1;
  int threads = 0;
};

void relight_frame(const Options& options, Subject& subject, int frame) {
  const std::vector<Pose> poses = subject.poses_at(static_cast<double>(frame) / options.frames);
  const Stopwatch stopwatch;
  const std::vector<Eigen::Vector3f> radiance = subject.radiance(poses, Eigen::Matrix3d::Identity());
  report_time(stopwatch, fmt::format("relit {} vertices", radiance.size()));
  const Mesh mesh = subject.mesh(poses);
  const std::string name = frame_name(options.output, frame, options.frames);
  write_ply(name, mesh, radiance);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& value : radiance) mean += value.cast<double>() / static_cast<double>(radiance.size());
  fmt::print(stderr, "prt: {}: {} vertices, {} faces, mean exit radiance {:.4g} {:.4g} {:.4g}\n", name, radiance.size(),
             mesh.faces.size(), mean.x(), mean.y(), mean.z());
}

void run(const Options& options) {
  require_frames(options.frames);
  require_writable(frame_name(options.output, 0, options.frames));
  Subject subject(options.subject);
  for (int frame = 0; frame < options.frames; ++frame) relight_frame(options, subject, frame);
}

}  // namespace

void add_relight_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("relight", "write a PLY mesh with the exit radiance of every vertex");
  options->subject.add_to(*command);
  command->add_option("-o,--output", options->output, "PLY file to write; frames become out_000.ply, ...")->required();
  command->add_option("--frames", options->frames, "number of meshes in the time in which a stage moves")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "number of threads; 0: every core")->capture_default_str();
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
