// Rotations to try kernels at, by name.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "numeric/kernels/checks/family_check.hpp"

namespace sh::numeric {

// Unit quaternions (w, x, y, z): identity; quarter, third and half turns; half turns about horizontal and other axes;
// turns by 1e-300 to 0.1; tilts of z by 1e-300 to pi - 1e-300 between random turns about z; random ones.
std::vector<NamedInput> quaternion_inputs();

// The same as matrices (3x3, row by row).
std::vector<NamedInput> matrix_inputs();

// cos, sin of angles: multiples of 15 degrees, tiny ones, random ones.
std::vector<NamedInput> turn_inputs();

// out (n) = in (n) / |in|.
template <class Real>
void scale_to_unit(std::size_t n, const Real* in, Real* out) {
  using std::sqrt;
  Real sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += in[i] * in[i];
  const Real norm = sqrt(sum);
  for (std::size_t i = 0; i < n; ++i) out[i] = in[i] / norm;
}

}  // namespace sh::numeric
