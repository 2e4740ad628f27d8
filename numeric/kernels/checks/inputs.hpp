// The inputs at which kernels are tried, with names, and what checks share: rounded inputs back to their domain, sizes.
//
// Deterministic: the same bits on every IEEE machine (see directions.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "numeric/kernels/checks/family_check.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric {

// x, y, z of length 1: axes, near poles, diagonals, equator and `random_count` random ones.
std::vector<NamedInput> direction_inputs(int random_count);

// `count` vectors of bands^2 coefficients of length 1 in random directions; every second one has the highest band only.
std::vector<NamedInput> coefficient_inputs(int degree, int count, std::uint64_t seed);

// `count` vectors of `size` numbers of length 1 in random directions.
std::vector<NamedInput> vector_inputs(int size, int count, std::uint64_t seed);

// 1 - cos of the half-angles of caps: none, tiny ones down to 1e-300, random ones, a hemisphere, all but tiny, the
// whole sphere.
std::vector<NamedInput> cap_inputs();

// first[i] followed by second[i], the shorter list again from its start.
std::vector<NamedInput> combined(const std::vector<NamedInput>& first, const std::vector<NamedInput>& second);

// sqrt(sum v[i]^2)
double length(const double* v, int count);

// The degree l of the coefficient with index l(l+1)+m.
inline int degree_of(std::size_t index) { return static_cast<int>(std::sqrt(static_cast<double>(index))); }

// A nearest point of the domain (see FamilyCheck): all inputs as they are, but the direction at `at`, three numbers,
// scaled to length 1. `at` and the number of inputs are functions of the degree.
template <class At, class Count>
RealFunction with_unit_direction(At at, Count count) {
  return [at, count](int degree, const auto* in, auto* out) {
    std::copy_n(in, count(degree), out);
    const auto* const d = in + at(degree);
    const auto unit = normalised(d[0], d[1], d[2]);
    std::copy(unit.begin(), unit.end(), out + at(degree));
  };
}

}  // namespace sh::numeric
