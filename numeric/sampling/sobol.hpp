// Points of low discrepancy in the unit square, scrambled by a seed.
//
// Output: the first `count` points of the two-dimensional Sobol' sequence [Sobol67], which is a (0,2)-sequence in base
// 2: any 2^k of them from a multiple of 2^k on lie one each in every grid of 2^k equal boxes. Nested uniform scrambling
// [Owen95] of all 32 bits keeps that, makes every point uniform in (0, 1)^2 and every average over a square unbiased;
// for smooth integrands the rms error falls as count^-3/2. The same points for the same arguments on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sh::numeric {

// (count) points; throws std::invalid_argument for count < 0.
std::vector<std::array<double, 2>> sobol_points(int count, std::uint64_t seed);

}  // namespace sh::numeric
