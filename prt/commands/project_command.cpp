// `prt project LIGHT --degree N`: the SH coefficients of a picture, or of the lights of a JSON file, as JSON.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/commands/commands.hpp"
#include "prt/names.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string light;
  std::string mapping = "lat_long";
  int degree = 2;
  WindowOptions window;
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

/// Facts about a picture, and its sun if that was extracted; nothing for other lights.
Json described(const Options& options, const std::vector<Light>& lights) {
  Json out = {{"file", std::filesystem::path(options.light).filename().string()}};
  for (const Light& light : lights) {
    if (light.image) {
      out.update({{"width", light.image->width},
                  {"height", light.image->height},
                  {"negative_pixels", light.image->negative_pixels},
                  {"mapping", name_of(light.spec.mapping)}});
    }
    if (light.share_of_picture > 0.0) {
      const Eigen::Vector3d d = light.rotation * light.spec.direction;
      const Eigen::Vector3f& radiance = light.spec.radiance;
      out["suns"].push_back({{"direction", {d.x(), d.y(), d.z()}},
                             {"one_minus_cos_half_angle", light.spec.one_minus_cos},
                             {"radiance", {radiance.x(), radiance.y(), radiance.z()}},
                             {"share_of_picture", light.share_of_picture}});
    }
  }
  return out;
}

Json windows(const std::vector<Deringing>& windowed) {
  Json out = Json::array();
  for (const Deringing& done : windowed) {
    const Window& window = done.choice.window;
    Json one = {{"type", done.needed ? word_of(window.type, kWindowNames) : "none"}};
    if (done.needed) one[std::string(number_key(window.type))] = window.size;
    if (window.type == WindowType::kSinc) one["power"] = window.power;
    one.update({{"keep", done.choice.keep == Keep::kRadiance ? "radiance" : "irradiance"},
                {"least_over_peak_before", done.least_before},
                {"least_over_peak", done.least_after},
                {"peak_kept", done.peak_kept},
                {"contrast_kept", done.contrast_kept}});
    out.push_back(one);
  }
  return out;
}

Json report(const Options& options, const std::vector<Light>& lights, const LightCoefficients& light,
            const std::vector<Deringing>& windowed) {
  Json out = described(options, lights);
  if (!windowed.empty()) out["windows"] = windows(windowed);
  out.update({{"degree", light.degree},
              {"convention",
               "real spherical harmonics, orthonormal on the unit sphere, no Condon-Shortley phase; "
               "index i = l(l+1)+m; band 1 is (y, z, x)"},
              {"axes", "z up, right-handed; pictures face +x, +y to the left (but mirror balls: to the right), +z up"},
              {"unit", "W m^-2 sr^-1 times sqrt(sr): integral of radiance times Y_i over the sphere"},
              {"color_space", "linear Rec. 709"},
              {"layout", "coefficients[channel][i], channels red, green, blue"},
              {"coefficients", coefficients(light)}});
  return out;
}

void run(const Options& options) {
  const Stopwatch stopwatch;
  require_degree(options.degree);
  const std::vector<Light> lights =
      load_lights(named_lights(options.light, options.mapping), options.strict ? OnFlaw::kRefuse : OnFlaw::kMend);
  std::vector<Deringing> windowed;
  const LightCoefficients light = project_windowed(lights, options.degree, options.window, &windowed);
  print_out(report(options, lights, light, windowed).dump(2) + "\n");
  report_time(stopwatch, fmt::format("projected {} on degree {}", options.light, options.degree));
}

}  // namespace

void add_project_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("project", "print the SH coefficients of a picture or of lights as JSON");
  command
      ->add_option("LIGHT", options->light,
                   "a picture (.exr, .hdr, .png, .jpg), a .json file of lights, constant or overcast")
      ->required();
  add_mapping_to(*command, options->mapping);
  options->window.add_to(*command);
  command->add_option("--degree", options->degree, "SH degree, 0 to 10")->capture_default_str();
  command->add_option("--threads", options->threads, "number of threads; 0: every core")->capture_default_str();
  command->add_flag("--strict", options->strict, "refuse negative pixels instead of setting them to 0");
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
