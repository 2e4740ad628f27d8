// Parts that the rotation recipes share: parameters, bands 0 and 1, and outputs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "codegen/recipes/signed_sum.hpp"

namespace sh::codegen::recipes {

/// The text for the domain of kernels that take a rotation matrix.
inline constexpr const char* kRotationDomain = "r, row by row, is a rotation: r r^T = 1, det r = 1";

/// "degree 0 to 4"
std::string degrees_to(int degree);

/// A kernel without nodes that rotates coefficients c to out by a 3x3 matrix r: its texts, parameters and results.
Kernel rotation_kernel(int degree);

/// The same with a unit quaternion q (4 inputs) in place of r (9 inputs).
Kernel quaternion_kernel(int degree);
/// The inputs 0 to 3.
std::array<NodeId, 4> quaternion_inputs(Builder& build);

/// The inputs of a rotation by a matrix.
struct RotationInputs {
  std::array<NodeId, 9> r{};                            ///< the matrix, row-major
  std::vector<NodeId> c;                                ///< the coefficients
  [[nodiscard]] std::vector<Signed> band(int l) const;  ///< element l + m
};

/// The inputs 0 to 8.
std::array<NodeId, 9> matrix_inputs(Builder& build);
/// The coefficients: the inputs from `first` on.
std::vector<NodeId> coefficient_inputs(Builder& build, int first, int degree);
/// The matrix and then the coefficients.
RotationInputs rotation_inputs(Builder& build, int degree);

/// Sets the outputs of one band. values: element l + m.
void set_band(Kernel& kernel, Builder& build, int l, const std::vector<Signed>& values);
/// Sets the output of band 0, which a rotation does not change.
void copy_band_zero(Kernel& kernel, const RotationInputs& in);
/// Sets the outputs of band 1. Its functions are (y, z, x), so the rotation matrix acts on them directly.
void rotate_band_one(Kernel& kernel, Builder& build, const RotationInputs& in);

}  // namespace sh::codegen::recipes
