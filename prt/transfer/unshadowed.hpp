// Transfer without shadows in closed form.
//   dot       T_lm = A_l/pi Y_lm(n), where A_l are the clamped-cosine factors [RamamoorthiHanrahan01]
//   operator  the hemisphere above the geometric normal
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// Returns (normals, bands^2) for unit normals, 0 <= degree <= kMaxDegree. The result holds the cosine and 1/pi, not
/// the albedo.
std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals);

/// Returns (vertices, shape.count()), one channel: what a vertex of this shape keeps if nothing blocks its horizon.
std::vector<float> unshadowed_transfer(const TransferShape& shape, const Mesh& mesh);

}  // namespace sh::prt
