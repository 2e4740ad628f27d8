#include "prt/commands/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/png.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/medium/lit_medium.hpp"
#include "prt/say.hpp"
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
                        transfer.missing.directions > 0 ? "," : "",
                        transfer.kind->has_form_factors() ? transfer.bounces.bound / transfer.bounces.largest
                                                          : transfer.bounces.residual,
                        transfer.missing.tolerance);
  }
  return line;
}

bool has_extension(const std::string& file, const char* extension) {
  return std::filesystem::path(file).extension() == extension;
}

LightSamples samples_named(const std::string& local, const Mesh& mesh) {
  if (local == "octahedron") return samples_on_octahedron(points_of(mesh));
  int k = 0;
  const auto end = std::from_chars(local.data(), local.data() + local.size(), k);
  if (end.ec != std::errc() || end.ptr != local.data() + local.size() || k < 1 || k > kMaxLightSamples) {
    throw std::runtime_error(
        fmt::format("--local {}: expected `octahedron` or a number of points from 1 to {}", local, kMaxLightSamples));
  }
  return samples_by_distance(points_of(mesh), k);
}

/// The lights; throws if `--sharp` would complete the bands that a window dampens.
ChosenLight without_windows_if_sharp(ChosenLight chosen, const SubjectOptions& options) {
  const auto has_window = [](const Light& light) { return light.spec.window.has_value(); };
  if (options.sharp &&
      (!options.light.window.window.empty() || std::any_of(chosen.lights.begin(), chosen.lights.end(), has_window))) {
    throw std::runtime_error(
        fmt::format("{}: --sharp: expected lights without a window, whose bands it completes", options.file));
  }
  return chosen;
}

/// The stage, but for the objects that are left out, with the chosen lobe.
Stage stage_without(const SubjectOptions& options) {
  Stage stage = load_stage(options.file, options.transfers);
  for (StageObject& object : stage.objects) {
    if (options.shading.lobe.empty()) break;
    options.shading.require_fit(*object.transfer, kMaxDegree);
    object.transfer = std::make_shared<const Transfer>(options.shading.with_lobe(*object.transfer));
  }
  for (const std::string& name : options.without) {
    const auto removed = std::erase_if(stage.objects, [&](const StageObject& object) { return object.name == name; });
    if (removed > 0) continue;
    throw std::runtime_error(fmt::format(
        "{}: --without {}: expected an object of the stage, by the path of its transfer", options.file, name));
  }
  if (stage.objects.empty()) {
    throw std::runtime_error(fmt::format("{}: --without: expected to leave an object", options.file));
  }
  return stage;
}

/// The points of `--local`; throws if the option does not fit the transfer.
LightSamples local_samples(const SubjectOptions& options, const Transfer& transfer, bool is_stage) {
  const auto refuse = [&](const char* why) {
    throw std::runtime_error(fmt::format("{}: --local {}: {}", options.file, options.local, why));
  };
  if (transfer.kind->is_glossy()) refuse("glossy transfer takes distant light only; diffuse transfer is needed");
  if (is_stage) refuse("a stage takes distant light only; a transfer file is needed");
  if (transfer.shape.holds_albedo) {
    refuse(
        "the bake has bounces or light through bodies, which comes from other places too; bake unshadowed or shadowed "
        "transfer");
  }
  return samples_named(options.local, transfer.mesh);
}

}  // namespace

void SubjectOptions::add_to(CLI::App& command) {
  command.add_option("FILE", file, "transfer file from `prt bake`, or a stage (.json)")->required();
  command.add_option("--transfers", transfers, "folder of a stage's transfer files; default: the stage's own");
  light.add_to(command);
  command.add_option("--degree", shading.degree, "ignore higher bands; 1 takes 4 coefficients for each vertex");
  command.add_flag("--white", shading.white, "use the light's luminance in every channel");
  command
      .add_option("--recolor,--recolour", shading.recolor,
                  "R,G,B: linear albedo instead of the transfer's (not with bounces)")
      ->default_str("")
      ->delimiter(',')
      ->expected(3);
  command
      .add_option("--lobe", shading.lobe,
                  "R,G,B,E: a lobe of this reflectance and exponent instead of lobes and BRDFs (glossy kinds, not with "
                  "bounces)")
      ->default_str("")
      ->delimiter(',')
      ->expected(4);
  command
      .add_option("--local", local,
                  "sample sphere and polygon lights at this many points of the mesh, or at the corners of an "
                  "`octahedron` around it (not with bounces)")
      ->excludes("--window");
}

Subject::Subject(const SubjectOptions& options)
    : Subject(options, has_extension(options.file, ".json"),
              has_extension(options.file, ".json") ? stage_without(options)
                                                   : stage_of(options.shading.with_lobe(read_transfer(options.file)))) {
}

Subject::Subject(const SubjectOptions& options, Transfer transfer)
    : Subject(options, false, stage_of(options.shading.with_lobe(std::move(transfer)))) {}

Subject::Subject(const SubjectOptions& options, bool is_stage, Stage stage)
    : file_(options.file),
      is_stage_(is_stage),
      on_flaw_(on_flaw(options.light.strict)),
      shading_(options.shading),
      stage_(std::move(stage)),
      chosen_(without_windows_if_sharp(choose_light(options.light, stage_.lights), options)),
      lighting_(
          stage_, [&](int degree) { return project_windowed(chosen_.lights, degree, options.light.window); }, shading_,
          chosen_.lights) {
  if (!chosen_.camera) chosen_.camera = stage_.camera;
  for (const StageObject& object : stage_.objects) {
    is_glossy_ = is_glossy_ || object.transfer->kind->is_glossy();
    if (object.transfer->missing.any()) tell_once(coarseness(is_stage_ ? object.name : options.file, *object.transfer));
  }
  if (options.sharp) {
    if (!is_glossy_ || is_stage_ || options.shading.white) {
      throw std::runtime_error(fmt::format(
          "{}: --sharp: expected a file of glossy transfer and light in color; it adds to the lobes of surfaces",
          file_));
    }
    make_sharp();
  }
  if (options.local.empty()) return;
  local_ = local_samples(options, *stage_.objects.front().transfer, is_stage_);
  if (!varies(chosen_.lights)) {
    tell_once(fmt::format("--local {}: no light is a sphere or a polygon, so that it changes nothing", options.local));
  }
}

void Subject::make_sharp() {
  const Transfer& transfer = this->transfer();
  Mesh shown = transfer.mesh;
  shown.albedo = shading_.albedo(shown);  // the color of metals
  sharp_.emplace([this](const Eigen::Vector3d& direction) { return sh::prt::radiance(chosen_.lights, direction); },
                 shading_.degree_for(transfer.degree()), std::move(shown));
  for (const FittedBrdf& fitted : sharp_->fits()) {
    say(fmt::format("above degree {}: {}", transfer.degree(), described(fitted)));
  }
}

void Subject::tell_once(const std::string& line) {
  if (told_.insert(line).second) report_flaw(on_flaw_, line);
}

std::vector<Pose> Subject::poses_at(double time) {
  std::vector<Pose> poses = sh::prt::poses_at(stage_, time);
  for (const std::string& line : overlaps(stage_, poses)) tell_once(line);
  return poses;
}

TransferredRadiance Subject::reaching(const Eigen::Matrix3d& light_turn) const {
  return {transfer(), turned(lighting_.light(transfer().degree()), light_turn)};
}

std::vector<Eigen::Vector3f> Subject::radiance(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                                               const Eigen::Vector3d& eye) const {
  std::vector<Eigen::Vector3f> radiance =
      local_ ? local_radiance(light_turn) : lighting_.radiance(poses, light_turn, eye);
  require_finite(radiance, file_);
  return radiance;
}

Surface Subject::object_surface(const LitStage& stage, std::size_t index, const Eigen::Matrix3d& light_turn) const {
  const Transfer& transfer = *stage_.objects[index].transfer;
  if (!transfer.kind->is_glossy()) {
    std::vector<Eigen::Vector3f> radiance =
        local_ ? local_radiance(light_turn) : stage.radiance(index, Eigen::Vector3d::Zero());
    require_finite(radiance, file_);
    return diffuse_surface(transfer.mesh, std::move(radiance), transfer.emitted, colors(transfer.mesh));
  }
  MoreOfLobe more;
  if (sharp_) {
    more = [this, &transfer, back = light_turn.transpose().cast<float>().eval()](
               const Hit& hit, std::size_t vertex, const Eigen::Vector3f& direction) -> Eigen::Vector3f {
      return visibility_towards(transfer, hit, direction) * sharp_->at(vertex, back * direction);
    };
  }
  return glossy_surface(transfer, stage.reaching(index), colors(transfer.mesh), std::move(more));
}

Surface Subject::surface(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn) const {
  return surface(lighting_.at(poses, light_turn), poses, light_turn);
}

Subject::Seen Subject::seen(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                            const Eigen::Vector3d& eye) const {
  const LitStage stage = lighting_.at(poses, light_turn);
  return {surface(stage, poses, light_turn), veil(stage, poses, eye)};
}

// The faces of the merged mesh are those of the objects, one object after another.
Surface Subject::surface(const LitStage& stage, const std::vector<Pose>& poses,
                         const Eigen::Matrix3d& light_turn) const {
  struct Placed {
    std::uint32_t end;  // of its faces
    Eigen::Matrix3f to_object;
    Surface surface;
  };
  std::vector<Placed> objects;
  for (std::size_t i = 0; i < stage_.objects.size(); ++i) {
    const auto faces = static_cast<std::uint32_t>(stage_.objects[i].transfer->mesh.faces.size());
    objects.push_back({(objects.empty() ? 0 : objects.back().end) + faces, poses[i].rotation.transpose().cast<float>(),
                       object_surface(stage, i, light_turn)});
  }
  if (objects.size() == 1 && poses.front() == Pose()) return objects.front().surface;
  return [objects = std::move(objects)](const Hit& hit, const Eigen::Vector3f& direction) {
    const auto object = std::upper_bound(objects.begin(), objects.end(), hit.face,
                                         [](std::uint32_t face, const Placed& placed) { return face < placed.end; });
    Hit own = hit;
    if (object != objects.begin()) own.face -= std::prev(object)->end;
    return object->surface(own, object->to_object * direction);
  };
}

bool Subject::has_media() const {
  return std::any_of(stage_.objects.begin(), stage_.objects.end(),
                     [](const StageObject& object) { return object.transfer->kind->in_medium; });
}

Veil Subject::veil(const LitStage& stage, const std::vector<Pose>& poses, const Eigen::Vector3d& eye) const {
  if (!has_media()) return {};
  std::vector<PlacedMedium> media;
  for (std::size_t i = 0; i < stage_.objects.size(); ++i) {
    const Transfer& transfer = *stage_.objects[i].transfer;
    if (!transfer.kind->in_medium) continue;
    media.push_back({&transfer, poses[i], finite_scattered_light(transfer, stage.light(i), stage_.objects[i].name)});
  }
  return veil_of(std::move(media), eye);
}

SurfaceColors Subject::colors(const Mesh& mesh) const {
  if (!shading_.recolor.empty()) return {mesh, shading_.albedo(mesh)};
  DecodedPictures& pictures = pictures_[&mesh];
  if (pictures == nullptr) pictures = decoded(mesh.albedo_maps, file_);
  return {mesh, pictures};
}

std::vector<Eigen::Vector3f> Subject::local_radiance(const Eigen::Matrix3d& light_turn) const {
  const Transfer& transfer = this->transfer();
  std::vector<LightCoefficients> at_points =
      project_at(turned(chosen_.lights, light_turn), local_->points, shading_.degree_for(transfer.degree()));
  for (LightCoefficients& light : at_points) light = shading_.chosen(light);
  return relight_locally(transfer, *local_, at_points, shading_);
}

void Subject::require_no_input(const std::string& output) const {
  output::require_no_input(output, {file_});
  output::require_no_input(output, stage_.files);
  output::require_no_input(output, chosen_.files);
}

void require_frames(int frames) {
  constexpr int kMaxFrames = 1000;
  if (frames < 1 || frames > kMaxFrames) {
    throw std::invalid_argument(fmt::format("--frames {}: expected 1 to {}", frames, kMaxFrames));
  }
}

std::string frame_name(const std::string& output, int frame, int frames) {
  if (frames == 1) return output;
  const std::filesystem::path path(output);
  const std::string name = fmt::format("{}_{:03}{}", path.stem().string(), frame, path.extension().string());
  return (path.parent_path() / name).string();
}

PictureFiles::PictureFiles(std::string output, int frames, int width, int height, const AnimationOptions& options)
    : output_(std::move(output)), frames_(frames), width_(width), height_(height) {
  require_frames(frames);
  if (has_extension(output_, ".webp")) {
    animation_ = std::make_unique<output::AnimatedWebp>(width, height, options.frames_a_second, options.quality);
  }
  require_output(name(0), {".png", ".webp"});
}

std::string PictureFiles::name(int frame) const { return animation_ ? output_ : frame_name(output_, frame, frames_); }

void PictureFiles::add(int frame, std::span<const std::uint8_t> rgb) {
  if (animation_) {
    animation_->add(rgb);
  } else {
    output::write_png(name(frame), width_, height_, rgb);
  }
}

void PictureFiles::finish() {
  if (animation_) output::write_file(output_, animation_->finish());
}

}  // namespace sh::prt
