// `prt compare A B -o error.png`: compares two bakes of one mesh, or two pictures, as JSON and as a false-color
// picture.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/image/image_io.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/scene/camera.hpp"
#include "prt/study/error_picture.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string first;
  std::string second;
  std::string output;
  LightOptions light;
  PictureSize size;
  double limit = std::numeric_limits<double>::infinity();
  int threads = 0;
};

bool is_transfer(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string magic(layout::kMagic.size(), '\0');
  if (!stream || std::filesystem::is_directory(file)) {
    throw std::runtime_error(fmt::format("{}: cannot read: {}", file, std::strerror(stream ? EISDIR : errno)));
  }
  stream.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  return std::equal(magic.begin(), magic.end(), layout::kMagic.begin());
}

Radiances shaded(const Transfer& transfer, const std::vector<Light>& lights, const WindowOptions& window) {
  Radiances radiances;
  for (const Eigen::Vector3f& radiance : relight(transfer, project_windowed(lights, transfer.degree(), window))) {
    radiances.push_back(radiance.cast<double>());
  }
  return radiances;
}

struct Compared {
  Json json;
  double rms = 0.0;
  std::string picture;  // a PNG file's bytes
};

Compared compare_transfers(const Options& options) {
  const Transfer first = read_transfer(options.first);
  const Transfer second = read_transfer(options.second);
  if (first.mesh.positions != second.mesh.positions || first.mesh.faces != second.mesh.faces) {
    throw std::runtime_error(
        fmt::format("{}: its mesh is not that of {}; expected two bakes of one mesh", options.first, options.second));
  }
  const ChosenLight chosen = choose_light(options.light);
  const Camera camera = chosen.camera.empty() ? default_camera(second.mesh, options.size) : chosen.camera.front();
  const VertexErrors errors = vertex_errors(second.mesh, camera, shaded(first, chosen.lights, options.light.window),
                                            shaded(second, chosen.lights, options.light.window));
  const Eigen::Vector3f& place = second.mesh.positions[errors.error.worst_vertex];
  Compared compared;
  compared.rms = errors.error.rms;
  compared.json = {{"file", options.first},
                   {"reference", options.second},
                   {"error",
                    "exit radiance, over the root mean square of the reference; vertices weigh by area over the "
                    "squared distance to the camera"},
                   {"relative_rms", errors.error.rms},
                   {"relative_largest", errors.error.largest},
                   {"worst_vertex", errors.error.worst_vertex},
                   {"worst_place", {place.x(), place.y(), place.z()}}};
  if (!options.output.empty()) {
    const Tracer tracer(second.mesh, options.threads);
    const std::string title =
        fmt::format("rms {:.2g} %, largest {:.2g} %", 100 * errors.error.rms, 100 * errors.error.largest);
    compared.picture = error_picture(second.mesh, tracer, errors.relative, camera, options.size, title, "compare");
  }
  return compared;
}

Compared compare_pictures(const Options& options) {
  const Image first = read_image(options.first, options.light.on_flaw());
  const Image second = read_image(options.second, options.light.on_flaw());
  if (first.width != second.width || first.height != second.height) {
    throw std::runtime_error(fmt::format("{}: {} x {} pixels, {} has {} x {}", options.first, first.width, first.height,
                                         options.second, second.width, second.height));
  }
  double square = 0.0;
  double reference = 0.0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    square += (first.pixels[i] - second.pixels[i]).cast<double>().squaredNorm();
    reference += second.pixels[i].cast<double>().squaredNorm();
  }
  const double unit = reference > 0.0 ? std::sqrt(reference / (3.0 * static_cast<double>(second.pixels.size()))) : 1.0;
  ErrorMap map{first.width, first.height, {}, std::vector<float>(first.pixels.size(), 1.0F)};
  double largest = -1.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const double error = static_cast<double>((first.pixels[i] - second.pixels[i]).cwiseAbs().maxCoeff()) / unit;
    map.place.push_back(error_place(error));
    if (error > largest) {
      largest = error;
      worst = i;
    }
  }
  Compared compared;
  compared.rms = std::sqrt(square / (3.0 * static_cast<double>(second.pixels.size()))) / unit;
  const auto width = static_cast<std::size_t>(first.width);
  compared.json = {{"file", options.first},
                   {"reference", options.second},
                   {"error", "all channels of all pixels, over the root mean square of the reference"},
                   {"relative_rms", compared.rms},
                   {"relative_largest", largest},
                   {"worst_pixel", {worst % width, worst / width}}};
  if (!options.output.empty()) {
    compared.picture = error_png(map, fmt::format("rms {:.2g} %, largest {:.2g} %", 100 * compared.rms, 100 * largest));
  }
  return compared;
}

void run(const Options& options) {
  if (!options.output.empty()) require_writable(options.output);
  const bool transfers = is_transfer(options.first);
  if (transfers != is_transfer(options.second)) {
    throw std::runtime_error(
        fmt::format("{} and {}: one is a transfer file, the other is not", options.first, options.second));
  }
  const Compared compared = transfers ? compare_transfers(options) : compare_pictures(options);
  if (!options.output.empty()) output::write_file(options.output, compared.picture);
  print_out(compared.json.dump(2) + "\n");
  if (!(compared.rms <= options.limit)) {
    throw CheckFailed(fmt::format("{}: differs by {:.3g}, more than {:g}", options.first, compared.rms, options.limit));
  }
}

}  // namespace

void add_compare_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("compare", "compare two bakes of one mesh, or two HDR pictures");
  command->add_option("FILE", options->first, "transfer file, or a picture (.exr, .hdr)")->required();
  command->add_option("REFERENCE", options->second, "reference of the same type; errors are relative to it")
      ->required();
  command->add_option("-o,--output", options->output, "PNG file to write: the error in false colors");
  command->add_option("--limit", options->limit, "exit 1 if the relative rms error is larger");
  command->add_option("--width", options->size.width, "width of the picture in pixels, for bakes")
      ->capture_default_str();
  command->add_option("--height", options->size.height, "height of the picture in pixels, for bakes")
      ->capture_default_str();
  command->add_option("--samples", options->size.samples, "rays for each pixel, for bakes")->capture_default_str();
  command->add_option("--threads", options->threads, "number of threads; 0: every core")->capture_default_str();
  options->light.add_to(*command);
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
