// The rotations that kernels are checked and measured at: exact rationals, the same in every run.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>

#include <vector>

#include "symbolic/rotation/rotation_input.hpp"

namespace sh::codegen {

using RationalQuaternion = symbolic::Quaternion<cln::cl_RA>;

/// R(q) for any q but 0, entries row by row.
std::vector<cln::cl_RA> rotation_entries(const RationalQuaternion& q);

/// Random rotations, and among every three a half turn about a horizontal axis, where Euler angles are not unique.
std::vector<RationalQuaternion> rational_rotations(int count);

/// Identity, turns about the axes (quarter, half and random ones), and `repeats` times: random rotations, tilts of the
/// z axis by angles from 2^-99 to pi - 2^-99 between random turns about z, small turns about random axes. Not of unit
/// length.
std::vector<RationalQuaternion> test_rotations(int repeats);

/// The rotation matrix nearest to a matrix (9 entries) that is nearly one.
std::vector<cln::cl_F> nearest_rotation(std::vector<cln::cl_F> r);

}  // namespace sh::codegen
