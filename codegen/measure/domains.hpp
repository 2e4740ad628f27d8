// The domains that families share: directions, coefficient vectors, and how their errors are counted.
#pragma once

#include <array>

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// x, y, z with |d| = 1, and outputs that are basis functions in order (output i is of band floor(sqrt(i))).
Domain direction_domain();

/// `count` random vectors of `size` numbers scaled to length 1, the same in every run: coefficients to test with.
std::vector<std::vector<double>> unit_vectors(int count, int size, unsigned long seed);

/// The Euclidean length.
double length(std::span<const double> vector);

/// Some `count` of the test directions, the axes and poles and their neighbourhood among them.
std::vector<std::array<double, 3>> some_test_directions(std::size_t count);

/// `count` values of 1 - cos(half-angle) in (0, 2): a third near 0, a third near 2, the same in every run.
std::vector<double> cap_sizes(int count, unsigned long seed);

/// What the zonal coefficient of degree l of a cap is measured by: |z_0| at l = 0, sqrt((2l+1) pi) (1 - cos^2) / 2
/// above.
double cap_size(double one_minus_cos, std::size_t l);

/// `count` exact vectors of `size` small rationals, the same in every run.
std::vector<std::vector<cln::cl_RA>> rational_vectors(int count, int size, unsigned long seed);

}  // namespace sh::codegen
