// Fixed sets of directions: exact rational points of the unit sphere, and the floating-point directions at which the
// error of a kernel is measured. They are the same in every run and on every machine, because they use only + - * / and
// sqrt.
#pragma once

#include <cln/rational.h>

#include <array>
#include <vector>

namespace sh::codegen {

/// Points with rational coordinates and length exactly 1, spread over the sphere.
std::vector<std::array<cln::cl_RA, 3>> rational_directions(int count);

/// Random directions, the axes and poles, and directions near the poles. Their length is 1 +- eps of double.
std::vector<std::array<double, 3>> test_directions();

}  // namespace sh::codegen
