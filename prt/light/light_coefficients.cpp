#include "prt/light/light_coefficients.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

#include "generated/cpp/evaluate_rgb.hpp"
#include "generated/cpp/relight_colored.hpp"
#include "generated/cpp/relight_rgb.hpp"
#include "prt/basis.hpp"

namespace sh::prt {

void require_degree(int degree) {
  if (degree < 0 || degree > kMaxDegree) {
    throw std::invalid_argument(fmt::format("degree {} is out of range; expected 0 to {}", degree, kMaxDegree));
  }
}

LightCoefficients LightCoefficients::zero(int degree) {
  require_degree(degree);
  LightCoefficients light{degree, {}};
  light.values.assign(3 * light.bands_squared(), 0.0);
  return light;
}

LightCoefficients first_bands(const LightCoefficients& light, int degree) {
  LightCoefficients first = LightCoefficients::zero(degree);
  first.matrix() = light.matrix().topRows(first.matrix().rows());
  return first;
}

std::vector<float> in_single(const LightCoefficients& light, int degree) {
  const std::size_t count = coefficient_count(degree);
  std::vector<float> values(3 * count, 0.0F);
  Eigen::Map<Eigen::MatrixX3f> all(values.data(), Eigen::Index(count), 3);
  all.topRows(light.matrix().rows()) = light.matrix().cast<float>();
  return values;
}

Eigen::Vector3d integral_with(const float* transfer, std::size_t channels, const LightCoefficients& light) {
  std::array<double, 3 * std::size_t{coefficient_count(kMaxDegree)}> row;
  std::copy_n(transfer, channels * light.bands_squared(), row.data());
  Eigen::Vector3d rgb;
  at_degree(light.degree, [&](auto degree) {
    const double* lit_by = light.values.data();
    channels == 1 ? sh::relight_rgb<degree()>(row.data(), lit_by, rgb.data())
                  : sh::relight_colored<degree()>(row.data(), lit_by, rgb.data());
  });
  return rgb;
}

void accumulate(LightCoefficients& sum, const LightCoefficients& more) {
  as_array(sum.values) += as_array(more.values);
}

LightCoefficients turned(const LightCoefficients& light, const Eigen::Matrix3d& r) {
  LightCoefficients out = light;
  if (r == Eigen::Matrix3d::Identity()) return out;
  for (int channel = 0; channel < 3; ++channel) {
    rotate_function(light.degree, r, &light.at(channel, 0), &out.at(channel, 0));
  }
  return out;
}

Eigen::Vector3d radiance(const LightCoefficients& light, const Eigen::Vector3d& direction) {
  Eigen::Vector3d rgb;
  at_degree(light.degree, [&](auto degree) {
    sh::evaluate_rgb<degree()>(light.values.data(), direction.x(), direction.y(), direction.z(), rgb.data());
  });
  return rgb;
}

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).toRotationMatrix();
}

}  // namespace sh::prt
