#include "prt/material/measured.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include "prt/chunks.hpp"
#include "prt/material/tabulate.hpp"

namespace sh::prt {

namespace {

constexpr int kHalfSteps = 90;
constexpr int kAngleSteps = 90;
constexpr int kAzimuthSteps = 180;
constexpr std::size_t kSamples = std::size_t{kHalfSteps} * kAngleSteps * kAzimuthSteps;
constexpr std::array<std::int32_t, 3> kCounts = {kHalfSteps, kAngleSteps, kAzimuthSteps};
constexpr std::array<double, 3> kUnits = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

constexpr int kNodesOfHalf = 2 * kHalfSteps;  // of the quadrature
constexpr int kNodesAround = 120;

int step_of(double part, int steps) { return std::clamp(static_cast<int>(part * steps), 0, steps - 1); }

class Measured {
 public:
  explicit Measured(const std::string& path) : path_(path), values_(3 * kSamples) {
    const std::uintmax_t expected = sizeof kCounts + values_.size() * sizeof(double);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) fail(fmt::format("cannot read the measured BRDF: {}", error.message()));
    if (size != expected) {
      fail(fmt::format("not a measured BRDF of the MERL data base: {} bytes, expected {}", size, expected));
    }
    std::ifstream file(path, std::ios::binary);
    std::array<std::int32_t, 3> counts{};
    file.read(reinterpret_cast<char*>(counts.data()), sizeof counts);
    file.read(reinterpret_cast<char*>(values_.data()), static_cast<std::streamsize>(values_.size() * sizeof(double)));
    if (!file) fail("cannot read the measured BRDF");
    if (counts != kCounts) {
      fail(fmt::format("not a measured BRDF of the MERL data base: {} x {} x {} values, expected 90 x 90 x 180",
                       counts[0], counts[1], counts[2]));
    }
    if (!std::all_of(values_.begin(), values_.end(), [](double value) { return std::isfinite(value); })) {
      fail("a value of the measured BRDF is not finite");
    }
  }

  /// Red, green and blue of a pair of directions, 1/sr; some may be negative.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& half, const Eigen::Vector3d& light) const {
    const double half_angle = std::acos(std::min(half.z(), 1.0));
    const double azimuth = std::atan2(half.y(), half.x());
    // The light where the half vector is the z axis.
    const Eigen::Vector3d about = Eigen::AngleAxisd(-half_angle, Eigen::Vector3d::UnitY()) *
                                  (Eigen::AngleAxisd(-azimuth, Eigen::Vector3d::UnitZ()) * light);
    double turn = std::atan2(about.y(), about.x()) / std::numbers::pi;
    if (turn < 0.0) turn += 1.0;
    const double right = std::numbers::pi / 2.0;
    const int i = step_of(std::sqrt(half_angle / right), kHalfSteps);
    const int j = step_of(std::acos(std::min(about.z(), 1.0)) / right, kAngleSteps);
    const std::size_t place =
        (static_cast<std::size_t>(i) * kAngleSteps + static_cast<std::size_t>(j)) * kAzimuthSteps +
        static_cast<std::size_t>(step_of(turn, kAzimuthSteps));
    Eigen::Vector3d value;
    for (std::size_t c = 0; c < 3; ++c) value[static_cast<Eigen::Index>(c)] = kUnits[c] * values_[c * kSamples + place];
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", path_, what));
  }

 private:
  std::string path_;
  std::vector<double> values_;  // (channels, half angles, angles, azimuths)
};

// Calls add(half vector, area on the sphere) for nodes at the middle of half a step.
template <class Add>
void for_half_vectors(const Add& add) {
  const double right = std::numbers::pi / 2.0;
  for (int i = 0; i < kNodesOfHalf; ++i) {
    const double root = (i + 0.5) / kNodesOfHalf;  // of the angle over pi/2
    const double angle = root * root * right;
    const double area = std::sin(angle) * 2.0 * root * right / kNodesOfHalf * 2.0 * std::numbers::pi / kNodesAround;
    for (int j = 0; j < kNodesAround; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / kNodesAround;
      add({std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)}, area);
    }
  }
}

// The reflectance under constant light from all around, red, green and blue: the mean over views, by their cosine.
Eigen::Vector3d mean_reflectance(const ReflectanceTable& table) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (int view = 0; view < kViews; ++view) {
    const Eigen::Vector3d eye = view_direction(view);
    const double weight = eye.x() * eye.z();
    sum += weight * hemispherical_reflectance(table.data(), view);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

MeasuredReflectance read_measured_reflectance(const std::string& path) {
  const Measured measured(path);
  MeasuredReflectance made{{path, true, ReflectanceTable(kReflectanceTableSize)}, {}, {}};
  std::atomic<std::size_t> met{0};
  std::atomic<std::size_t> negative{0};
  in_parallel(0, kViews, [&](int view) {
    const Eigen::Vector3d eye = view_direction(view);
    ReflectanceRow row;
    for_half_vectors([&](const Eigen::Vector3d& half, double area) {
      const Eigen::Vector3d light = mirrored_at(half, eye);
      if (eye.dot(half) <= 0.0 || light.z() <= 0.0) return;
      const Eigen::Vector3d value = measured.at(half, light);
      ++met;
      if (value.minCoeff() < 0.0) ++negative;
      row.add(light, value.cwiseMax(0.0) * (light.z() * area * 4.0 * eye.dot(half)));
    });
    row.write(view, made.reflectance.table);
  });
  constexpr double kMost = 0.1;
  const double part = static_cast<double>(negative) / static_cast<double>(met);
  if (part > kMost) {
    measured.fail(
        fmt::format("{:.3g} % of the measured BRDF is negative above the horizon; expected reflectance of 0 or more",
                    100.0 * part));
  }
  if (part > 0.0) {
    made.flaws.push_back(fmt::format("{:.3g} % of it is negative above the horizon (0 in its place)", 100.0 * part));
  }
  const Eigen::Vector3d mean = mean_reflectance(made.reflectance.table);
  if (mean.maxCoeff() > 1.0) {
    made.flaws.push_back(fmt::format("it reflects {:.4g} of the light, more than arrives", mean.maxCoeff()));
  }
  made.albedo = mean.cwiseMax(0.0).cwiseMin(1.0).cast<float>();
  return made;
}

}  // namespace sh::prt
