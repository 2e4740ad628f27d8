// Unshadowed transfer (DU) in closed form: T_lm = A_l/pi Y_lm(n), where A_l are the clamped-cosine factors
// [RamamoorthiHanrahan01].
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

/// Returns (normals, bands^2) for unit normals, 0 <= degree <= kMaxDegree. The result holds the cosine and 1/pi, not
/// the albedo.
std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals);

}  // namespace sh::prt
