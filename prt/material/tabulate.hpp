// What fills tables of reflectance: sums over directions of light, in the frame of the surface.
#pragma once
#include <Eigen/Core>

#include "prt/material/reflectance.hpp"

namespace sh::prt {

/// The unit direction of a view, y = 0. The last stands a little above the surface: at grazing view itself, facets without
/// roughness have no limit.
Eigen::Vector3d view_direction(int view);

/// The direction of light that a half vector mirrors to the eye.
inline Eigen::Vector3d mirrored_at(const Eigen::Vector3d& half, const Eigen::Vector3d& eye) {
  return 2.0 * eye.dot(half) * half - eye;
}

/// The coefficients of a view: sums over directions of light.
class ReflectanceRow {
 public:
  /// Adds `values`, one for each part, at a unit direction.
  void add(const Eigen::Vector3d& light, const Eigen::Vector3d& values);
  /// Adds another sum, whose parts `mix` turns into parts of this one.
  void add(const Eigen::Matrix3d& mix, const ReflectanceRow& other);
  void write(int view, ReflectanceTable& table) const;

 private:
  using Sums = Eigen::Matrix<double, kReflectionParts, even_count(kMaxDegree)>;
  Sums sums_ = Sums::Zero();
};

}  // namespace sh::prt
