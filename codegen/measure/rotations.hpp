// The rotations at which kernels are checked and measured: exact rationals, the same in every run.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>

#include <vector>

#include "symbolic/rotation/rotation_input.hpp"

namespace sh::codegen {

/// A quaternion with exact components; it may have any length.
using RationalQuaternion = symbolic::Quaternion<cln::cl_RA>;

/// The entries of R(q), row by row, for any q except 0.
std::vector<cln::cl_RA> rotation_entries(const RationalQuaternion& q);

/// Random rotations. One of every three is a half turn about a horizontal axis, where Euler angles are not unique.
std::vector<RationalQuaternion> rational_rotations(int count);

/// The identity, turns about the axes (quarter, half and random ones), and `repeats` times: random rotations, tilts of
/// the z axis by angles from 2^-99 to pi - 2^-99 between random turns about z, and small turns about random axes. The
/// quaternions do not have unit length.
std::vector<RationalQuaternion> test_rotations(int repeats);

/// The rotation matrix nearest to `r` (9 entries), which has to be close to a rotation matrix.
std::vector<cln::cl_F> nearest_rotation(std::vector<cln::cl_F> r);

}  // namespace sh::codegen
