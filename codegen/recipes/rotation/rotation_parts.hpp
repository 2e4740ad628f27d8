// Parts that the rotation recipes share: parameters, bands 0 and 1, outputs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "codegen/recipes/signed_sum.hpp"

namespace sh::codegen::recipes {

inline constexpr const char* kRotationDomain = "r, row by row, is a rotation: r r^T = 1, det r = 1";

/// "degree 0 to 4"
std::string degrees_to(int degree);

/// Names, domain and outputs of a kernel that turns coefficients c into out by a 3x3 matrix r.
Kernel rotation_kernel(int degree);

/// The same with a unit quaternion q in the place of r, 4 inputs in the place of 9.
Kernel quaternion_kernel(int degree);
std::array<NodeId, 4> quaternion_inputs(Builder& build);

struct RotationInputs {
  std::array<NodeId, 9> r{};                            ///< the matrix, row-major
  std::vector<NodeId> c;                                ///< the coefficients
  [[nodiscard]] std::vector<Signed> band(int l) const;  ///< element l + m
};

/// The inputs 0 to 8.
std::array<NodeId, 9> matrix_inputs(Builder& build);
/// Inputs from `first` on.
std::vector<NodeId> coefficient_inputs(Builder& build, int first, int degree);
RotationInputs rotation_inputs(Builder& build, int degree);

/// The outputs of one band; values: element l + m.
void set_band(Kernel& kernel, Builder& build, int l, const std::vector<Signed>& values);
void copy_band_zero(Kernel& kernel, const RotationInputs& in);
/// Band 1 is (y, z, x): the matrix itself.
void rotate_band_one(Kernel& kernel, Builder& build, const RotationInputs& in);

}  // namespace sh::codegen::recipes
