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

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/image/image.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/scene/camera.hpp"
#include "prt/study/error_picture.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"

namespace sh::prt {
namespace {

struct CompareOptions {
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

/// Exit radiance of every vertex, of glossy surfaces towards the eye.
Radiances shaded(const Transfer& transfer, const std::vector<Light>& lights, const WindowOptions& window,
                 const Eigen::Vector3d& eye) {
  const LightCoefficients light = project_windowed(lights, transfer.degree(), window);
  const std::vector<Eigen::Vector3f> relit =
      transfer.kind->is_glossy()
          ? exit_radiance(transfer, TransferredRadiance(transfer, light), eye, transfer.mesh.albedo)
          : relight(transfer, light);
  require_finite(relit, transfer.scene);
  Radiances radiances;
  for (const Eigen::Vector3f& radiance : relit) radiances.push_back(radiance.cast<double>());
  return radiances;
}

/// The result of a comparison; the errors are relative.
struct Compared {
  std::string error;  // the quantity that is compared, in words
  double rms = 0.0;
  double largest = 0.0;
  Json worst;           // where the largest error is
  std::string picture;  // a PNG file's bytes
};

std::string title(double rms, double largest) {
  return fmt::format("rms {:.2g} %, largest {:.2g} %", 100 * rms, 100 * largest);
}

Compared compare_transfers(const CompareOptions& options) {
  const Transfer first = read_transfer(options.first);
  const Transfer second = read_transfer(options.second);
  if (first.mesh.frame != second.mesh.frame || first.mesh.positions != second.mesh.positions ||
      first.mesh.faces != second.mesh.faces) {
    throw std::runtime_error(
        fmt::format("{}: its mesh is not that of {}; expected two bakes of one mesh", options.first, options.second));
  }
  const ChosenLight chosen = choose_light(options.light);
  const Camera camera = chosen.camera.value_or(default_camera(second.mesh, options.size));
  const auto seen = [&](const Transfer& transfer) {
    return shaded(transfer, chosen.lights, options.light.window, camera.position);
  };
  const VertexErrors errors = vertex_errors(second.mesh, camera, seen(first), seen(second));
  Compared compared{
      "exit radiance (of glossy surfaces towards the camera), over the root mean square of the reference; vertices "
      "weigh "
      "by area over the squared distance to the camera",
      errors.error.rms,
      errors.error.largest,
      {{"worst_vertex", errors.error.worst_vertex},
       {"worst_place", json_of(second.mesh.point(errors.error.worst_vertex))}},
      {}};
  if (!options.output.empty()) {
    compared.picture = error_picture(second.mesh, Tracer(second.mesh, options.threads), errors.relative, camera,
                                     options.size, title(compared.rms, compared.largest), "compare");
  }
  return compared;
}

Compared compare_pictures(const CompareOptions& options) {
  const Image first = read_image(options.first, on_flaw(options.light.strict));
  const Image second = read_image(options.second, on_flaw(options.light.strict));
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
  const double values = 3.0 * static_cast<double>(second.pixels.size());
  const double unit = reference > 0.0 ? std::sqrt(reference / values) : 1.0;
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
  const auto width = static_cast<std::size_t>(first.width);
  Compared compared{"all channels of all pixels, over the root mean square of the reference",
                    std::sqrt(square / values) / unit,
                    largest,
                    {{"worst_pixel", {worst % width, worst / width}}},
                    {}};
  if (!options.output.empty()) compared.picture = error_png(map, title(compared.rms, largest));
  return compared;
}

void run_compare_command(const CompareOptions& options) {
  if (!options.output.empty()) {
    require_output(options.output, {".png"});
    output::require_no_input(options.output, {options.first, options.second, options.light.scene, options.light.light});
  }
  const bool transfers = is_transfer(options.first);
  if (transfers != is_transfer(options.second)) {
    throw std::runtime_error(
        fmt::format("{} and {}: one is a transfer file, the other is not", options.first, options.second));
  }
  const Compared compared = transfers ? compare_transfers(options) : compare_pictures(options);
  if (!options.output.empty()) output::write_file(options.output, compared.picture);
  Json json = {{"file", options.first},
               {"reference", options.second},
               {"error", compared.error},
               {"relative_rms", compared.rms},
               {"relative_largest", compared.largest}};
  json.update(compared.worst);
  print_json(json);
  if (!(compared.rms <= options.limit)) {
    throw CheckFailed(fmt::format("{}: differs by {:.3g}, more than {:g}", options.first, compared.rms, options.limit));
  }
}

}  // namespace

void add_compare_command(CLI::App& tool) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *tool.add_subcommand("compare", "compare two bakes of one mesh, or two HDR pictures");
  command.add_option("FILE", options->first, "transfer file, or a picture (.exr, .hdr)")->required();
  command.add_option("REFERENCE", options->second, "reference of the same type; errors are relative to it")->required();
  command.add_option("-o,--output", options->output, "PNG file to write: the error in false colors");
  command.add_option("--limit", options->limit, "exit 1 if the relative rms error is larger");
  command.add_option("--width", options->size.width, "width of the picture in pixels, for bakes");
  command.add_option("--height", options->size.height, "height of the picture in pixels, for bakes");
  command.add_option("--samples", options->size.samples, "rays for each pixel, for bakes");
  options->light.add_to(command);
  run_with_threads(command, options, run_compare_command);
}

}  // namespace sh::prt
