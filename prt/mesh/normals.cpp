// Computes vertex normals if a file has none. Weights are the angles of the corners [Thuermer, Wuethrich 1998].
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "prt/mesh/corner_angle.hpp"
#include "prt/mesh/soup.hpp"
#include "prt/mesh/vertex_key.hpp"

namespace sh::prt {

namespace {

struct Corner {
  std::uint32_t face;
  float angle;
};

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
  for (const Eigen::Vector3f& position : soup.positions) {
    const auto next = static_cast<std::uint32_t>(points.size());
    point_of_vertex.push_back(points.try_emplace(bits_of(position), next).first->second);
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
      corners.source.push_back(soup.source.empty() ? v : soup.source[v]);
    }
    corners.faces.push_back(face);
  }
  corners.finish = std::move(soup.finish);  // the faces and their order are the same
  corners.finishes = std::move(soup.finishes);
  soup = std::move(corners);
  return replaced;
}

}  // namespace sh::prt
