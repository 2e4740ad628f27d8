// `prt relight FILE -o out.ply`: exit radiance per vertex under a light, of a baked mesh or of a stage.
// `prt fix-view FILE --eye X Y Z -o OUT`: glossy transfer seen from one point at rest.
// `prt info FILE`: the header and sizes of a transfer file as JSON, of any size in a moment; `--check` reads all of it.
// `prt shader --kind DS --degree 4 > relight.vert`: a complete vertex shader that relights.
#include <fmt/format.h>

#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/subject.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/vertex_shader.hpp"
#include "prt/say.hpp"
#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_json.hpp"

namespace sh::prt {
namespace {

struct RelightCommand {
  SubjectOptions subject;
  std::string output;
  std::vector<double> eye;  // empty: the camera
  int frames = 1;
  int threads = 0;
};

/// The point from which glossy surfaces are seen: of the option, else the camera that a picture would have.
Eigen::Vector3d eye_of(const RelightCommand& options, const Subject& subject, const Mesh& mesh) {
  if (options.eye.empty()) return subject.camera().value_or(default_camera(mesh, PictureSize())).position;
  Eigen::Vector3d eye(options.eye[0], options.eye[1], options.eye[2]);
  if (!eye.allFinite()) throw std::invalid_argument("--eye: expected three finite numbers");
  return eye;
}

void relight_frame(const RelightCommand& options, Subject& subject, int frame) {
  const std::vector<Pose> poses = subject.poses_at(static_cast<double>(frame) / options.frames);
  const Mesh mesh = subject.mesh(poses);
  const Eigen::Vector3d eye = eye_of(options, subject, mesh);
  const Stopwatch stopwatch;
  const std::vector<Eigen::Vector3f> radiance = subject.radiance(poses, Eigen::Matrix3d::Identity(), eye);
  report_time(stopwatch, fmt::format("relit {} vertices", radiance.size()));
  if (subject.is_glossy()) say(fmt::format("seen from {:.4g} {:.4g} {:.4g}", eye.x(), eye.y(), eye.z()));
  const std::string name = frame_name(options.output, frame, options.frames);
  write_ply(name, mesh, radiance);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& value : radiance) mean += value.cast<double>() / static_cast<double>(radiance.size());
  say(fmt::format("{}: {} vertices, {} faces, mean exit radiance {:.4g} {:.4g} {:.4g}", name, radiance.size(),
                  mesh.faces.size(), mean.x(), mean.y(), mean.z()));
}

void run_relight(const RelightCommand& options) {
  require_frames(options.frames);
  require_output(frame_name(options.output, 0, options.frames), {".ply"});
  Subject subject(options.subject);
  for (int frame = 0; frame < options.frames; ++frame) {
    subject.require_no_input(frame_name(options.output, frame, options.frames));
  }
  for (int frame = 0; frame < options.frames; ++frame) relight_frame(options, subject, frame);
}

struct InfoCommand {
  std::string file;
  bool check = false;
};

// The sizes of the numbers of a file with so many receivers.
void put_sizes(const Transfer& transfer, std::size_t receivers, Json& json) {
  if (transfer.grid) {
    json["points"] = receivers;
    json["spacing"] = json_of(transfer.grid->spacing());
  }
  if (transfer.kind->stores_visibility()) json["keeps"] = to_json(kept_by(transfer), *transfer.kind);
  const bool has_matrices = transfer.kind->stores_matrices();
  const std::size_t bytes =
      transfer.shape.receiver_bytes() + (has_matrices ? transfer.indirect_shape.receiver_bytes() : 0);
  const std::size_t all =
      transfer.shape.stored_bytes(receivers) + (has_matrices ? transfer.indirect_shape.stored_bytes(receivers) : 0);
  json[transfer.grid ? "bytes_a_point" : "bytes_a_vertex"] = bytes;
  if (all > bytes * receivers) json["bytes_of_clusters"] = all - bytes * receivers;  // shared by all receivers
}

// What only the sections of a file tell.
void put_contents(const Transfer& transfer, Json& json) {
  double mean = 0.0;
  std::vector<float> room;
  const std::size_t receivers = transfer.receivers();
  for (std::size_t v = 0; transfer.shape.length() > 0 && v < receivers; ++v) {
    const float* row = transfer.row(v, room);
    for (std::size_t c = 0; c < transfer.shape.channels; ++c) {
      mean += static_cast<double>(row[c * transfer.shape.count()]);
    }
  }
  json["mean_of_first_coefficient"] =
      mean / std::max<double>(1.0, static_cast<double>(receivers * transfer.shape.channels));
  if (const auto lobe = sharpest_lobe(transfer)) {
    json["sharpest_lobe"] = {{"exponent", lobe->exponent}, {"share_that_the_degree_holds", lobe->share}};
  }
  const std::vector<double> shares = held_shares_of_brdfs(transfer);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    json["brdfs"][i]["share_that_the_degree_holds"] = shares[i];
  }
}

/// Prints the header of the file and its sizes; if asked, reads all of it and prints values from its body.
void run_info(const InfoCommand& options) {
  const TransferHead head = read_transfer_head(options.file);
  Json json = Json::parse(head.header);
  json["file"] = std::filesystem::path(options.file).filename().string();
  json["bytes"] = std::filesystem::file_size(options.file);
  put_sizes(head.transfer, head.receivers, json);
  if (options.check) put_contents(read_transfer(options.file, file_kinds()), json);
  print_json(json);
}

struct FixViewCommand {
  std::string file;
  std::string output;
  std::vector<double> eye;
  int threads = 0;
};

void run_fix_view(const FixViewCommand& options) {
  const Eigen::Vector3d eye(options.eye[0], options.eye[1], options.eye[2]);
  if (!eye.allFinite()) throw std::invalid_argument("--eye: expected three finite numbers");
  output::require_no_input(options.output, {options.file});
  const Stopwatch stopwatch;
  Transfer seen;
  try {
    seen = seen_from(read_transfer(options.file), eye);
  } catch (const std::invalid_argument& flaw) {
    throw std::runtime_error(fmt::format("{}: {}", options.file, flaw.what()));
  }
  write_transfer(options.output, seen);
  report_time(stopwatch, fmt::format("{} vertices seen from {:.4g} {:.4g} {:.4g}, into {}", seen.mesh.positions.size(),
                                     eye.x(), eye.y(), eye.z(), options.output));
}

struct ShaderCommand {
  std::string kind = "DS";
  int degree = 4;
  bool white = false;
  std::string language = "450";
};

void run_shader(const ShaderCommand& options) {
  const TransferKind& kind = *find_kind(&TransferKind::letters, options.kind);
  if (kind.is_glossy()) {
    throw std::invalid_argument(
        fmt::format("--kind {}: the shader of a glossy kind depends on its file; expected DU, DS or DI, or `prt emit "
                    "FILE --lang glsl`",
                    options.kind));
  }
  print_out(vertex_shader(kind, options.degree, options.white,
                          options.language == "450" ? ShaderLanguage::kGlsl450 : ShaderLanguage::kEs300));
}

}  // namespace

void add_relight_command(CLI::App& tool) {
  auto options = std::make_shared<RelightCommand>();
  CLI::App& command = *tool.add_subcommand("relight", "write a PLY mesh with the exit radiance of every vertex");
  options->subject.add_to(command);
  command.add_option("-o,--output", options->output, "PLY file to write; frames become out_000.ply, ...")->required();
  command
      .add_option("--eye", options->eye, "X,Y,Z: the point from which glossy surfaces are seen; default: the camera")
      ->default_str("")
      ->delimiter(',')
      ->expected(3);
  command.add_option("--frames", options->frames, "number of meshes in the time in which a stage moves");
  run_with_threads(command, options, run_relight);
}

void add_fix_view_command(CLI::App& tool) {
  auto options = std::make_shared<FixViewCommand>();
  CLI::App& command =
      *tool.add_subcommand("fix-view", "write glossy transfer seen from one point: one dot product a frame");
  command.add_option("FILE", options->file, "transfer file of a glossy kind")->required();
  command.add_option("-o,--output", options->output, "transfer file to write, of the kind with bounces")->required();
  command.add_option("--eye", options->eye, "X,Y,Z: the point")->required()->delimiter(',')->expected(3);
  run_with_threads(command, options, run_fix_view);
}

void add_info_command(CLI::App& tool) {
  auto options = std::make_shared<InfoCommand>();
  CLI::App& command = *tool.add_subcommand("info", "print the header and sizes of a transfer file as JSON");
  command.add_option("FILE", options->file, "transfer file from `prt bake`")->required();
  command.add_flag("--check", options->check, "read and check the whole file, and print values from its body, too");
  command.callback([options] { run_info(*options); });
}

void add_shader_command(CLI::App& tool) {
  auto options = std::make_shared<ShaderCommand>();
  CLI::App& command = *tool.add_subcommand("shader", "print a complete vertex shader that relights");
  const auto letters = kind_names(&TransferKind::letters);
  command
      .add_option("--kind", options->kind,
                  "kind of transfer: DU reads normals, DS rows of one channel, DI rows of three")
      ->check(CLI::IsMember(std::vector<std::string>{letters.begin(), letters.end()}));
  command.add_option("--degree", options->degree, "SH degree, 0 to 10");
  command.add_flag("--white", options->white, "use a light with one channel for all colors");
  command
      .add_option("--language", options->language, "shader language: GLSL 450 (OpenGL 4.5) or GLSL ES 300 (WebGL 2)")
      ->check(CLI::IsMember({"450", "es300"}));
  command.callback([options] { run_shader(*options); });
}

}  // namespace sh::prt
