#include "prt/gather.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prt/basis.hpp"
#include "prt/corner_angle.hpp"
#include "prt/directions.hpp"

namespace sh::prt {

namespace {

constexpr float kOffset = 1e-5F;           // of the mesh's extent
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

float offset_length(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) {
    box.extend(position);
  }
  // Far from the origin of the coordinates, their rounding is what must be cleared.
  const float farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max(kOffset * box.diagonal().norm(), 32.0F * std::numeric_limits<float>::epsilon() * farthest);
}

}  // namespace

std::vector<Eigen::Vector3f> ray_origins(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> inward(mesh.positions.size(), Eigen::Vector3f::Zero());
  std::vector<float> reach(mesh.positions.size(), 0.0F);
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0F;
    for (const std::uint32_t v : face) {
      inward[v] += middle - mesh.positions[v];
      reach[v] += (middle - mesh.positions[v]).norm();
    }
  }
  const float length = mesh.positions.empty() ? 0.0F : offset_length(mesh);
  std::vector<Eigen::Vector3f> origins;
  origins.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f& up = mesh.geometric_normals[v];
    const Eigen::Vector3f along = reach[v] > 0.0F ? (inward[v] / reach[v]).eval() : Eigen::Vector3f::Zero().eval();
    origins.emplace_back(mesh.positions[v] + length * (up + along - along.dot(up) * up));
  }
  return origins;
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

bool Gatherer::is_buried(const Mesh& mesh, std::size_t vertex, const Eigen::Vector3f& origin) {
  const std::size_t traced = aim(origin, mesh.normals[vertex], mesh.geometric_normals[vertex]);
  std::vector<Eigen::Vector3f> directions;
  for (std::size_t i = 0; i < traced; ++i) {
    directions.push_back(directions_.direction(chosen_[i]));
  }
  std::vector<Hit> hits(traced);
  tracer_.intersect(std::vector<Eigen::Vector3f>(traced, origin), directions, hits);
  std::size_t backs = 0;
  for (std::size_t i = 0; i < traced; ++i) {
    const bool hit = hits[i].face != Hit::kNothing;
    backs += hit && face_normal(mesh.positions, mesh.faces[hits[i].face]).dot(directions[i]) > 0.0F ? 1 : 0;
  }
  return 2 * backs >= traced;
}

std::vector<ShadowRay> Gatherer::rays(const Eigen::Vector3f& origin, const Eigen::Vector3f& normal,
                                      const Eigen::Vector3f& geometric_normal) {
  const std::size_t traced = aim(origin, normal, geometric_normal);
  return {rays_.begin(), rays_.begin() + static_cast<std::ptrdiff_t>(traced)};
}

}  // namespace sh::prt
