#include "prt/gather.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prt/basis.hpp"
#include "prt/corner_angle.hpp"
#include "prt/directions.hpp"

namespace sh::prt {

namespace {

constexpr float kOffset = 2e-3F;           // of the reach of the mesh around
constexpr float kRoundings = 32.0F;        // and no less than this many roundings of the coordinates
constexpr float kCoveredReach = 2.0F;      // what is nearer than this many reaches
constexpr float kCoveredWeight = 0.97F;    // along so much of the cosine covers a vertex
constexpr std::size_t kRowUnit = 8;        // floats
constexpr std::size_t kStreamRays = 1024;  // a stream call

// sum (row_length) += weight row; lanes are coefficients, so the bits do not depend on the width of the registers.
inline void add_row(float weight, const float* row, std::size_t row_length, float* sum) {
  for (std::size_t first = 0; first < row_length; first += kRowUnit) {
    for (std::size_t i = first; i < first + kRowUnit; ++i) {
      sum[i] += weight * row[i];
    }
  }
}

}  // namespace

std::vector<RayStart> ray_starts(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> inward(mesh.positions.size(), Eigen::Vector3f::Zero());
  std::vector<float> distance(mesh.positions.size(), 0.0F);
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0F;
    for (const std::uint32_t v : face) {
      inward[v] += middle - mesh.positions[v];
      distance[v] += (middle - mesh.positions[v]).norm();
      ++faces[v];
    }
  }
  std::vector<RayStart> starts;
  starts.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f& position = mesh.positions[v];
    const float reach = distance[v] / static_cast<float>(std::max(faces[v], 1));
    const float rounding = std::numeric_limits<float>::epsilon() * position.cwiseAbs().maxCoeff();
    const float length = std::max(kOffset * reach, kRoundings * rounding);
    const Eigen::Vector3f& up = mesh.geometric_normals[v];
    const Eigen::Vector3f along = distance[v] > 0.0F ? (inward[v] / distance[v]).eval() : inward[v];
    starts.push_back({position + length * (up + along - along.dot(up) * up), reach});
  }
  return starts;
}

SharedDirections::SharedDirections(int count, int degree)
    : directions_(fibonacci_directions(count)),
      row_length_((static_cast<std::size_t>((degree + 1) * (degree + 1)) + kRowUnit - 1) / kRowUnit * kRowUnit),
      values_(directions_.size() * row_length_, 0.0F) {
  for (std::size_t j = 0; j < directions_.size(); ++j) {
    const Eigen::Vector3f& d = directions_[j];
    evaluate_basis(degree, d.x(), d.y(), d.z(), values_.data() + j * row_length_);
  }
}

Gatherer::Gatherer(const SharedDirections& directions, const Tracer& tracer)
    : directions_(directions),
      tracer_(tracer),
      rays_(directions.size()),
      chosen_(directions.size()),
      below_(directions.size()),
      weights_(directions.size()) {}

std::size_t Gatherer::aim(const Eigen::Vector3f& origin, const Eigen::Vector3f& normal,
                          const Eigen::Vector3f& geometric_normal) {
  const float scale = 4.0F / static_cast<float>(directions_.size());
  std::size_t traced = 0;
  below_.clear();
  for (std::uint32_t j = 0; j < directions_.size(); ++j) {
    const Eigen::Vector3f& direction = directions_.direction(j);
    const float cosine = normal.dot(direction);
    if (cosine <= 0.0F) {
      continue;
    }
    weights_[j] = scale * cosine;
    if (geometric_normal.dot(direction) > 0.0F) {
      rays_[traced].aim(origin, direction);
      chosen_[traced] = j;
      ++traced;
    } else {
      below_.push_back(j);
    }
  }
  return traced;
}

const Gathered& Gatherer::gather(const Eigen::Vector3f& origin, const Eigen::Vector3f& normal,
                                 const Eigen::Vector3f& geometric_normal) {
  const std::size_t traced = aim(origin, normal, geometric_normal);
  const std::size_t length = directions_.row_length();
  for (std::size_t first = 0; first < traced; first += kStreamRays) {
    tracer_.occluded({rays_.data() + first, std::min(kStreamRays, traced - first)});
  }
  Gathered blocked;
  std::fill_n(result_.visible.begin(), length, 0.0F);
  std::fill_n(blocked.all.begin(), length, 0.0F);
  float weight_blocked = 0.0F;
  result_.weight_visible = 0.0F;
  for (std::size_t i = 0; i < traced; ++i) {
    const std::uint32_t j = chosen_[i];
    const bool hit = rays_[i].blocked();
    add_row(weights_[j], directions_.row(j), length, hit ? blocked.all.data() : result_.visible.data());
    (hit ? weight_blocked : result_.weight_visible) += weights_[j];
  }
  for (const std::uint32_t j : below_) {
    add_row(weights_[j], directions_.row(j), length, blocked.all.data());
    weight_blocked += weights_[j];
  }
  result_.weight_all = result_.weight_visible + weight_blocked;
  for (std::size_t i = 0; i < length; ++i) {
    result_.all[i] = result_.visible[i] + blocked.all[i];
  }
  return result_;
}

Sight Gatherer::classify(const Mesh& mesh, std::size_t vertex, const RayStart& start, bool is_dark) {
  const std::size_t traced = aim(start.origin, mesh.normals[vertex], mesh.geometric_normals[vertex]);
  std::vector<Eigen::Vector3f> directions;
  for (std::size_t i = 0; i < traced; ++i) {
    directions.push_back(directions_.direction(chosen_[i]));
  }
  std::vector<Hit> hits(traced);
  tracer_.intersect(std::vector<Eigen::Vector3f>(traced, start.origin), directions, hits);
  std::size_t backs = 0;
  float weight_near = 0.0F;
  float weight = 0.0F;
  for (std::size_t i = 0; i < traced; ++i) {
    const bool hit = hits[i].face != Hit::kNothing;
    backs += hit && face_normal(mesh.positions, mesh.faces[hits[i].face]).dot(directions[i]) > 0.0F ? 1 : 0;
    weight_near += hit && hits[i].distance < kCoveredReach * start.reach ? weights_[chosen_[i]] : 0.0F;
    weight += weights_[chosen_[i]];
  }
  if (is_dark && 2 * backs >= traced) {
    return Sight::kBuried;
  }
  if (weight_near > kCoveredWeight * weight) {
    return Sight::kCovered;
  }
  return is_dark ? Sight::kDark : Sight::kSome;
}

std::vector<ShadowRay> Gatherer::rays(const Eigen::Vector3f& origin, const Eigen::Vector3f& normal,
                                      const Eigen::Vector3f& geometric_normal) {
  const std::size_t traced = aim(origin, normal, geometric_normal);
  return {rays_.begin(), rays_.begin() + static_cast<std::ptrdiff_t>(traced)};
}

}  // namespace sh::prt
