// The frame of a mesh's positions. They are single precision, so far from the origin they would lose the digits of the
// shape, and at extreme scales the products of ray tracing would over- or underflow. Such a mesh gets another origin and
// unit: world = origin + unit * position. Ordinary meshes keep the world's axes to the bit.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace sh::prt {

struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double unit = 1.0;  // a power of two

  [[nodiscard]] Eigen::Vector3d world(const Eigen::Vector3f& position) const {
    return origin + unit * position.cast<double>();
  }
  [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector3d& point) const { return (point - origin) / unit; }
  [[nodiscard]] bool is_world() const { return *this == Frame(); }
  bool operator==(const Frame& other) const { return origin == other.origin && unit == other.unit; }
};

/// The largest error of rounding 1 to single precision.
inline constexpr double kSingleRounding = 0x1p-24;

/// Meshes whose longest side is outside of these limits are refused; unit of the world.
inline constexpr double kLeastExtent = 1e-30;
inline constexpr double kLargestExtent = 1e30;

/// The frame for points in this box. It is the world if the box lies within 16 of its extents of the origin and its
/// extent is 1e-3 to 1e6; else positions are at most an extent and 1e6 large. The extent is the longest side.
/// Throws std::runtime_error, one line that begins with `name`, for a box outside of the limits above.
Frame frame_around(const Eigen::AlignedBox3d& box, const std::string& name);

}  // namespace sh::prt
