#include "prt/mesh/soup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "prt/mesh/corner_angle.hpp"

namespace sh::prt {

namespace {

// A face has no usable normal if twice its area is below this part of its longest edge squared, which is rounding.
constexpr double kFlat = 1e-7;

bool has_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kFlat * longest;
}

}  // namespace

void transform(Soup& soup, const Eigen::Affine3f& map) {
  const Eigen::Matrix3d linear = map.linear().cast<double>();
  const double determinant = linear.determinant();
  // The cofactor matrix is the inverse transpose up to a positive or negative factor, and exists for flat maps as well.
  Eigen::Matrix3d cofactors;
  for (int i = 0; i < 3; ++i) cofactors.row(i) = linear.row((i + 1) % 3).cross(linear.row((i + 2) % 3));
  for (Eigen::Vector3f& position : soup.positions) position = map * position;
  for (Eigen::Vector3f& normal : soup.normals) {
    normal = (cofactors * normal.cast<double>() * (determinant < 0.0 ? -1.0 : 1.0)).normalized().cast<float>();
  }
  if (determinant < 0.0) {
    for (Face& face : soup.faces) std::swap(face[1], face[2]);
  }
}

void check(const Soup& soup, const std::string& name) {
  if (soup.faces.empty()) {
    throw std::runtime_error(fmt::format("{}: the mesh has no faces, expected at least one triangle", name));
  }
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    if (!soup.positions[i].allFinite()) {
      throw std::runtime_error(fmt::format("{}: vertex {} has a coordinate that is not finite", name, i));
    }
  }
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const std::uint32_t last = *std::max_element(soup.faces[f].begin(), soup.faces[f].end());
    if (last >= soup.positions.size()) {
      throw std::runtime_error(
          fmt::format("{}: face {} names vertex {}, but there are {} vertices", name, f, last, soup.positions.size()));
    }
  }
}

void turn_inside_out(Soup& soup) {
  for (Face& face : soup.faces) std::swap(face[1], face[2]);
  for (Eigen::Vector3f& normal : soup.normals) normal = -normal;
}

std::size_t turn_faces_to_normals(Soup& soup) {
  std::size_t turned = 0;
  for (Face& face : soup.faces) {
    const Eigen::Vector3f along = soup.normals[face[0]] + soup.normals[face[1]] + soup.normals[face[2]];
    if (along.dot(face_normal(soup.positions, face)) < 0.0F) {
      std::swap(face[1], face[2]);
      ++turned;
    }
  }
  return turned;
}

std::size_t drop_faces_without_area(Soup& soup) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Face face = soup.faces[f];
    if (has_area(soup.positions[face[0]].cast<double>(), soup.positions[face[1]].cast<double>(),
                 soup.positions[face[2]].cast<double>())) {
      soup.faces[kept] = face;
      if (!soup.finish.empty()) soup.finish[kept] = soup.finish[f];
      ++kept;
    }
  }
  const std::size_t dropped = soup.faces.size() - kept;
  soup.faces.resize(kept);
  soup.finish.resize(soup.finish.empty() ? 0 : kept);
  return dropped;
}

}  // namespace sh::prt
