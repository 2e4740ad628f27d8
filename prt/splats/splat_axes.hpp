// The axes of a file of splats, in the letters of the field: "RDF" is x right, y down, z front.
#pragma once
#include <Eigen/Core>
#include <string>
#include <string_view>

namespace sh::prt {

/// Rows are the file's axes x, y, z in a frame of x right, y up, z back: a signed permutation. Determinant -1: the axes
/// are left-handed. Throws std::invalid_argument unless the three letters name each of right or left, up or down, and
/// front or back once.
Eigen::Matrix3d splat_axes(std::string_view letters);

/// Takes coordinates in the axes `from` to those in the axes `to`.
Eigen::Matrix3d between_axes(std::string_view from, std::string_view to);

}  // namespace sh::prt
