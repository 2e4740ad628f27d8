// The sets of directions on which kernels are compared with the oracle.
//
// Output: directions in double, of length 1 up to double rounding. Deterministic: only + - * / and sqrt are used, so
// the bits are the same on every IEEE machine. A kernel's input is the direction rounded to the kernel's type (float
// turns the nearest near-poles into subnormal numbers and then into the pole itself, as it should).
#pragma once

#include <cstdint>
#include <vector>

namespace sh::numeric {

struct Direction {
  double x, y, z;
};

/// `count` directions uniform on the sphere (Marsaglia 1972, Ann. Math. Stat. 43, 645), the same for the same seed.
std::vector<Direction> random_directions(int count, std::uint64_t seed);

/// The six axes, +z and -z (the poles) first.
std::vector<Direction> axis_directions();

/// At sines of the polar angle from 1e-1 down to 1e-300, beside both poles, at several azimuths.
std::vector<Direction> near_pole_directions();

/// The 12 edge midpoints and the 8 corners of the cube: equal components up to sign.
std::vector<Direction> diagonal_directions();

/// z = 0 and |z| tiny, at azimuths on and off the axes.
std::vector<Direction> equator_directions();

/// All of the above, with `random_count` random directions (seed 1).
std::vector<Direction> standard_directions(int random_count);

}  // namespace sh::numeric
