// The CIE general skies for a given sun position, relative to the radiance at the zenith:
//   L(Z, chi) / L_zenith = f(chi) phi(Z) / (f(Z_sun) phi(0)),   Z from the zenith +z, chi from the sun
//   phi(Z) = 1 + a exp(b / cos Z)                               standard gradation
//   f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi     standard indicatrix
// [CIE03] eqs. 1-5 and table 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "generated/cpp/rotate_z.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "prt/angles.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/light/light_shapes.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

// [CIE03] table 1
constexpr std::array<SkyParameters, kSkyTypes> kSkies{{{4.0, -0.70, 0.0, -1.0, 0.0},
                                                       {4.0, -0.70, 2.0, -1.5, 0.15},
                                                       {1.1, -0.80, 0.0, -1.0, 0.0},
                                                       {1.1, -0.80, 2.0, -1.5, 0.15},
                                                       {0.0, -1.00, 0.0, -1.0, 0.0},
                                                       {0.0, -1.00, 2.0, -1.5, 0.15},
                                                       {0.0, -1.00, 5.0, -2.5, 0.30},
                                                       {0.0, -1.00, 10.0, -3.0, 0.45},
                                                       {-1.0, -0.55, 2.0, -1.5, 0.15},
                                                       {-1.0, -0.55, 5.0, -2.5, 0.30},
                                                       {-1.0, -0.55, 10.0, -3.0, 0.45},
                                                       {-1.0, -0.32, 10.0, -3.0, 0.45},
                                                       {-1.0, -0.32, 16.0, -3.0, 0.30},
                                                       {-1.0, -0.15, 16.0, -3.0, 0.30},
                                                       {-1.0, -0.15, 24.0, -2.8, 0.15}}};

double gradation(const SkyParameters& sky, double cosine) { return 1.0 + sky.a * std::exp(sky.b / cosine); }

double indicatrix(const SkyParameters& sky, double chi) {
  const double cosine = std::cos(chi);
  return 1.0 + sky.c * (std::exp(sky.d * chi) - std::exp(sky.d * 0.5 * kPi)) + sky.e * cosine * cosine;
}

using Rule = numeric::GaussLegendreRule<double>;

/// Tanh-sinh nodes on [0, 1] [TakahasiMori74], for integrands that change quickly near both ends, such as the length of
/// the arc from a low sun to the horizon when the arc turns sideways.
Rule tanh_sinh(int refinement) {
  const int side = 64 * refinement;
  const double step = 3.2 / side;
  Rule panel;
  for (int k = -side; k <= side; ++k) {
    const double s = 0.5 * kPi * std::sinh(k * step);
    panel.nodes.push_back(0.5 * (1.0 + std::tanh(s)));
    panel.weights.push_back(0.25 * kPi * step * std::cosh(k * step) / (std::cosh(s) * std::cosh(s)));
  }
  return panel;
}

/// The nodes along an arc and across the arcs.
struct Nodes {
  Rule along;
  Rule across;
};

Nodes nodes_of(int refinement) { return {numeric::gauss_legendre<double>(80 * refinement), tanh_sinh(refinement)}; }

/// Adds the arc that starts at the sun with `bearing` (0: upwards) and ends at the horizon; the sun is above +x.
/// `weight` is the weight of the bearing. Orders m >= 0 only: the sky is symmetric about the sun's meridian.
void add_arc(const SkyParameters& sky, const Rule& rule, double elevation, double bearing, double weight, int degree,
             std::vector<double>& sum) {
  const Eigen::Vector3d sun(std::cos(elevation), 0.0, std::sin(elevation));
  const Eigen::Vector3d side(-std::sin(elevation) * std::cos(bearing), std::sin(bearing),
                             std::cos(elevation) * std::cos(bearing));
  const double length = std::atan2(sun.z(), -side.z());
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double chi = 0.5 * length * (1.0 + rule.nodes[k]);
    const Eigen::Vector3d d = std::cos(chi) * sun + std::sin(chi) * side;
    if (d.z() > 0.0) {  // rounding may put the last node of a flat arc below
      const double value = 0.5 * length * rule.weights[k] * weight * std::sin(chi) * indicatrix(sky, chi);
      add_basis(degree, d.x(), d.y(), d.z(), value * gradation(sky, d.z()), sum.data());
    }
  }
}

/// Turns a function about +z, after the orders m < 0, of which a function even in azimuth has none, are taken away.
void turn_even(double azimuth, int degree, std::vector<double>& coefficients) {
  for (int l = 0; l <= degree; ++l) band(coefficients.data(), l).head(l).setZero();
  at_degree(degree, [&](auto known) {
    sh::rotate_z<known()>(std::cos(azimuth), std::sin(azimuth), coefficients.data(), coefficients.data());
  });
}

double at_zenith(const SkyParameters& sky, const Eigen::Vector3d& sun) {
  return indicatrix(sky, angle_between<double>(sun, Eigen::Vector3d::UnitZ())) * gradation(sky, 1.0);
}

}  // namespace

const SkyParameters& sky_parameters(int type) {
  if (type < 1 || type > kSkyTypes) throw std::invalid_argument("sky: expected a type from 1 to 15");
  return kSkies[type - 1];
}

double sky_radiance(int type, const Eigen::Vector3d& sun, const Eigen::Vector3d& direction) {
  const SkyParameters& sky = sky_parameters(type);
  if (!(direction.z() > 0.0)) return 0.0;
  return indicatrix(sky, angle_between(sun, direction)) * gradation(sky, direction.z()) / at_zenith(sky, sun);
}

std::vector<double> project_sky(int type, const Eigen::Vector3d& sun, int degree, int refinement) {
  static const Nodes kNodes = nodes_of(1);
  const Nodes nodes = refinement == 1 ? kNodes : nodes_of(refinement);
  const SkyParameters& sky = sky_parameters(type);
  std::vector<double> sum(coefficient_count(degree), 0.0);
  const double elevation = std::atan2(std::max(sun.z(), 0.0), std::hypot(sun.x(), sun.y()));
  const double scale = kPi / at_zenith(sky, sun);  // two panels of pi/2, each seen on both sides of the meridian
  for (std::size_t k = 0; k < nodes.across.nodes.size(); ++k) {
    const double upwards = 0.5 * kPi * nodes.across.nodes[k];
    add_arc(sky, nodes.along, elevation, upwards, scale * nodes.across.weights[k], degree, sum);
    add_arc(sky, nodes.along, elevation, kPi - upwards, scale * nodes.across.weights[k], degree, sum);
  }
  turn_even(std::atan2(sun.y(), sun.x()), degree, sum);
  return sum;
}

}  // namespace sh::prt
