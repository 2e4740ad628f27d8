// `prt splats rotate IN OUT --axis 0,0,1 --degrees 30`: turns Gaussian splats, with their SH coefficients.
// `prt splats convert IN OUT`: from one format to another; the ending of OUT names it.
// `prt splats info IN`: what a file of splats holds, as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/splats/convert_splats.hpp"
#include "prt/splats/splat_convention.hpp"
#include "prt/splats/splat_numbers.hpp"

namespace sh::prt {
namespace {

struct SplatsCommand {
  std::string input;
  std::string output;
  std::vector<double> axis;
  double degrees = 0.0;
  std::vector<double> quaternion;  // w, x, y, z
  std::vector<double> matrix;      // row by row
  double scale = 1.0;
  std::vector<double> translate;
  std::vector<double> crop;  // the least and the largest corner
  int degree = -1;           // as in the file
  std::string axes_in;
  std::string axes_out;
  int spz_version = 0;       // as in the input, or 3
  std::vector<int> sh_bits;  // of degree 1, of higher degrees
  bool drop_invalid = false;
  bool strict = false;
  int threads = 0;
};

Eigen::Vector3d vector_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Multiples of 90 degrees about an axis have entries of 0, 1 and -1, which pi and its cosine miss by a rounding.
Eigen::Matrix3d without_roundings(Eigen::Matrix3d matrix) {
  constexpr double kRounding = 1e-15;
  for (double& entry : matrix.reshaped()) {
    if (std::abs(entry - std::round(entry)) <= kRounding) entry = std::round(entry);
  }
  return matrix;
}

Eigen::Matrix3d rotation_of(const SplatsCommand& options) {
  if (!options.axis.empty()) {
    const Eigen::Vector3d axis = vector_of(options.axis);
    if (!(axis.norm() > 0.0) || !axis.allFinite()) {
      throw std::invalid_argument("--axis: expected three finite numbers that are not all 0");
    }
    return without_roundings(rotation_about(axis / axis.cwiseAbs().maxCoeff(), std::fmod(options.degrees, 360.0)));
  }
  if (!options.quaternion.empty()) {
    const auto& q = options.quaternion;
    const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
    if (!(quaternion.norm() > 0.0) || !std::isfinite(quaternion.norm())) {
      throw std::invalid_argument("--quaternion: expected w,x,y,z, four finite numbers that are not all 0");
    }
    return without_roundings(quaternion.normalized().toRotationMatrix());
  }
  if (options.matrix.empty()) return Eigen::Matrix3d::Identity();
  return checked_rotation(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(options.matrix.data()),
                          "--matrix");
}

SplatEdit edit_of(const SplatsCommand& options) {
  SplatEdit edit;
  edit.similarity.turn = rotation_of(options);
  if (!(options.scale > 0.0) || !std::isfinite(options.scale)) {
    throw std::invalid_argument(fmt::format("--scale {}: expected a positive number", options.scale));
  }
  edit.similarity.scale = options.scale;
  if (!options.translate.empty()) edit.similarity.move = vector_of(options.translate);
  if (!options.crop.empty()) {
    const Eigen::Vector3d least = vector_of(options.crop);
    const Eigen::Vector3d largest(options.crop[3], options.crop[4], options.crop[5]);
    if (!(least.array() <= largest.array()).all()) {
      throw std::invalid_argument("--crop: expected x,y,z of the least corner, then of the largest: a box");
    }
    edit.crop = Eigen::AlignedBox3d(least, largest);
  }
  if (options.degree >= 0) edit.degree = options.degree;
  edit.axes_in = options.axes_in;
  edit.axes_out = options.axes_out;
  edit.flaws = {options.drop_invalid, options.strict};
  if (options.spz_version != 0) edit.spz.version = options.spz_version;
  if (!options.sh_bits.empty()) {
    edit.spz.first_bits = options.sh_bits[0];
    edit.spz.higher_bits = options.sh_bits[1];
  }
  return edit;
}

void warn(const std::string& what) {
  if (!what.empty()) report_flaw(OnFlaw::kMend, what);
}

void run_convert(const SplatsCommand& options) {
  const Stopwatch stopwatch;
  const SplatEdit edit = edit_of(options);
  require_output(options.output, {".ply", ".glb", ".spz"});
  output::require_no_input(options.output, {options.input});
  const SplatResult result = convert_splats(options.input, options.output, edit);
  if (result.mended > 0) {
    warn(fmt::format("{}: {} splats have a quaternion of 0, which counts as the identity", options.input,
                     result.mended));
  }
  if (result.dropped > 0) warn(fmt::format("{}: {} invalid splats left out", options.input, result.dropped));
  if (!result.left_out.empty()) warn(fmt::format("{}: does not hold {}", options.output, result.left_out));
  if (!result.losses.empty()) warn(fmt::format("{}: {}", options.output, result.losses));
  report_time(stopwatch,
              fmt::format("{} {} splats of degree {}{}, into {}", result.is_copy ? "copied" : "wrote", result.count,
                          result.degree, options.crop.empty() ? "" : fmt::format(" ({} cropped)", result.cropped),
                          options.output));
}

/// The ranges of what a file holds.
struct Ranges {
  Eigen::AlignedBox3f box;
  double least_scale = std::numeric_limits<double>::infinity();
  double largest_scale = 0.0;
  double opacity = 0.0;  // sum
  std::size_t count = 0;

  void add(const SplatBlock& block) {
    count += block.count;
    for (std::size_t i = 0; i < block.count; ++i) {
      box.extend(Eigen::Map<const Eigen::Vector3f>(&block.position[3 * i]));
      opacity += opacity_of_logit(block.opacity[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double scale = scale_of_log(block.log_scale[3 * i + k]);
        least_scale = std::min(least_scale, scale);
        largest_scale = std::max(largest_scale, scale);
      }
    }
  }
};

void run_info(const SplatsCommand& options) {
  const SplatFormat& format = splat_format_of(options.input);
  const auto reader = format.read(options.input);
  FlawCounts counts;
  Ranges ranges;
  for_splats(*reader, {options.drop_invalid, false}, counts, [&](const SplatBlock& block) { ranges.add(block); });
  Json json = {{"file", std::filesystem::path(options.input).filename().string()},
               {"format", format.name},
               {"bytes", std::filesystem::file_size(options.input)},
               {"splats", reader->count()},
               {"degree", reader->degree()},
               {"convention", splat_convention()},
               {"axes", format.axes},
               {"zero_quaternions", counts.mended.load()},
               {"invalid", counts.dropped.load()}};
  if (ranges.count > 0) {
    json["bounding_box"] = {json_of(ranges.box.min()), json_of(ranges.box.max())};
    json["scale"] = {ranges.least_scale, ranges.largest_scale};
    json["mean_opacity"] = ranges.opacity / static_cast<double>(ranges.count);
  }
  json.update(reader->details());
  print_json(json);
}

CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<double>& numbers, int count,
                         const std::string& help) {
  return command.add_option(name, numbers, help)->delimiter(',')->expected(count)->default_str("");
}

void add_edit_options(CLI::App& command, SplatsCommand& options) {
  command.add_option("IN", options.input, "file of splats: .ply, .glb or .spz, by its content")->required();
  command.add_option("OUT", options.output, "file to write; its ending names the format")->required();
  command.add_option("--scale", options.scale, "uniform factor of positions and sizes, after the rotation");
  add_numbers(command, "--translate", options.translate, 3, "x,y,z: movement, after rotation and scale");
  add_numbers(command, "--crop", options.crop, 6, "x,y,z,X,Y,Z: box of the splats to keep, before everything else");
  command.add_option("--degree", options.degree, "degree of the coefficients, 0 to 4; default: that of the file")
      ->default_str("")
      ->check(CLI::Range(0, kHighestSplatDegree));
  const std::string axes =
      "three letters, such as RDF: x right, y down, z front; default: those of the format, .ply RDF, "
      ".glb LUF, .spz RUB";
  command.add_option("--axes-in", options.axes_in, "axes of IN: " + axes);
  command.add_option("--axes-out", options.axes_out, "axes of OUT, likewise; in the same format those of IN");
  command.add_option("--spz-version", options.spz_version, "of an .spz file; default: that of IN, or 3")
      ->default_str("")
      ->check(CLI::IsMember({2, 3, 4}));
  command
      .add_option("--sh-bits", options.sh_bits,
                  "A,B: bits of an .spz file's coefficients of degree 1 and of higher degrees, 1 to 8; default: 5,4")
      ->delimiter(',')
      ->expected(2)
      ->default_str("")
      ->check(CLI::Range(1, 8));
  command.add_flag("--drop-invalid", options.drop_invalid, "leave out splats with numbers that are not finite");
  command.add_flag("--strict", options.strict, "refuse quaternions of 0, which otherwise count as the identity");
}

void add_rotate(CLI::App& splats) {
  auto options = std::make_shared<SplatsCommand>();
  CLI::App& command = *splats.add_subcommand("rotate", "turn splats: positions, rotations and SH coefficients");
  add_edit_options(command, *options);
  auto* degrees =
      command.add_option("--degrees", options->degrees, "angle about --axis, right-handed")->default_str("");
  auto* axis = add_numbers(command, "--axis", options->axis, 3, "x,y,z, of any length")->needs(degrees);
  degrees->needs(axis);
  auto* quaternion = add_numbers(command, "--quaternion", options->quaternion, 4, "w,x,y,z, of any length");
  auto* matrix = add_numbers(command, "--matrix", options->matrix, 9, "nine numbers, row by row");
  quaternion->excludes(axis)->excludes(matrix);
  matrix->excludes(axis);
  run_with_threads<SplatsCommand>(command, options, [](const SplatsCommand& chosen) {
    if (chosen.axis.empty() && chosen.quaternion.empty() && chosen.matrix.empty()) {
      throw std::invalid_argument("rotate: expected --axis and --degrees, --quaternion or --matrix");
    }
    run_convert(chosen);
  });
}

void add_convert(CLI::App& splats) {
  auto options = std::make_shared<SplatsCommand>();
  CLI::App& command = *splats.add_subcommand("convert", "write splats in another format, or a part of them");
  add_edit_options(command, *options);
  run_with_threads<SplatsCommand>(command, options, run_convert);
}

void add_info(CLI::App& splats) {
  auto options = std::make_shared<SplatsCommand>();
  CLI::App& command = *splats.add_subcommand("info", "print what a file of splats holds, as JSON");
  command.add_option("IN", options->input, "file of splats: .ply, .glb or .spz")->required();
  command.add_flag("--drop-invalid", options->drop_invalid, "count splats with numbers that are not finite");
  run_with_threads<SplatsCommand>(command, options, run_info);
}

}  // namespace

void add_splats_command(CLI::App& tool) {
  CLI::App& splats = *tool.add_subcommand("splats", "turn, edit and convert Gaussian splats");
  splats.require_subcommand(0, 1);
  splats.callback([&splats] {
    if (splats.get_subcommands().empty()) {
      throw std::invalid_argument("splats: expected rotate, convert or info, such as `prt splats info FILE`");
    }
  });
  add_rotate(splats);
  add_convert(splats);
  add_info(splats);
}

}  // namespace sh::prt
