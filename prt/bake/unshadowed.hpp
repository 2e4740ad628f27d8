// Unshadowed transfer (DU), in closed form: T_lm = A_l/pi Y_lm(n), A_l the clamped-cosine factors
// [RamamoorthiHanrahan01].
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

/// (normals, bands^2) for unit normals, 0 <= degree <= kMaxDegree; cosine and 1/pi, not the albedo.
std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals);

}  // namespace sh::prt
