// `prt project IMAGE --degree N`: the SH coefficients of a lat-long picture as JSON.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/commands.hpp"
#include "prt/image_io.hpp"
#include "prt/lat_long.hpp"
#include "prt/project.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string image;
  int degree = 2;
  int threads = 0;
  bool strict = false;
};

Json coefficients(const LightCoefficients& light) {
  Json out;
  const std::size_t n = light.bands_squared();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto* begin = &light.values[channel * n];
    out.push_back(std::vector<double>(begin, begin + n));
  }
  return out;
}

Json report(const Options& options, const Image& image, const LightCoefficients& light) {
  return {{"file", std::filesystem::path(options.image).filename().string()},
          {"width", image.width},
          {"height", image.height},
          {"negative_pixels", image.negative_pixels},
          {"degree", light.degree},
          {"convention",
           "real spherical harmonics, orthonormal on the unit sphere, no Condon-Shortley phase; "
           "index i = l(l+1)+m; band 1 is (y, z, x)"},
          {"axes", "z up, right-handed"},
          {"mapping",
           "lat-long, seen from the centre: top row +z, centre column +x, a quarter from the left +y, "
           "left and right edge -x"},
          {"unit", "W m^-2 sr^-1 times sqrt(sr): integral of radiance times Y_i over the sphere"},
          {"color_space", "linear Rec. 709"},
          {"layout", "coefficients[channel][i], channels red, green, blue"},
          {"coefficients", coefficients(light)}};
}

void run(const Options& options) {
  const Stopwatch stopwatch;
  require_degree(options.degree);
  const Image image = read_image(options.image, options.strict ? OnFlaw::kRefuse : OnFlaw::kMend);
  require_lat_long(options.image, image);
  const LightCoefficients light = project_lat_long(image, options.degree);
  std::cout << report(options, image, light).dump(2) << '\n' << std::flush;
  if (!std::cout) {
    throw std::runtime_error("standard output: cannot write");
  }
  stopwatch.report(fmt::format("projected {} x {} pixels on degree {}", image.width, image.height, options.degree));
}

}  // namespace

void add_project_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("project", "print the SH coefficients of an environment picture as JSON");
  command->add_option("IMAGE", options->image, "lat-long OpenEXR or Radiance .hdr picture")->required();
  command->add_option("--degree", options->degree, "0 to 10")->capture_default_str();
  command->add_option("--threads", options->threads, "0: every core")->capture_default_str();
  command->add_flag("--strict", options->strict, "refuse negative pixels instead of setting them to 0");
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
