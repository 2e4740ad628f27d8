// The exact references and the test inputs of the rotation families.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// The number of entries of a rotation matrix.
inline constexpr std::size_t kMatrixSize = 9;

/// The exact outputs of each family at `count` points.
Reference rotate_reference(int degree, int count);
Reference rotate_quaternion_reference(int degree, int count);
Reference rotate_z_reference(int degree, int count);
Reference rotate_build_reference(int degree, int count);
Reference rotate_apply_reference(int degree, int count);
Reference rotate_evaluate_reference(int degree, int count);

/// The inputs of each family at which its errors are measured.
std::vector<std::vector<double>> rotate_inputs(int degree);
std::vector<std::vector<double>> rotate_quaternion_inputs(int degree);
std::vector<std::vector<double>> rotate_z_inputs(int degree);
std::vector<std::vector<double>> rotate_build_inputs(int degree);
std::vector<std::vector<double>> rotate_apply_inputs(int degree);
std::vector<std::vector<double>> rotate_evaluate_inputs(int degree);

}  // namespace sh::codegen
