#include "prt/mesh/soup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "prt/mesh/corners.hpp"

namespace sh::prt {
namespace {

// A face has no usable normal if twice its area is below this part of its longest edge squared, which is rounding.
constexpr double kFlat = 1e-7;

bool has_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kFlat * longest;
}

struct Corner {
  std::uint32_t face;
  float angle;
};

// Coordinates that are missing among others are not finite.
void check_texture(const Soup& soup, std::size_t face, const std::string& name) {
  const auto has_any = [&](std::uint32_t v) { return !soup.texture.empty() && soup.texture[v].allFinite(); };
  if (std::all_of(soup.faces[face].begin(), soup.faces[face].end(), has_any)) return;
  throw std::runtime_error(fmt::format(
      "{}: face {} has a normal map or a texture, but no finite texture coordinates; expected both, or neither", name,
      face));
}

std::vector<Eigen::Vector3f> face_normals(const Soup& soup) {
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(soup.faces.size());
  for (const Face& face : soup.faces) normals.push_back(face_normal(soup.positions, face));
  return normals;
}

// The faces around every position, in the order of the faces.
std::vector<std::vector<Corner>> corners_around(const Soup& soup, std::vector<std::uint32_t>& point_of_vertex) {
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, WordsHash> points;
  point_of_vertex.clear();
  for (const Eigen::Vector3d& position : soup.positions) {
    const auto next = static_cast<std::uint32_t>(points.size());
    point_of_vertex.push_back(points.try_emplace(bits_of(position.cast<float>().eval()), next).first->second);
  }
  std::vector<std::vector<Corner>> around(points.size());
  for (std::uint32_t f = 0; f < soup.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      around[point_of_vertex[soup.faces[f][k]]].push_back({f, corner_angle(soup.positions, soup.faces[f], k)});
    }
  }
  return around;
}

}  // namespace

void transform(Soup& soup, const Eigen::Affine3d& map) {
  const Eigen::Matrix3d linear = map.linear();
  const double determinant = linear.determinant();
  // The cofactor matrix is the inverse transpose up to a positive or negative factor, and exists for flat maps as well.
  Eigen::Matrix3d cofactors;
  for (int i = 0; i < 3; ++i) cofactors.row(i) = linear.row((i + 1) % 3).cross(linear.row((i + 2) % 3));
  for (Eigen::Vector3d& position : soup.positions) position = map * position;
  for (Eigen::Vector3f& normal : soup.normals) {
    normal = (cofactors * normal.cast<double>() * (determinant < 0.0 ? -1.0 : 1.0)).normalized().cast<float>();
  }
  for (MeshNode& node : soup.nodes) node.to_world = map * node.to_world;
  soup.rounding *= linear.norm() / std::numbers::sqrt3;
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
    if (soup.finishes[soup.finish_of(f)].has_pictures()) check_texture(soup, f, name);
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
    if (has_area(soup.positions[face[0]], soup.positions[face[1]], soup.positions[face[2]])) {
      soup.faces[kept] = face;
      if (!soup.finish.empty()) soup.finish[kept] = soup.finish[f];
      if (!soup.node.empty()) soup.node[kept] = soup.node[f];
      ++kept;
    }
  }
  const std::size_t dropped = soup.faces.size() - kept;
  soup.faces.resize(kept);
  soup.finish.resize(soup.finish.empty() ? 0 : kept);
  soup.node.resize(soup.node.empty() ? 0 : kept);
  return dropped;
}

std::size_t complete_normals(Soup& soup, float crease_degrees) {
  const bool none = soup.normals.empty();
  const auto useless = [&](std::uint32_t v) {
    return none || !soup.normals[v].allFinite() || soup.normals[v].norm() < 1e-6F;
  };
  std::size_t replaced = 0;
  for (std::uint32_t v = 0; v < soup.normals.size(); ++v) {
    replaced += useless(v) ? 1 : 0;
    soup.normals[v] = useless(v) ? soup.normals[v] : soup.normals[v].normalized();
  }
  if (!none && replaced == 0) return 0;
  const std::vector<Eigen::Vector3f> flat = face_normals(soup);
  std::vector<std::uint32_t> point_of_vertex;
  const std::vector<std::vector<Corner>> around = corners_around(soup, point_of_vertex);
  const float least_cosine = std::cos(crease_degrees * std::numbers::pi_v<float> / 180.0F) - 1e-6F;
  Soup corners;
  for (std::uint32_t f = 0; f < soup.faces.size(); ++f) {
    Face face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = soup.faces[f][k];
      Eigen::Vector3f normal = Eigen::Vector3f::Zero();
      if (useless(v)) {
        for (const Corner& corner : around[point_of_vertex[v]]) {
          normal += flat[corner.face].dot(flat[f]) >= least_cosine ? flat[corner.face] * corner.angle
                                                                   : Eigen::Vector3f::Zero().eval();
        }
      } else {
        normal = soup.normals[v];
      }
      face[k] = static_cast<std::uint32_t>(corners.positions.size());
      corners.positions.push_back(soup.positions[v]);
      corners.normals.push_back(normal.norm() > 0.0F ? normal.normalized() : flat[f]);
      corners.albedo.push_back(soup.albedo[v]);
      if (!soup.texture.empty()) corners.texture.push_back(soup.texture[v]);
      if (!soup.chart.empty()) corners.chart.push_back(soup.chart[v]);
      corners.source.push_back(soup.source.empty() ? v : soup.source[v]);
    }
    corners.faces.push_back(face);
  }
  corners.finish = std::move(soup.finish);  // the faces and their order are the same
  corners.finishes = std::move(soup.finishes);
  corners.node = std::move(soup.node);
  corners.nodes = std::move(soup.nodes);
  corners.rounding = soup.rounding;
  soup = std::move(corners);
  return replaced;
}

}  // namespace sh::prt
