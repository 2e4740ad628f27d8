// Zonal functions about a direction, by generated kernels whose degree is chosen at run time.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "generated/cpp/zonal.hpp"
#include "prt/basis.hpp"

namespace sh::prt {

/// The factor of Y_l0 in a zonal function whose factor of all Y_lm is 1.
inline double zonal_unit(int l) { return std::sqrt((2.0 * l + 1.0) / (4.0 * std::numbers::pi)); }

/// out (bands^2) = factor(l) Y_lm(direction): the lobe with these factors about a unit direction.
template <class T, class Factor>
void zonal_about(int degree, const Eigen::Vector3<T>& direction, const Factor& factor, T* out) {
  std::array<T, kMaxDegree + 1> zonal;
  for (int l = 0; l <= degree; ++l) zonal[l] = static_cast<T>(zonal_unit(l) * static_cast<double>(factor(l)));
  at_degree(degree,
            [&](auto known) { sh::zonal<known()>(zonal.data(), direction.x(), direction.y(), direction.z(), out); });
}

}  // namespace sh::prt
