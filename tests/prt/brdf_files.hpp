// Files of measured BRDFs, in the format of the MERL data base, made from functions.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {

inline std::vector<std::int32_t> brdf_counts() { return {90, 90, 180}; }

/// The values of a file: value(half, light, eye), one number for each channel, at the middle of each step.
template <class Value>
std::vector<double> brdf_values(const Value& value) {
  constexpr std::size_t kSteps = std::size_t{90} * 90 * 180;
  const double right = std::numbers::pi / 2.0;
  std::vector<double> all(3 * kSteps);
  std::size_t place = 0;
  for (int i = 0; i < 90; ++i) {
    const double half_angle = (i + 0.5) * (i + 0.5) / 8100.0 * right;
    const Eigen::Vector3d half(std::sin(half_angle), 0.0, std::cos(half_angle));
    for (int j = 0; j < 90; ++j) {
      const double angle = (j + 0.5) / 90.0 * right;
      for (int k = 0; k < 180; ++k, ++place) {
        const double turn = (k + 0.5) / 180.0 * std::numbers::pi;
        const Eigen::Vector3d about(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                                    std::cos(angle));
        const Eigen::Vector3d light(half.z() * about.x() + half.x() * about.z(), about.y(),
                                    -half.x() * about.x() + half.z() * about.z());
        const Eigen::Vector3d eye = 2.0 * light.dot(half) * half - light;
        const Eigen::Vector3d seen = value(half, light, eye);
        const Eigen::Vector3d units(1500.0, 1500.0 / 1.15, 1500.0 / 1.66);
        for (std::size_t c = 0; c < 3; ++c) {
          const auto channel = static_cast<Eigen::Index>(c);
          all[c * kSteps + place] = seen[channel] * units[channel];
        }
      }
    }
  }
  return all;
}

inline void write_brdf(const std::string& file, const std::vector<double>& values,
                       const std::vector<std::int32_t>& counts = brdf_counts()) {
  write_all(file, std::string(reinterpret_cast<const char*>(counts.data()), counts.size() * sizeof(std::int32_t)) +
                      std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)));
}

/// Diffuse reflection.
inline std::vector<double> diffuse_brdf(const Eigen::Vector3d& albedo) {
  return brdf_values([&](const auto&, const auto&, const auto&) { return (albedo / std::numbers::pi).eval(); });
}

}  // namespace sh::prt::test
