#include "prt/bake/shadow_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/oracle/zonal.hpp"
#include "prt/arrays.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

constexpr int kElevations = 36;     // half as many as azimuths
constexpr double kSmallest = 1e-3;  // half-angle of the cap at the greatest distance, in radians: 1,000 radii
constexpr double kGrowth = 1.05;    // of the half-angles that are tried

Eigen::Vector3d direction_at(int elevation, int azimuth) {
  const double theta = std::numbers::pi * elevation / kElevations;
  const double phi = std::numbers::pi * azimuth / kElevations;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// The largest product of any channel of the light with a function on the sphere.
double largest_product(const LightCoefficients& light, const double* function) {
  double largest = 0.0;
  const std::size_t count = light.bands_squared();
  for (int c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs((as_array(&light.at(c, 0), count) * as_array(function, count)).sum()));
  }
  return largest;
}

double largest_irradiance(const LightCoefficients& light) {
  double largest = 0.0;
  BasisValues cosine;
  for (int i = 0; i <= kElevations; ++i) {
    for (int j = 0; j < 2 * kElevations; ++j) {
      zonal_about(light.degree, direction_at(i, j), numeric::clamped_cosine_factor<double>, cosine.data());
      largest = std::max(largest, largest_product(light, cosine.data()));
    }
  }
  return largest;
}

// The distance, in radii of the sphere, up to which its cap towards `from` holds more than `loss` of the light.
double reach(const LightCoefficients& light, const Eigen::Vector3d& from, double loss) {
  for (double angle = kSmallest; angle < std::numbers::pi / 2; angle *= kGrowth) {
    const double half = std::sin(0.5 * angle);
    const std::vector<double> cap = project_cap(from, 2.0 * half * half, light.degree);
    if (largest_product(light, cap.data()) > loss) return kGrowth / std::sin(angle);
  }
  return 1.0;
}

}  // namespace

std::optional<Eigen::AlignedBox3d> shadow_box(const Eigen::AlignedBox3d& bounds, const LightCoefficients& light,
                                              LightTurns turns, double part) {
  const double irradiance = largest_irradiance(light);
  if (!(irradiance > 0.0)) return std::nullopt;
  const double radius = 0.5 * bounds.diagonal().norm();
  std::vector<std::vector<double>> reaches;  // (elevations, azimuths)
  for (int i = 0; i <= kElevations; ++i) {
    std::vector<double>& ring = reaches.emplace_back();
    for (int j = 0; j < 2 * kElevations; ++j) {
      ring.push_back(radius * reach(light, -direction_at(i, j), part * irradiance));
    }
    const double largest = *std::max_element(ring.begin(), ring.end());
    if (turns != LightTurns::kNone) std::fill(ring.begin(), ring.end(), largest);
  }
  if (turns == LightTurns::kAny) {
    double largest = 0.0;
    for (const auto& ring : reaches) largest = std::max(largest, ring.front());
    for (auto& ring : reaches) std::fill(ring.begin(), ring.end(), largest);
  }
  Eigen::AlignedBox3d box = bounds;
  for (int i = 0; i <= kElevations; ++i) {
    for (int j = 0; j < 2 * kElevations; ++j) {
      box.extend(Eigen::Vector3d(bounds.center() + reaches[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] *
                                                       direction_at(i, j)));
    }
  }
  return box;
}

}  // namespace sh::prt
