#include "prt/light/project.hpp"

#include <cmath>
#include <numbers>

#include "numeric/oracle/cap.hpp"
#include "prt/light/cap_light.hpp"
#include "prt/light/polygon_light.hpp"
#include "prt/light/sky.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {
namespace {

std::vector<double> project_constant(int degree) {
  std::vector<double> out(coefficient_count(degree), 0.0);
  out[0] = std::sqrt(4.0 * std::numbers::pi);
  return out;
}

/// (1 + 2z) / 3 above the horizon; a polynomial, so that the rule is exact.
std::vector<double> project_overcast(int degree) {
  static const auto kRule = numeric::gauss_legendre<double>(kMaxDegree);
  std::vector<double> zonal(static_cast<std::size_t>(degree) + 1);
  numeric::zonal_quadrature<double>(
      degree, [](const double& one_minus_z) { return 1.0 - 2.0 / 3.0 * one_minus_z; }, 0.0, 1.0, kRule, zonal.data());
  std::vector<double> out(coefficient_count(degree), 0.0);
  for (int l = 0; l <= degree; ++l) {
    out[coefficient_count(l) - static_cast<std::size_t>(l) - 1] = zonal[l];
  }
  return out;
}

/// The light without its rotation, for radiance (or irradiance) 1. Not for pictures.
std::vector<double> project_shape(const LightSpec& spec, int degree) {
  switch (spec.type) {
    case LightType::kCieOvercast:
      return project_overcast(degree);
    case LightType::kCieSky:
      return project_sky(spec.sky, spec.direction, degree);
    case LightType::kDirectional:
      return project_directional(spec.direction, degree);
    case LightType::kCap:
      return project_cap(spec.direction, spec.one_minus_cos, degree);
    case LightType::kPolygon:
      return project_polygon(spec.corners, degree);
    default:
      return project_constant(degree);
  }
}

LightCoefficients scaled(const std::vector<double>& shape, const Eigen::Vector3d& factor, int degree) {
  LightCoefficients out = LightCoefficients::zero(degree);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < shape.size(); ++i) out.at(channel, i) = factor[static_cast<int>(channel)] * shape[i];
  }
  return out;
}

LightCoefficients project(const Light& light, int degree) {
  require_degree(degree);
  if (light.spec.type == LightType::kEnvironment) {
    LightCoefficients out = project_image(*light.image, light.spec.mapping, degree);
    for (double& value : out.values) value *= static_cast<double>(light.spec.scale);
    return turned(out, light.rotation);
  }
  const std::vector<double> shape = project_shape(light.spec, degree);
  const LightCoefficients out = scaled(shape, light.spec.radiance.cast<double>(), degree);
  return light.rotation.isIdentity(0.0) ? out : turned(out, light.rotation);
}

}  // namespace

LightCoefficients project(const std::vector<Light>& lights, int degree, std::vector<Deringing>* windowed) {
  LightCoefficients sum = LightCoefficients::zero(degree);
  for (const Light& light : lights) {
    LightCoefficients one = project(light, degree);
    if (light.spec.window) {
      const Deringing done = apply_window(*light.spec.window, one);
      if (windowed != nullptr) windowed->push_back(done);
    }
    accumulate(sum, one);
  }
  return sum;
}

}  // namespace sh::prt
