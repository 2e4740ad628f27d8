// `prt lightmap FILE -o out.exr`: pictures over the atlases of a mesh whose texels are receivers.
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/subject.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/runtime/lightmap.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

enum class Of { kIrradiance, kRadiance, kDirectional, kTransfer };
constexpr std::array<std::string_view, 4> kOf = {"irradiance", "radiance", "directional", "transfer"};

struct LightmapCommand {
  SubjectOptions subject;
  std::string of = "irradiance";
  std::string output;
  int threads = 0;
};

// out.exr -> out_1.exr, ... of several atlases.
std::string file_of(const std::string& output, std::size_t atlas, std::size_t atlases) {
  if (atlases == 1) return output;
  const std::filesystem::path path(output);
  return (path.parent_path() / fmt::format("{}_{}{}", path.stem().string(), atlas + 1, path.extension().string()))
      .string();
}

void require_fit(const LightmapCommand& options, const Transfer& transfer, Of of) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{}: {}", options.subject.file, why));
  };
  if (transfer.mesh.atlases.heads.empty()) {
    refuse("its receivers are vertices; expected a bake of a scene in which a mesh has `texels`");
  }
  if (of != Of::kTransfer && transfer.kind->is_length) {
    refuse(fmt::format("--of {}: its numbers are lengths, not light; expected transfer", options.of));
  }
  if (of == Of::kDirectional && !transfer.kind->is_glossy()) {
    refuse(fmt::format("--of directional: transfer of kind {} holds the cosine about its normals; expected {} or {}",
                       transfer.kind->letters, kGlossyShadowed.letters, kGlossyInterreflected.letters));
  }
  if (of != Of::kDirectional && of != Of::kTransfer && transfer.kind->is_glossy()) {
    refuse(fmt::format("--of {}: what glossy transfer sends depends on the eye; expected directional or transfer",
                       options.of));
  }
  if (of == Of::kTransfer && transfer.shape.length() == 0) refuse("--of transfer: it stores no numbers");
}

// The numbers of a row as channels: CHANNEL.INDEX, such as T.00, or R.00, G.00, B.00 where they are colored.
std::vector<ExrChannel> rows_of(const Transfer& transfer, const SurfaceReceivers& receivers, std::size_t atlas) {
  const std::size_t length = transfer.shape.length();
  const std::size_t count = transfer.shape.count();
  std::vector<ExrChannel> channels;
  for (std::size_t i = 0; i < length; ++i) {
    const std::string_view layers = transfer.shape.channels == 1 ? "T" : "RGB";
    channels.push_back({fmt::format("{}.{:02}", layers[i / count], i % count), {}});
    channels.back().values.reserve(receivers.pixels(atlas).size());
  }
  std::vector<float> room;
  for (const std::uint32_t vertex : receivers.pixels(atlas)) {
    const float* row = transfer.row(vertex, room);
    for (std::size_t i = 0; i < length; ++i) channels[i].values.push_back(row[i]);
  }
  return channels;
}

void tell_seams(const Mesh& mesh, const SurfaceReceivers& receivers, const std::vector<Eigen::Vector3f>& values) {
  const Seams seams = measure_seams(mesh, receivers, values);
  if (seams.edges == 0) return;
  say(
      fmt::format("along {} edges at which the surface goes on elsewhere in the atlas, both sides differ by {:.2g} "
                  "(root mean square), {:.2g} of the value",
                  seams.edges, seams.difference, seams.value > 0.0 ? seams.difference / seams.value : 0.0));
}

void run_lightmap(const LightmapCommand& options) {
  const Stopwatch stopwatch;
  const Of of = value_called<Of>(options.of, kOf).value();
  require_output(options.output, {".exr"});
  if (std::filesystem::path(options.subject.file).extension() == ".json") {
    throw std::invalid_argument(fmt::format("{}: expected a transfer file, not a stage", options.subject.file));
  }
  Subject subject(options.subject, read_transfer(options.subject.file, vertex_kinds()));
  const Transfer& transfer = subject.transfer();
  require_fit(options, transfer, of);
  const std::size_t atlases = transfer.mesh.atlases.heads.size();
  for (std::size_t a = 0; a < atlases; ++a) subject.require_no_input(file_of(options.output, a, atlases));
  const SurfaceReceivers receivers(transfer.mesh);
  const std::vector<Pose> poses = subject.poses_at(0.0);
  std::vector<std::vector<Eigen::Vector3f>> layers;
  if (of == Of::kRadiance || of == Of::kIrradiance) {
    layers.push_back(subject.radiance(poses, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()));
    if (of == Of::kIrradiance) layers.front() = irradiance_of(transfer, layers.front(), subject.albedo());
  } else if (of == Of::kDirectional) {
    for (auto& layer : directional_irradiance(transfer, subject.reaching(Eigen::Matrix3d::Identity()))) {
      layers.push_back(std::move(layer));
    }
  }
  if (!layers.empty()) tell_seams(transfer.mesh, receivers, layers.front());
  for (std::size_t a = 0; a < atlases; ++a) {
    std::vector<ExrChannel> channels =
        of == Of::kTransfer ? rows_of(transfer, receivers, a) : std::vector<ExrChannel>();
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const std::string prefix = layers.size() == 1 ? std::string() : fmt::format("e{}.", k);
      for (ExrChannel& channel : channels_of(receivers, a, layers[k], prefix)) channels.push_back(std::move(channel));
    }
    const Atlases::Head& head = transfer.mesh.atlases.heads[a];
    output::write_file(file_of(options.output, a, atlases), exr_bytes(head.width, head.height, channels));
  }
  report_time(stopwatch, fmt::format("wrote {} of {} atlas{}, into {}", options.of, atlases, atlases == 1 ? "" : "es",
                                     file_of(options.output, 0, atlases)));
}

}  // namespace

void add_lightmap_command(CLI::App& tool) {
  auto options = std::make_shared<LightmapCommand>();
  CLI::App& command =
      *tool.add_subcommand("lightmap", "write OpenEXR pictures over a mesh whose texels are receivers, for engines");
  options->subject.add_to(command);
  command.add_option("-o,--output", options->output, "OpenEXR file to write; of several atlases out_1.exr, ...")
      ->required();
  command
      .add_option("--of", options->of,
                  "irradiance (W m^-2), radiance that leaves, directional: e_0 + e_1 y + e_2 z + e_3 x at a normal "
                  "(glossy kinds), or transfer: the baked numbers")
      ->check(CLI::IsMember(std::vector<std::string>(kOf.begin(), kOf.end())));
  run_with_threads(command, options, run_lightmap);
}

}  // namespace sh::prt
