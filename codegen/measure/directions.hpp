// Fixed sets of directions: exact rational points of the unit sphere, and the floating-point directions on which the
// error of a kernel is measured. The same in every run and on every machine (only + - * / and sqrt are used).
#pragma once

#include <cln/rational.h>

#include <array>
#include <vector>

namespace sh::codegen {

/// Points with rational coordinates and length exactly 1, spread over the sphere.
std::vector<std::array<cln::cl_RA, 3>> rational_directions(int count);

/// Random directions, the axes and poles, and directions near the poles, in double (so of length 1 +- eps).
std::vector<std::array<double, 3>> test_directions();

}  // namespace sh::codegen
