// `prt render FILE -o out.png`: pictures of a baked mesh, a stage or a medium, one or a sequence.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "prt/commands/shown.hpp"
#include "prt/image/tone_map.hpp"
#include "prt/runtime/render.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {
namespace {

constexpr std::array<std::string_view, 4> kTurntables = {"none", "light", "camera", "object"};
constexpr std::array<std::string_view, 3> kTones = {"neutral", "reinhard", "linear"};

struct RenderCommand {
  SubjectOptions subject;
  std::string output;
  PictureSize size;
  int frames = 1;
  std::string turntable;  // empty: light for a baked mesh, none for a stage
  AnimationOptions animation;
  std::optional<float> fixed_exposure;
  float exposure_stops = 0.0F;
  std::string tone = "neutral";
  std::string background = "auto";
  int threads = 0;
};

/// The background of the mesh: the light, or a gray that does not depend on the exposure. `auto` shows the light if it
/// is a picture, because other skies are black below the horizon.
bool shows_light(const std::string& background, const std::vector<Light>& lights) {
  const auto is_picture = [](const Light& light) { return light.image != nullptr; };
  return background == "light" || (background == "auto" && std::any_of(lights.begin(), lights.end(), is_picture));
}

Background background(bool show_light, const std::vector<Light>& lights) {
  if (show_light) {
    return [lights](const Eigen::Vector3f& direction) { return radiance(lights, direction.cast<double>()); };
  }
  return [](const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f(Eigen::Vector3f::Zero()); };
}

/// Adds gray of linear 0.3 after exposure for samples that miss the mesh.
void put_on_gray(Picture& picture, float exposure) {
  constexpr float kGray = 0.3F;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    picture.radiance[i].array() += (1.0F - picture.coverage[i]) * kGray / exposure;
  }
}

void check(const RenderCommand& options) {
  require_picture_size(options.size);
  require_stops(options.exposure_stops);
  if (!options.subject.local.empty() && options.turntable == "object") {
    throw std::invalid_argument("--turntable object: moves near lights too; with --local turn the camera or the light");
  }
  if (options.fixed_exposure && !(*options.fixed_exposure >= 1e-20F && *options.fixed_exposure <= 1e20F)) {
    throw std::invalid_argument(
        fmt::format("--fixed-exposure {}: expected a factor from 1e-20 to 1e20", *options.fixed_exposure));
  }
}

/// A baked mesh or a stage. Places meshes and rebuilds their tree only if something has moved.
class ShownSubject : public Shown {
 public:
  explicit ShownSubject(const RenderCommand& options) : options_(options), subject_(options.subject) {}

  [[nodiscard]] const std::vector<Light>& lights() const override { return subject_.lights(); }
  [[nodiscard]] Turntable turntable() const override {
    return subject_.is_stage() ? Turntable::kNone : Turntable::kLight;
  }
  void require_no_input(const std::string& output) const override { subject_.require_no_input(output); }

  const Camera& place(double time) override {
    const std::vector<Pose> poses = subject_.poses_at(time);
    if (!tracer_ || poses != poses_) {
      poses_ = poses;
      mesh_ = subject_.mesh(poses_);
      tracer_ = std::make_unique<Tracer>(mesh_, options_.threads);
    }
    if (!camera_) camera_ = subject_.camera().value_or(default_camera(mesh_, options_.size));
    return *camera_;
  }

  [[nodiscard]] Picture picture(const View& view, const Background& background, const std::string& what) override {
    const Subject::Seen seen = subject_.seen(poses_, view.light_turn, view.camera.position);
    return render(mesh_, *tracer_, seen.surface, view.camera, options_.size, background, what, seen.veil);
  }

 private:
  const RenderCommand& options_;
  Subject subject_;
  std::vector<Pose> poses_;
  Mesh mesh_;
  std::unique_ptr<Tracer> tracer_;
  std::optional<Camera> camera_;
};

/// Renders frame after frame.
class Sequence {
 public:
  Sequence(const RenderCommand& options, Shown& shown, PictureFiles& files)
      : options_(options),
        shown_(shown),
        files_(files),
        show_light_(shows_light(options.background, shown.lights())),
        turntable_(value_called<Turntable>(options.turntable, kTurntables).value_or(shown.turntable())),
        tone_(value_called<ToneCurve>(options.tone, kTones).value()) {}

  void render_frame(int frame) {
    const double time = static_cast<double>(frame) / options_.frames;
    const View view = view_at(turntable_, shown_.place(time), time);
    Picture picture =
        shown_.picture(view, background(show_light_, turned(shown_.lights(), view.light_turn)),
                       fmt::format("render {} ({} of {})", files_.name(frame), frame + 1, options_.frames));
    if (frame == 0) {  // one exposure for all frames: the picture must not flicker
      exposure_ = options_.fixed_exposure.value_or(automatic_exposure(picture.covered(shown_.least_coverage()))) *
                  std::exp2(options_.exposure_stops);
    }
    if (!show_light_) put_on_gray(picture, exposure_);
    files_.add(frame, tone_map(picture.radiance, exposure_, tone_));
  }

  [[nodiscard]] float exposure() const { return exposure_; }

 private:
  const RenderCommand& options_;
  Shown& shown_;
  PictureFiles& files_;
  bool show_light_;
  Turntable turntable_;
  ToneCurve tone_;
  float exposure_ = 1.0F;
};

void run_render_command(const RenderCommand& options) {
  check(options);
  PictureFiles files(options.output, options.frames, options.size.width, options.size.height, options.animation);
  const Stopwatch stopwatch;
  std::unique_ptr<Shown> shown = shown_medium(options.subject, options.size);
  if (!shown) shown = std::make_unique<ShownSubject>(options);
  for (int frame = 0; frame < options.frames; ++frame) shown->require_no_input(files.name(frame));
  Sequence sequence(options, *shown, files);
  for (int frame = 0; frame < options.frames; ++frame) sequence.render_frame(frame);
  files.finish();
  report_time(stopwatch, fmt::format("rendered {} picture{} of {} x {} pixels, {} samples each, exposure {:.4g}",
                                     options.frames, options.frames == 1 ? "" : "s", options.size.width,
                                     options.size.height, options.size.samples, sequence.exposure()));
}

}  // namespace

void add_render_command(CLI::App& tool) {
  auto options = std::make_shared<RenderCommand>();
  CLI::App& command =
      *tool.add_subcommand("render", "render a baked mesh, a stage or a medium to PNG or animated WebP");
  options->subject.add_to(command);
  command
      .add_option("-o,--output", options->output,
                  "PNG file to write, frames become out_000.png, ...; or one .webp file with all frames")
      ->required();
  command.add_flag("--sharp", options->subject.sharp,
                   "lobes, and those nearest to BRDFs, show the bands of the light above the transfer's degree, too: "
                   "prefiltered, shadowed at the mirrored direction, without bounces");
  command.add_option("--width", options->size.width, "width in pixels");
  command.add_option("--height", options->size.height, "height in pixels");
  command.add_option("--samples", options->size.samples, "rays for each pixel");
  command.add_option("--exposure", options->exposure_stops, "stops brighter than the automatic or fixed exposure");
  command.add_option("--fixed-exposure", options->fixed_exposure,
                     "factor on radiance; default: brings the 95th percentile of the first picture to 0.7");
  command.add_option("--tone", options->tone, "neutral (Khronos PBR), reinhard, or linear, which clips")
      ->check(CLI::IsMember(std::vector<std::string>(kTones.begin(), kTones.end())));
  command
      .add_option("--background", options->background,
                  "background of the mesh: light, grey, or auto (light if it is a picture)")
      ->check(CLI::IsMember({"auto", "light", "grey"}));
  command.add_option("--frames", options->frames, "number of pictures, at times 0, 1/N, 2/N, ... of a sequence");
  command
      .add_option("--turntable", options->turntable,
                  "turns by 360/N degrees for each frame: none, light, camera or object; default: light, none for a "
                  "stage")
      ->check(CLI::IsMember(std::vector<std::string>(kTurntables.begin(), kTurntables.end())));
  command.add_option("--fps", options->animation.frames_a_second, "frames a second of a .webp file");
  command.add_option("--quality", options->animation.quality, "quality of a .webp file, 0 to 100; 100 is lossless");
  run_with_threads(command, options, run_render_command);
}

}  // namespace sh::prt
