#include "prt/light/light_coefficients.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "generated/cpp/evaluate_rgb.hpp"
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
  for (int c = 0; c < 3; ++c) std::copy_n(&light.at(c, 0), first.bands_squared(), &first.at(c, 0));
  return first;
}

void accumulate(LightCoefficients& sum, const LightCoefficients& more) {
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += more.values[i];
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
