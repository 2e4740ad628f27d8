// `prt relight FILE -o out.ply`: exit radiance per vertex under a light.
#include <fmt/format.h>

#include <memory>

#include "prt/commands/commands.hpp"
#include "prt/commands/shading_options.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string transfer;
  std::string output;
  LightOptions light;
  ShadingOptions shading;
  int threads = 0;
};

void run(const Options& options) {
  require_writable(options.output);
  const Transfer transfer = read_transfer(options.transfer);
  const LightCoefficients light =
      options.shading.light(choose_light(options.light).lights, transfer, options.light.window);
  const Stopwatch stopwatch;
  const std::vector<Eigen::Vector3f> radiance = options.shading.shade(transfer, light);
  stopwatch.report(fmt::format("relit {} vertices", radiance.size()));
  write_ply(options.output, transfer.mesh, radiance);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& value : radiance) {
    mean += value.cast<double>() / static_cast<double>(radiance.size());
  }
  fmt::print(stderr, "prt: {}: {} vertices, {} faces, mean exit radiance {:.4g} {:.4g} {:.4g}\n", options.output,
             radiance.size(), transfer.mesh.faces.size(), mean.x(), mean.y(), mean.z());
}

}  // namespace

void add_relight_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("relight", "write a PLY mesh with the exit radiance of every vertex");
  command->add_option("FILE", options->transfer, "what `prt bake` made")->required();
  command->add_option("-o,--output", options->output, "PLY file to write")->required();
  command->add_option("--threads", options->threads, "0: every core")->capture_default_str();
  options->light.add_to(*command);
  options->shading.add_to(*command);
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
