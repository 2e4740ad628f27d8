// What the rotation recipes share: parameters, bands 0 and 1, outputs.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/signed_sum.hpp"

namespace sh::codegen::recipes {

/// Names, domain and outputs of a kernel that turns coefficients c into out by a 3x3 matrix r.
Kernel rotation_kernel(int degree);

struct RotationInputs {
  std::array<NodeId, 9> r{};  ///< the matrix, row-major
  std::vector<NodeId> c;      ///< the coefficients
  [[nodiscard]] std::vector<Signed> band(int l) const;  ///< element l + m
};

RotationInputs rotation_inputs(Builder& build, int degree);

/// The outputs of one band; values: element l + m.
void set_band(Kernel& kernel, Builder& build, int l, const std::vector<Signed>& values);
void copy_band_zero(Kernel& kernel, const RotationInputs& in);
/// Band 1 is (y, z, x): the matrix itself.
void rotate_band_one(Kernel& kernel, Builder& build, const RotationInputs& in);

}  // namespace sh::codegen::recipes
