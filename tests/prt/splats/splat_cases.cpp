#include "tests/prt/splats/splat_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

#include "numeric/identify/convention.hpp"

namespace sh::prt::test {
namespace {

using Random = std::mt19937;

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

double uniform(Random& random, double least, double most) {
  return rounded(std::uniform_real_distribution<>(least, most)(random));
}

Splat random_splat(Random& random, Eigen::Index bands_squared) {
  Splat splat;
  for (double& v : splat.position) v = uniform(random, -20.0, 20.0);
  for (double& v : splat.rotation) v = uniform(random, -1.0, 1.0);
  for (double& v : splat.log_scale) v = uniform(random, -7.0, 1.0);
  splat.opacity = uniform(random, -6.0, 6.0);
  splat.coefficients.resize(3, bands_squared);
  for (double& v : splat.coefficients.reshaped()) v = uniform(random, -0.4, 0.4);
  splat.coefficients.col(0) = 4.0 * splat.coefficients.col(0);
  return splat;
}

void make_extreme(Splats& splats) {
  const auto at = [&](std::size_t i) -> Splat& { return splats[std::min(i, splats.size() - 1)]; };
  at(0).log_scale = Eigen::Vector3d(-9.5, -0.25, -9.5);
  at(1).opacity = 30.0;
  at(2).opacity = -30.0;
  at(3).position = Eigen::Vector3d(500.0, -700.0, 0.0);
  at(4).coefficients.setZero();
  at(5).rotation *= 8.0;
  at(6).rotation = Eigen::Vector4d(0.0, 0.0, 0.0, -1.0);
}

template <class T>
void append(std::string& bytes, T value, bool big_endian = false) {
  std::string number(reinterpret_cast<const char*>(&value), sizeof value);
  if (big_endian) std::reverse(number.begin(), number.end());
  bytes += number;
}

/// The numbers of a splat in the order of the field's files.
std::vector<double> numbers_of(const Splat& splat, bool normals) {
  std::vector<double> v(splat.position.begin(), splat.position.end());
  if (normals) v.insert(v.end(), 3, 0.0);
  for (Eigen::Index c = 0; c < 3; ++c) v.push_back(splat.coefficients(c, 0));
  for (Eigen::Index c = 0; c < 3; ++c) {
    for (Eigen::Index k = 1; k < splat.coefficients.cols(); ++k) v.push_back(splat.coefficients(c, k));
  }
  v.push_back(splat.opacity);
  v.insert(v.end(), splat.log_scale.begin(), splat.log_scale.end());
  v.insert(v.end(), splat.rotation.begin(), splat.rotation.end());
  return v;
}

std::vector<std::string> names_of(Eigen::Index bands_squared, bool normals) {
  std::vector<std::string> names = {"x", "y", "z"};
  if (normals) names.insert(names.end(), {"nx", "ny", "nz"});
  names.insert(names.end(), {"f_dc_0", "f_dc_1", "f_dc_2"});
  for (Eigen::Index i = 0; i < 3 * (bands_squared - 1); ++i) names.push_back(fmt::format("f_rest_{}", i));
  names.insert(names.end(), {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"});
  return names;
}

}  // namespace

Splats random_splats(int count, int degree, unsigned seed) {
  Random random(seed);
  Splats splats;
  for (int i = 0; i < count; ++i) splats.push_back(random_splat(random, (degree + 1) * (degree + 1)));
  if (count > 7) make_extreme(splats);
  return splats;
}

Eigen::Vector3d color_of(const Splat& splat, const Eigen::Vector3d& direction) {
  const auto& presets = numeric::identify::presets();
  const auto preset =
      std::find_if(presets.begin(), presets.end(), [](const auto& p) { return p.name == "gaussian-splatting"; });
  const int degree = static_cast<int>(std::lround(std::sqrt(splat.coefficients.cols()))) - 1;
  const auto values =
      numeric::identify::convention_values(preset->convention, degree, {direction.x(), direction.y(), direction.z()});
  Eigen::Vector3d color = Eigen::Vector3d::Constant(0.5);
  for (Eigen::Index k = 0; k < splat.coefficients.cols(); ++k) {
    color += splat.coefficients.col(k) * values[static_cast<std::size_t>(k)].real();
  }
  return color;
}

Eigen::Matrix3d covariance_of(const Splat& splat) {
  const Eigen::Vector4d q = splat.rotation.normalized();
  const Eigen::Matrix3d r = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  const Eigen::Matrix3d s = splat.log_scale.array().exp().matrix().asDiagonal();
  return r * s * s.transpose() * r.transpose();
}

std::string ply_of(const Splats& splats, const PlyText& text) {
  const Eigen::Index size = splats.empty() ? 1 : splats[0].coefficients.cols();
  std::string bytes =
      fmt::format("ply\nformat {} 1.0\n{}element vertex {}\n", text.format, text.after_format, splats.size());
  for (const std::string& name : text.first) bytes += fmt::format("property int {}\n", name);
  for (const std::string& name : names_of(size, text.normals)) {
    bytes += fmt::format("property {} {}\n", text.doubles ? "double" : "float", name);
  }
  for (const std::string& name : text.last) bytes += fmt::format("property int {}\n", name);
  bytes += text.tail_header + "end_header\n";
  const bool is_text = text.format == "ascii";
  const bool is_big = text.format == "binary_big_endian";
  for (std::size_t i = 0; i < splats.size(); ++i) {
    const auto add = [&](auto value) {
      if (is_text) {
        bytes += fmt::format("{} ", value);
      } else {
        append(bytes, value, is_big);
      }
    };
    for (std::size_t k = 0; k < text.first.size(); ++k) add(static_cast<std::int32_t>(7 * i + k));
    for (const double value : numbers_of(splats[i], text.normals)) {
      if (text.doubles) {
        add(value);
      } else {
        add(static_cast<float>(value));
      }
    }
    for (std::size_t k = 0; k < text.last.size(); ++k) add(static_cast<std::int32_t>(7 * i + k));
    if (is_text) bytes += "\n";
  }
  return bytes + text.tail;
}

Splats splats_of_ply(const std::string& bytes) {
  const std::string end = "end_header\n";
  const std::size_t body = bytes.find(end) + end.size();
  std::istringstream header(bytes.substr(0, body));
  std::map<std::string, std::size_t> offsets;
  std::size_t count = 0;
  std::size_t record = 0;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if (first == "element" && second != "vertex") break;
    if (first == "element") count = std::stoul(third);
    if (first == "property") {
      offsets[third] = record;
      record += 4;
    }
  }
  std::size_t rest = 0;
  while (offsets.count(fmt::format("f_rest_{}", rest)) != 0) ++rest;
  const auto size = static_cast<Eigen::Index>(rest / 3 + 1);
  Splats splats(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = [&](const std::string& name) {
      float v = 0.0F;
      std::memcpy(&v, bytes.data() + body + i * record + offsets.at(name), sizeof v);
      return static_cast<double>(v);
    };
    Splat& splat = splats[i];
    splat.position = {value("x"), value("y"), value("z")};
    splat.rotation = {value("rot_0"), value("rot_1"), value("rot_2"), value("rot_3")};
    splat.log_scale = {value("scale_0"), value("scale_1"), value("scale_2")};
    splat.opacity = value("opacity");
    splat.coefficients.resize(3, size);
    for (Eigen::Index c = 0; c < 3; ++c) {
      splat.coefficients(c, 0) = value(fmt::format("f_dc_{}", c));
      for (Eigen::Index k = 1; k < size; ++k) {
        splat.coefficients(c, k) = value(fmt::format("f_rest_{}", c * (size - 1) + k - 1));
      }
    }
  }
  return splats;
}

std::vector<NamedRotation> rotations() {
  const auto about = [](double degrees, double x, double y, double z) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(x, y, z).normalized()).toRotationMatrix();
  };
  std::vector<NamedRotation> all = {
      {"none", Eigen::Matrix3d::Identity()},          {"half turn about x", about(180, 1, 0, 0)},
      {"half turn about y", about(180, 0, 1, 0)},     {"half turn about z", about(180, 0, 0, 1)},
      {"half turn about 1 1 0", about(180, 1, 1, 0)}, {"half turn about 1 2 3", about(180, 1, 2, 3)},
      {"quarter turn about x", about(90, 1, 0, 0)},   {"120 degrees about 1 1 1", about(120, 1, 1, 1)},
      {"30 degrees about z", about(30, 0, 0, 1)}};
  for (const double tilt : {1e-9, 1e-7, 2e-4, 1e-3}) {
    all.push_back({fmt::format("tilt of {} rad", tilt), about(tilt * 180.0 / std::numbers::pi, 1, -2, 0.5)});
    all.push_back(
        {fmt::format("half turn less {} rad", tilt), about(180.0 - tilt * 180.0 / std::numbers::pi, -1, 1, 0.1)});
  }
  Random random(5);
  std::normal_distribution<> normal;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    all.push_back({fmt::format("random {}", i), q.normalized().toRotationMatrix()});
  }
  return all;
}

std::vector<Eigen::Vector3d> directions(int count, unsigned seed) {
  Random random(seed);
  std::normal_distribution<> normal;
  std::vector<Eigen::Vector3d> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized());
  }
  for (int k = 0; k < 3; ++k) all[static_cast<std::size_t>(k)] = Eigen::Vector3d::Unit(k);
  return all;
}

double color_difference(const Splat& splat, const Splat& turned, const Eigen::Matrix3d& matrix) {
  static const std::vector<Eigen::Vector3d> kDirections = directions(100, 11);
  double most = 0.0;
  for (const Eigen::Vector3d& d : kDirections) {
    most = std::max(most, (color_of(turned, matrix * d) - color_of(splat, d)).cwiseAbs().maxCoeff());
  }
  return most;
}

}  // namespace sh::prt::test
