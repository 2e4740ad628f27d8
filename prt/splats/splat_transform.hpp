// Moves, turns, scales and cuts splats: positions, rotations, scales and SH coefficients together.
//
// With the orthogonal matrix M, the factor s and the vector t a splat at p becomes the splat at s M p + t of covariance
// s^2 M C M^T, whose color towards M d is that of the old one towards d.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "prt/splats/splats.hpp"

namespace sh::prt {

struct Similarity {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // orthogonal; determinant -1: mirrors, as a change of axes may
  double scale = 1.0;                                  // positive
  Eigen::Vector3d move = Eigen::Vector3d::Zero();

  /// First `first`, then this one.
  [[nodiscard]] Similarity after(const Similarity& first) const;
  [[nodiscard]] Eigen::Vector3d apply(const Eigen::Vector3d& point) const { return scale * (turn * point) + move; }
  [[nodiscard]] SplatParts changes() const;
  [[nodiscard]] bool is_identity() const { return turn.isIdentity(0.0) && scale == 1.0 && move.isZero(0.0); }
};

/// A rotation matrix that may be rounded: the nearest rotation. Throws std::invalid_argument with one line, which
/// begins with `name`, for a reflection and for a matrix that is further than 1e-3 from every rotation.
Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& matrix, const char* name);

/// Transforms all splats of the block. Coefficients of band l turn by the generated rotation kernels; where M only
/// flips axes they only change signs, exactly.
void transform(const Similarity& similarity, SplatBlock& block);

/// The same for splats whose coefficients are not needed.
void transform_positions(const Similarity& similarity, SplatBlock& block);

/// Leaves out the splats whose positions are outside the closed box, once they are placed.
void crop(const Eigen::AlignedBox3d& box, const Similarity& placement, SplatBlock& block);

/// Coefficients of another degree: the higher bands are cut off, or are zeros.
void change_degree(int degree, SplatBlock& block);

}  // namespace sh::prt
