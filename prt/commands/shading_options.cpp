// prt/commands/shading_options.hpp
#include "prt/commands/shading_options.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "prt/runtime/relight.hpp"

namespace sh::prt {

void ShadingOptions::add_to(CLI::App& command) {
  command.add_option("--degree", degree, "leave out the bands above; 1 takes 4 coefficients a vertex")
      ->capture_default_str();
  command.add_flag("--white", white, "the light's luminance in every channel");
  command.add_option("--recolor", recolour, "R G B: linear albedo instead of the transfer's (not with bounces)")
      ->expected(3);
}

LightCoefficients ShadingOptions::light(const std::vector<Light>& lights, const Transfer& transfer,
                                        const WindowOptions& window) const {
  if (degree < -1 || degree > transfer.degree) {
    throw std::invalid_argument(fmt::format("--degree {}: the transfer has degrees 0 to {}", degree, transfer.degree));
  }
  for (const float channel : recolour) {
    if (!(channel >= 0.0F && channel <= 1.0F)) {
      throw std::invalid_argument(fmt::format("--recolor {}: an albedo is from 0 to 1", channel));
    }
  }
  if (!recolour.empty() && transfer.channels() != 1) {
    throw std::invalid_argument("--recolor: transfer with bounces holds its albedo; only DU and DS can be recoloured");
  }
  const LightCoefficients all = project_windowed(lights, degree < 0 ? transfer.degree : degree, window);
  return white ? sh::prt::white(all) : all;
}

std::vector<Eigen::Vector3f> ShadingOptions::shade(const Transfer& transfer, const LightCoefficients& light) const {
  if (recolour.empty()) {
    return relight(transfer, light);
  }
  const Eigen::Vector3f albedo(recolour[0], recolour[1], recolour[2]);
  return recoloured(transfer, light, std::vector<Eigen::Vector3f>(transfer.mesh.positions.size(), albedo));
}

}  // namespace sh::prt
