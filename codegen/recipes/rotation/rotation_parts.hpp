// Parts that the rotation recipes share: parameters, bands 0 and 1, and outputs.
#pragma once

#include <array>

#include "codegen/recipes/parts.hpp"
#include "codegen/recipes/signed_builder.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {

/// The text for the domain of kernels that take a rotation matrix.
inline constexpr const char* kRotationDomain = "r, row by row, is a rotation: r r^T = 1, det r = 1";

/// A kernel without nodes that rotates coefficients c to out by a 3x3 matrix r: its texts, parameters and results.
Kernel rotation_kernel(int degree);

/// The same with a unit quaternion q (4 inputs) in place of r (9 inputs).
Kernel quaternion_kernel(int degree);
/// The inputs 0 to 3.
std::array<NodeId, 4> quaternion_inputs(Builder& build);

/// The inputs 0 to 8: the matrix, row-major.
std::array<NodeId, 9> matrix_inputs(Builder& build);
/// The coefficients of bands 0 .. degree: the inputs from `first` on.
std::vector<NodeId> coefficient_inputs(Builder& build, int first, int degree);

/// One band of the coefficients, element l + m.
std::vector<Value> band_of(const std::vector<NodeId>& c, int l);
/// A matrix of constants or of values times a vector.
template <class Entry>
std::vector<Value> times(SignedBuilder& build, const symbolic::Matrix<Entry>& matrix, const std::vector<Value>& v) {
  std::vector<Value> result;
  for (int i = 0; i < matrix.rows(); ++i) {
    std::vector<Value> terms;
    for (int j = 0; j < matrix.columns(); ++j) terms.push_back(build.times(matrix(i, j), v[j]));
    result.push_back(build.sum(terms));
  }
  return result;
}
/// Sets the outputs of one band. values: element l + m.
void set_band(Kernel& kernel, SignedBuilder& build, int l, const std::vector<Value>& values);

}  // namespace sh::codegen::recipes
