// `prt render FILE -o out.png`: pictures of a baked mesh, the light turned from frame to frame.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "numeric/output/png.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/shading_options.hpp"
#include "prt/image/tone_map.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/render.hpp"
#include "prt/scene/default_camera.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string transfer;
  std::string output;
  LightOptions light;
  ShadingOptions shading;
  PictureSize size;
  int frames = 1;
  float exposure_stops = 0.0F;
  std::string background = "auto";
  int threads = 0;
};

/// out.png -> out_000.png ...; a single frame keeps its name.
std::string frame_name(const Options& options, int frame) {
  if (options.frames == 1) {
    return options.output;
  }
  const std::filesystem::path path(options.output);
  const std::string name = fmt::format("{}_{:03}{}", path.stem().string(), frame, path.extension().string());
  return (path.parent_path() / name).string();
}

/// What stands behind the mesh: the light, or a grey that does not depend on the exposure. `auto`: the light where it
/// is a picture; a sky without one is black below its horizon.
bool shows_light(const Options& options, const std::vector<Light>& lights) {
  const auto is_picture = [](const Light& light) { return light.image != nullptr; };
  return options.background == "light" ||
         (options.background == "auto" && std::any_of(lights.begin(), lights.end(), is_picture));
}

Background background(bool show_light, const std::vector<Light>& lights) {
  if (show_light) {
    return [lights](const Eigen::Vector3f& direction) { return radiance(lights, direction.cast<double>()); };
  }
  return [](const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f(Eigen::Vector3f::Zero()); };
}

/// Adds grey of linear 0.3 after exposure where samples missed the mesh.
void put_on_grey(Picture& picture, float exposure) {
  constexpr float kGrey = 0.3F;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    picture.radiance[i].array() += (1.0F - picture.coverage[i]) * kGrey / exposure;
  }
}

void check(const Options& options) {
  require_picture_size(options.size);
  constexpr int kMaxFrames = 1000;  // three digits in the names
  if (options.frames < 1 || options.frames > kMaxFrames) {
    throw std::invalid_argument(fmt::format("--frames {}: 1 to {} can be made", options.frames, kMaxFrames));
  }
  constexpr float kMaxStops = 64.0F;
  if (!(std::abs(options.exposure_stops) <= kMaxStops)) {
    throw std::invalid_argument(
        fmt::format("--exposure {}: must be within {} stops", options.exposure_stops, kMaxStops));
  }
  require_writable(frame_name(options, 0));
}

void run(const Options& options) {
  check(options);
  const Stopwatch stopwatch;
  const Transfer transfer = read_transfer(options.transfer);
  const ChosenLight chosen = choose_light(options.light);
  const LightCoefficients light = options.shading.light(chosen.lights, transfer, options.light.window);
  const Camera camera = chosen.camera.empty() ? default_camera(transfer.mesh, options.size) : chosen.camera.front();
  const Tracer tracer(transfer.mesh, options.threads);
  const bool show_light = shows_light(options, chosen.lights);
  float exposure = 0.0F;
  for (int frame = 0; frame < options.frames; ++frame) {
    const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d::UnitZ(), 360.0 * frame / options.frames);
    const std::vector<Eigen::Vector3f> radiance = options.shading.shade(transfer, turned(light, r));
    const std::string name = frame_name(options, frame);
    Picture picture = render(transfer.mesh, tracer, radiance, camera, options.size,
                             background(show_light, turned(chosen.lights, r)), fmt::format("render {}", name));
    if (frame == 0) {  // one exposure for all frames: the picture must not flicker
      exposure = automatic_exposure(picture.covered()) * std::exp2(options.exposure_stops);
    }
    if (!show_light) {
      put_on_grey(picture, exposure);
    }
    output::write_png(name, picture.width, picture.height, tone_map(picture.radiance, exposure));
  }
  stopwatch.report(fmt::format("rendered {} picture{} of {} x {} pixels, {} samples each, exposure {:.4g}",
                               options.frames, options.frames == 1 ? "" : "s", options.size.width, options.size.height,
                               options.size.samples, exposure));
}

}  // namespace

void add_render_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("render", "render a baked mesh to PNG");
  command->add_option("FILE", options->transfer, "what `prt bake` made")->required();
  command->add_option("-o,--output", options->output, "PNG file to write; frames become out_000.png, ...")->required();
  command->add_option("--width", options->size.width, "pixels")->capture_default_str();
  command->add_option("--height", options->size.height, "pixels")->capture_default_str();
  command->add_option("--samples", options->size.samples, "rays a pixel")->capture_default_str();
  command->add_option("--frames", options->frames, "pictures, the light turned about +z by 360/N degrees each")
      ->capture_default_str();
  command->add_option("--exposure", options->exposure_stops, "stops brighter than the automatic exposure")
      ->capture_default_str();
  command
      ->add_option("--background", options->background,
                   "behind the mesh: light, grey, or auto: light where it is a picture")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "light", "grey"}));
  command->add_option("--threads", options->threads, "0: every core")->capture_default_str();
  options->light.add_to(*command);
  options->shading.add_to(*command);
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
