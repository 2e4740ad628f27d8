// The lobes of a tabulated BRDF in the world: functions of the direction of light that a vertex sums its incident radiance
// with.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "prt/angles.hpp"
#include "prt/basis.hpp"
#include "prt/material/reflectance.hpp"

namespace sh::prt {

/// The rotation from the frame of a surface to the world. `normal` and `to_eye` are unit. Where the eye stands
/// over the surface in the direction of its normal, any rotation about the normal serves.
inline Eigen::Matrix3f surface_frame(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye) {
  constexpr float kLeastSine = 1e-6F;
  Eigen::Vector3f x = to_eye - normal.dot(to_eye) * normal;
  x = x.norm() > kLeastSine ? (x.normalized() - normal.dot(x.normalized()) * normal).normalized().eval()
                            : normal.unitOrthogonal();
  const Eigen::Vector3f y = normal.cross(x);
  Eigen::Matrix3f frame;
  frame << x, y, normal;
  return frame;
}

/// Calls visit(color, weights) for every part of a table, on a surface with this albedo, that is not black; weights
/// (bands^2) times the incident radiance is what this part sends to the eye.
template <class Visit>
void for_reflected_lobes(const BrdfTable& table, const Eigen::Vector3f& albedo, int degree,
                         const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye, const Visit& visit) {
  const std::array<Eigen::Vector3f, kReflectionParts> colors = colors_of_parts(table.is_measured, albedo);
  std::array<float, kReflectionParts * even_count(kMaxDegree)> even;
  reflectance_at(table.rows, degree, angle_between(normal, to_eye), even.data());
  const Eigen::Matrix3f frame = surface_frame(normal, to_eye);
  std::array<float, coefficient_count(kMaxDegree)> weights;
  for (std::size_t part = 0; part < kReflectionParts; ++part) {
    if (colors[part].isZero(0.0F)) continue;
    weights.fill(0.0F);
    const float* from = even.data() + part * even_count(degree);
    for (int l = 0; l <= degree; ++l) band(weights.data(), l).tail(l + 1) = even_band(from, l);
    rotate_function(degree, frame, weights.data(), weights.data());
    visit(colors[part], weights.data());
  }
}

}  // namespace sh::prt
