#include "prt/mesh/frame.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

namespace {

constexpr double kNear = 16.0;  // extents from the origin
constexpr double kLeastOrdinary = 1e-3;
constexpr double kLargestOrdinary = 1e6;
constexpr double kStep = 0.25;  // of the extent, to which an origin is rounded

double power_of_two_near(double length) { return std::exp2(std::round(std::log2(length))); }

}  // namespace

Frame frame_around(const Eigen::AlignedBox3d& box, const std::string& name) {
  Frame frame;
  const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  if (extent == 0.0) return frame;  // no face of it has an area
  if (!(extent >= kLeastExtent && extent <= kLargestExtent)) {
    throw std::runtime_error(fmt::format("{}: the extent of the meshes: expected {:g} to {:g}, got {:g}", name,
                                         kLeastExtent, kLargestExtent, extent));
  }
  const double scale = power_of_two_near(extent);
  if (extent < kLeastOrdinary || extent > kLargestOrdinary) frame.unit = scale;
  const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  if (farthest > kNear * extent) {
    const double step = kStep * scale;  // a power of two, so that the origin has few digits
    frame.origin = (box.center() / step).array().round().matrix() * step;
  }
  return frame;
}

std::vector<Eigen::Vector3d> points_of(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) points.push_back(mesh.point(v));
  return points;
}

void place(Mesh& mesh, const std::vector<Eigen::Vector3d>& points, const std::string& name) {
  mesh.frame = frame_around(bounding_box(points), name);
  mesh.positions.clear();
  for (const Eigen::Vector3d& point : points) mesh.positions.emplace_back(mesh.frame.local(point).cast<float>());
}

}  // namespace sh::prt
