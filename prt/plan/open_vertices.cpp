#include "prt/plan/open_vertices.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "prt/chunks.hpp"
#include "prt/rays/directions.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLeaf = 64;  // points a box
constexpr int kLandmarks = 64;     // directions whose farthest points rule most vertices out

// Points in boxes, so that a search for the farthest point along a direction skips most points.
class Boxes {
 public:
  explicit Boxes(const std::vector<Eigen::Vector3f>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    split(0, order_.size());
  }

  /// Whether a point p has normal.p > height.
  [[nodiscard]] bool any_above(const Eigen::Vector3d& normal, double height) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      const Eigen::Vector3d reach = box.half.cwiseProduct(normal.cwiseAbs());
      return normal.dot(box.middle) + reach.sum() > height &&
             std::any_of(order_.begin() + box.first, order_.begin() + box.last,
                         [&](std::uint32_t i) { return normal.dot(points_[i].cast<double>()) > height; });
    });
  }

 private:
  struct Box {
    Eigen::Vector3d middle;
    Eigen::Vector3d half;
    std::size_t first;
    std::size_t last;
  };

  void split(std::size_t first, std::size_t last) {
    Eigen::AlignedBox3d bounds;
    for (std::size_t i = first; i < last; ++i) bounds.extend(points_[order_[i]].cast<double>());
    if (last - first <= kLeaf) {
      boxes_.push_back({bounds.center(), 0.5 * bounds.sizes(), first, last});
      return;
    }
    Eigen::Index axis = 0;
    bounds.sizes().maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = order_.begin();
    std::nth_element(begin + first, begin + middle, begin + last,
                     [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    split(first, middle);
    split(middle, last);
  }

  const std::vector<Eigen::Vector3f>& points_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

// The farthest points along a few directions.
std::vector<Eigen::Vector3d> landmarks(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3d> found;
  for (const Eigen::Vector3f& direction : make_directions(Sampler::kFibonacci, kLandmarks)) {
    const auto farther = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      return a.dot(direction) < b.dot(direction);
    };
    found.emplace_back(std::max_element(points.begin(), points.end(), farther)->cast<double>());
  }
  return found;
}

}  // namespace

std::vector<std::uint8_t> open_vertices(const Mesh& mesh, const std::vector<RayStart>& starts, double most_angle) {
  std::vector<std::uint8_t> open(starts.size(), 0);
  if (mesh.positions.empty()) return open;
  const std::vector<Eigen::Vector3d> marks = landmarks(mesh.positions);
  const Boxes boxes(mesh.positions);
  for_vertices(starts.size(), [&](std::size_t v) {
    const Eigen::Vector3d up = mesh.geometric_normals[v].cast<double>();
    const double height = up.dot(starts[v].origin.cast<double>());
    const bool agrees = (mesh.normals[v].cast<double>() - up).norm() <= most_angle;
    const auto above = [&](const Eigen::Vector3d& p) { return up.dot(p) > height; };
    open[v] = agrees && std::none_of(marks.begin(), marks.end(), above) && !boxes.any_above(up, height) ? 1 : 0;
  });
  return open;
}

double lune_error(double angle) { return 2.0 / (3.0 * std::numbers::pi) * std::pow(angle, 1.5); }

}  // namespace sh::prt
