// The domains that families share: directions, coefficient vectors, and how their errors are counted.
#pragma once

#include "codegen/family.hpp"

namespace sh::codegen {

/// x, y, z with |d| = 1, and outputs that are basis functions in order (output i is of band floor(sqrt(i))).
Domain direction_domain();

/// `count` random vectors of `size` numbers scaled to length 1, the same in every run: coefficients to test with.
std::vector<std::vector<double>> unit_vectors(int count, int size, unsigned long seed);

/// The Euclidean length.
double length(std::span<const double> vector);

/// `count` exact vectors of `size` small rationals, the same in every run.
std::vector<std::vector<cln::cl_RA>> rational_vectors(int count, int size, unsigned long seed);

}  // namespace sh::codegen
