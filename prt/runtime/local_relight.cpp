#include "prt/runtime/local_relight.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sh::prt {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kPower = 4.0;  // of the distance

/// The index of the nearest point, and its squared distance.
struct Nearest {
  std::size_t point = 0;
  double squared = std::numeric_limits<double>::infinity();
};

Nearest nearest(const Points& points, const Eigen::Vector3d& place) {
  Nearest best;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double squared = (points[j] - place).squaredNorm();
    if (squared < best.squared) best = {j, squared};
  }
  return best;
}

/// Takes the vertex nearest to the mean, then repeatedly the vertex farthest from all points so far.
Points spread(const Points& vertices, int k) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vertices) mean += v / static_cast<double>(vertices.size());
  Points points{vertices[nearest(vertices, mean).point]};
  std::vector<double> squared(vertices.size(), std::numeric_limits<double>::infinity());
  while (true) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      squared[v] = std::min(squared[v], (vertices[v] - points.back()).squaredNorm());
    }
    const auto farthest = std::max_element(squared.begin(), squared.end());
    if (static_cast<int>(points.size()) == k || *farthest == 0.0) return points;
    points.push_back(vertices[farthest - squared.begin()]);
  }
}

Points k_means(const Points& vertices, int k) {
  constexpr int kRounds = 30;
  Points points = spread(vertices, k);
  for (int round = 0; round < kRounds; ++round) {
    Points sums(points.size(), Eigen::Vector3d::Zero());
    std::vector<double> counts(points.size(), 0.0);
    for (const Eigen::Vector3d& v : vertices) {
      const std::size_t j = nearest(points, v).point;
      sums[j] += v;
      counts[j] += 1.0;
    }
    bool moved = false;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (counts[j] > 0.0 && points[j] != sums[j] / counts[j]) {
        points[j] = sums[j] / counts[j];
        moved = true;
      }
    }
    if (!moved) break;
  }
  return points;
}

void add_distance_weights(const Points& points, const Eigen::Vector3d& vertex, std::vector<float>& weights) {
  const Nearest closest = nearest(points, vertex);
  std::vector<double> row;
  double sum = 0.0;
  for (const Eigen::Vector3d& point : points) {  // relative to the nearest: no overflow, and 1 on a point itself
    const double squared = (point - vertex).squaredNorm();
    row.push_back(squared == closest.squared ? 1.0 : std::pow(closest.squared / squared, 0.5 * kPower));
    sum += row.back();
  }
  for (const double weight : row) weights.push_back(static_cast<float>(weight / sum));
}

/// Barycentric coordinates of the point of a triangle that is nearest to the origin: the solution on the plane if it
/// lies inside, else the nearest point on the edges.
Eigen::Vector3d nearest_on_triangle(const std::array<Eigen::Vector3d, 3>& corner) {
  const Eigen::Vector3d u = corner[1] - corner[0];
  const Eigen::Vector3d v = corner[2] - corner[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double ud = -u.dot(corner[0]), vd = -v.dot(corner[0]);
  const double area = uu * vv - uv * uv;
  const double s = (vv * ud - uv * vd) / area;
  const double t = (uu * vd - uv * ud) / area;
  if (s >= 0.0 && t >= 0.0 && s + t <= 1.0) return {1.0 - s - t, s, t};
  Eigen::Vector3d best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int a = i, b = (i + 1) % 3;
    const Eigen::Vector3d edge = corner[b] - corner[a];
    const double along = std::clamp(-edge.dot(corner[a]) / edge.squaredNorm(), 0.0, 1.0);
    const double squared = (corner[a] + along * edge).squaredNorm();
    if (squared < least) {
      least = squared;
      best.setZero();
      best[i] = 1.0 - along;
      best[(i + 1) % 3] += along;
    }
  }
  return best;
}

/// Corners 0..5: +x -x +y -y +z -z; the face of an octant has one of each pair.
void add_octahedron_weights(const Points& corners, const Eigen::Vector3d& vertex, std::vector<float>& weights) {
  std::array<float, 6> row{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t octant = 0; octant < 8; ++octant) {
    const std::array<std::size_t, 3> face{octant & 1U, 2 + (octant >> 1U & 1U), 4 + (octant >> 2U & 1U)};
    const std::array<Eigen::Vector3d, 3> triangle{corners[face[0]] - vertex, corners[face[1]] - vertex,
                                                  corners[face[2]] - vertex};
    const Eigen::Vector3d bary = nearest_on_triangle(triangle);
    const double squared = (bary[0] * triangle[0] + bary[1] * triangle[1] + bary[2] * triangle[2]).squaredNorm();
    if (squared < least) {
      least = squared;
      row = {};
      for (int i = 0; i < 3; ++i) row[face[i]] = static_cast<float>(bary[i]);
    }
  }
  weights.insert(weights.end(), row.begin(), row.end());
}

}  // namespace

LightSamples samples_by_distance(std::span<const Eigen::Vector3d> vertices, int k) {
  if (k < 1 || k > kMaxLightSamples || vertices.empty()) {
    throw std::invalid_argument(
        fmt::format("{} light samples for {} vertices: expected 1 to {}", k, vertices.size(), kMaxLightSamples));
  }
  const Points places(vertices.begin(), vertices.end());
  LightSamples samples{k_means(places, k), {}};
  for (const Eigen::Vector3d& place : places) add_distance_weights(samples.points, place, samples.weights);
  return samples;
}

LightSamples samples_on_octahedron(std::span<const Eigen::Vector3d> vertices) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : vertices) box.extend(v);
  if (vertices.empty() || !(box.diagonal().norm() > 0.0)) {
    throw std::invalid_argument("a mesh without extent has no polyhedron around it");
  }
  const Eigen::Vector3d half = (0.5 * box.diagonal()).cwiseMax(0.01 * box.diagonal().norm());
  LightSamples samples;
  for (int axis = 0; axis < 3; ++axis) {
    samples.points.emplace_back(box.center() + half[axis] * Eigen::Vector3d::Unit(axis));
    samples.points.emplace_back(box.center() - half[axis] * Eigen::Vector3d::Unit(axis));
  }
  for (const Eigen::Vector3d& v : vertices) add_octahedron_weights(samples.points, v, samples.weights);
  return samples;
}

std::vector<Eigen::Vector3f> relight_locally(const Transfer& transfer, const LightSamples& samples,
                                             std::span<const LightCoefficients> lights, const Shading& shading) {
  const std::size_t vertices = transfer.mesh.positions.size();
  const std::size_t k = lights.size();
  if (transfer.kind->shape(0).holds_albedo) {
    throw std::invalid_argument(
        "local lighting needs unshadowed or shadowed transfer; with bounces, or through bodies, light comes from other "
        "places too");
  }
  if (k == 0 || samples.weights.size() != k * vertices) {
    throw std::invalid_argument(
        fmt::format("{} weights for {} lights at {} vertices: expected one for each light and vertex",
                    samples.weights.size(), k, vertices));
  }
  std::vector<Eigen::Vector3f> sum = shading.shade(transfer, lights[0]);
  if (k == 1) return sum;
  for (std::size_t v = 0; v < vertices; ++v) sum[v] *= samples.weights[v * k];
  for (std::size_t j = 1; j < k; ++j) {
    const std::vector<Eigen::Vector3f> more = shading.shade(transfer, lights[j]);
    for (std::size_t v = 0; v < vertices; ++v) sum[v] += samples.weights[v * k + j] * more[v];
  }
  return sum;
}

}  // namespace sh::prt
