// USD: a dome light with its coefficients as attributes in text form (.usda). UsdLux has no coefficients of its own; the
// names are those of UsdVolParticleField3DGaussianSplat's, in the namespace of this project.
#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

constexpr std::string_view kName = "float3[] shforge:radiance:sphericalHarmonicsCoefficients = [";

// The mean radiance: what is left for a renderer that does not know the attributes.
std::array<double, 3> mean_of(const EngineLight& light) {
  const LightCoefficients constant = first_bands(*light.radiance, 0);
  const Eigen::Vector3d mean = radiance(constant, Eigen::Vector3d::UnitZ());
  return {mean.x(), mean.y(), mean.z()};
}

}  // namespace

std::string write_usd(const EngineLight& light) {
  std::string text = fmt::format(
      "#usda 1.0\n(\n    defaultPrim = \"Light\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n\n"
      "# Radiance, W m^-2 sr^-1, linear Rec. 709, as real orthonormal spherical harmonics without Condon-Shortley "
      "phase\n"
      "# in the axes of this stage; degree l, order m at index l(l+1)+m.\n"
      "def DomeLight \"Light\"\n{{\n"
      "    color3f inputs:color = ({})\n    float inputs:intensity = 1\n"
      "    custom int shforge:radiance:sphericalHarmonicsDegree = {}\n    custom {}",
      joined(mean_of(light)), degree_of(light.coefficients), kName);
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    text += fmt::format("{}({})", i == 0 ? "" : ", ", joined(light.coefficients[i]));
  }
  return text + "]\n}\n";
}

std::optional<Triples> read_usd(const Document& document) {
  if (!document.bytes.starts_with("#usda")) return {};
  std::size_t begin = document.bytes.find(kName);
  if (begin == std::string_view::npos) throw std::runtime_error("expected a light with sphericalHarmonicsCoefficients");
  begin += kName.size();
  const std::string array(document.bytes.substr(begin, document.bytes.find(']', begin) - begin));
  const char* at = array.c_str();
  Triples triples;
  const auto skip = [&](std::string_view what) {
    while (*at != '\0' && what.find(*at) != std::string_view::npos) ++at;
  };
  for (skip(" ("); *at != '\0'; skip(" (,)")) {
    for (double& number : triples.emplace_back()) {
      char* end = nullptr;
      number = std::strtod(at, &end);
      if (end == at) throw std::runtime_error("sphericalHarmonicsCoefficients: expected triples of numbers");
      at = end;
      skip(" ,)");
    }
  }
  if (degree_of(triples) < 0) {
    throw std::runtime_error(
        fmt::format("sphericalHarmonicsCoefficients: expected (degree+1)^2 triples, degree 0 to {}, got {}", kMaxDegree,
                    triples.size()));
  }
  return triples;
}

}  // namespace sh::prt::formats
