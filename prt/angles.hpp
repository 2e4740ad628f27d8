// The angle between directions.
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

}  // namespace sh::prt
