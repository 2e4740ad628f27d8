// The angle between directions, and the frame about one.
#pragma once
#include <Eigen/Core>
#include <cmath>

namespace sh::prt {

/// The angle between two unit vectors, 0..pi, to a few roundings everywhere. The arc cosine of their product would be off
/// by the root of a rounding where they are parallel.
template <class T>
T angle_between(const Eigen::Vector3<T>& a, const Eigen::Vector3<T>& b) {
  return 2 * std::atan2((a - b).norm(), (a + b).norm());
}

/// A rotation whose third column is `normal`, |normal| = 1, without a branch [Duff17].
template <class T>
Eigen::Matrix3<T> frame_about(const Eigen::Vector3<T>& normal) {
  const T sign = std::copysign(T(1), normal.z());
  const T a = T(-1) / (sign + normal.z());
  const T b = normal.x() * normal.y() * a;
  Eigen::Matrix3<T> frame;
  frame.col(0) << T(1) + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x();
  frame.col(1) << b, sign + normal.y() * normal.y() * a, -normal.y();
  frame.col(2) = normal;
  return frame;
}

}  // namespace sh::prt
