#include "prt/light/cap_light.hpp"

#include <cmath>
#include <numbers>

#include "numeric/oracle/cap.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHemisphere = 1.0;  // as 1 - cos(90 degrees)

}  // namespace

std::vector<double> project_directional(const Eigen::Vector3d& direction, int degree) {
  std::vector<double> out(coefficient_count(degree));
  evaluate_basis(degree, direction.x(), direction.y(), direction.z(), out.data());
  return out;
}

std::vector<double> project_cap(const Eigen::Vector3d& direction, double one_minus_cos, int degree) {
  std::vector<double> zonal(static_cast<std::size_t>(degree) + 1);
  numeric::cap_zonal(degree, one_minus_cos, zonal.data());
  std::vector<double> out = project_directional(direction, degree);
  // The cap is a zonal function, turned to a direction.
  for (int l = 0; l <= degree; ++l) zonal[l] *= std::sqrt(4.0 * kPi / (2.0 * l + 1.0));
  scale_bands(zonal, out.data());
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
