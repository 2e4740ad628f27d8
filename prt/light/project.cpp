// Projects lights without pictures on the SH basis.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "generated/cpp/add_cap.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHemisphere = 1.0;  // as 1 - cos(90 degrees)

/// (1 + 2z) / 3 above the horizon; a polynomial, so that the rule is exact.
std::vector<double> project_overcast(int degree) {
  static const auto kRule = numeric::gauss_legendre<double>(kMaxDegree);
  std::vector<double> zonal(degree + 1);
  numeric::zonal_quadrature<double>(
      degree, [](const double& one_minus_z) { return 1.0 - 2.0 / 3.0 * one_minus_z; }, 0.0, 1.0, kRule, zonal.data());
  std::vector<double> out(coefficient_count(degree), 0.0);
  for (int l = 0; l <= degree; ++l) band(out.data(), l)[l] = zonal[l];
  return out;
}

/// The light without its rotation, for radiance (or irradiance) 1; zeros at the end may be missing. Not for pictures.
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
    default:  // constant
      return {std::sqrt(4.0 * kPi)};
  }
}

/// The bands that both have; the bands above those of the light are zero.
LightCoefficients in_degree(const LightCoefficients& light, int degree) {
  LightCoefficients out = LightCoefficients::zero(degree);
  const Eigen::Index rows = std::min(out.matrix().rows(), light.matrix().rows());
  out.matrix().topRows(rows) = light.matrix().topRows(rows);
  return out;
}

LightCoefficients project(const Light& light, int degree) {
  require_degree(degree);
  if (light.spec.type == LightType::kCoefficients) {
    return turned(in_degree(light.spec.coefficients, degree), light.rotation);
  }
  if (light.spec.type == LightType::kEnvironment) {
    LightCoefficients out = project_image(*light.image, light.spec.mapping, degree);
    as_array(out.values) *= static_cast<double>(light.spec.scale);
    return turned(out, light.rotation);
  }
  const std::vector<double> shape = project_shape(light.spec, degree);
  LightCoefficients out = LightCoefficients::zero(degree);
  out.matrix().topRows(Eigen::Index(shape.size())) =
      as_array(shape).matrix() * light.spec.radiance.cast<double>().transpose();
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

std::vector<double> project_directional(const Eigen::Vector3d& direction, int degree) {
  std::vector<double> out(coefficient_count(degree));
  evaluate_basis(degree, direction.x(), direction.y(), direction.z(), out.data());
  return out;
}

std::vector<double> project_cap(const Eigen::Vector3d& direction, double one_minus_cos, int degree) {
  std::vector<double> out(coefficient_count(degree));
  at_degree(degree, [&](auto known) {
    sh::add_cap<known()>(direction.x(), direction.y(), direction.z(), one_minus_cos, 1.0, out.data());
  });
  return out;
}

bool cap_covers(const Eigen::Vector3d& middle, double one_minus_cos, const Eigen::Vector3d& direction) {
  return 0.5 * (direction - middle).squaredNorm() <= one_minus_cos;  // 1 - cos of the angle between unit vectors
}

double cap_irradiance(double one_minus_cos) {
  return one_minus_cos < kHemisphere ? kPi * one_minus_cos * (2.0 - one_minus_cos) : kPi;
}

double sphere_one_minus_cos(double radius, double distance) {
  const double sine = radius / distance;
  return sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
}

}  // namespace sh::prt
