// `prt light-at SUBJECT --at X,Y,Z`: the light at a point of a lit scene, as coefficients in JSON.
#include <fmt/format.h>

#include "prt/commands/lit_place.hpp"
#include "prt/scene/coefficients_json.hpp"

namespace sh::prt {
namespace {

// The sizes of the table of errors, and the size that they are compared with.
constexpr int kFaceSizes[] = {4, 8, 16, 32};
constexpr CubeSize kFinest{64, 4};

struct LightAtCommand {
  LitPlaceOptions place;
  std::vector<double> at;
  bool errors = false;
  int threads = 0;
};

// The distance of two lights by the length of the second: the root of the squared error as the paper counts it.
double distance(const LightCoefficients& light, const LightCoefficients& reference) {
  const double length = reference.matrix().norm();
  return length > 0.0 ? (light.matrix() - reference.matrix()).norm() / length : 0.0;
}

Json errors_by_size(const LitPlace& place, const Eigen::Vector3d& point, int samples, int degree) {
  const LightCoefficients finest = place.sampler(kFinest).at(point, degree).light;
  Json errors = Json::array();
  for (const int face : kFaceSizes) {
    const double error = distance(place.sampler({face, samples}).at(point, degree).light, finest);
    errors.push_back({{"face", face}, {"error", error}, {"squared_error", error * error}});
  }
  return errors;
}

void run_light_at(const LightAtCommand& options) {
  const Stopwatch stopwatch;
  const Eigen::Vector3d point(options.at[0], options.at[1], options.at[2]);
  const CubeSize& size = options.place.size;
  const LitPlace place(options.place);
  const SampledLight sampled = place.sampler(size).at(point, options.place.degree);
  if (sampled.is_inside()) {
    throw std::invalid_argument(
        fmt::format("--at {:g},{:g},{:g}: {:.0f} % of the surfaces that the point sees are backs; "
                    "expected a point outside of solids",
                    point.x(), point.y(), point.z(), 100.0 * sampled.back_share));
  }
  Json about = {{"point", json_of(point)},
                {"face", size.face},
                {"samples", size.samples},
                {"surface_share", sampled.surface_share}};
  if (options.errors) about["errors"] = errors_by_size(place, point, size.samples, options.place.degree);
  Json out = coefficients_json(sampled.light);
  out["sampled_from"] = about;
  print_json(out);
  report_time(stopwatch, fmt::format("sampled the light at {:g},{:g},{:g} by 6 x {} x {} pixels of {} rays", point.x(),
                                     point.y(), point.z(), size.face, size.face, size.samples * size.samples));
}

}  // namespace

void add_light_at_command(CLI::App& tool) {
  auto options = std::make_shared<LightAtCommand>();
  CLI::App& command =
      *tool.add_subcommand("light-at", "print the SH coefficients of the light at a point of a lit scene as JSON");
  options->place.add_to(command);
  command.add_option("--at", options->at, "X,Y,Z: the point")->required()->delimiter(',')->expected(3);
  command.add_flag("--errors", options->errors,
                   "add the errors of pictures of 4 to 32 pixels, against 64 pixels of 4 x 4 rays");
  run_with_threads(command, options, run_light_at);
}

}  // namespace sh::prt
