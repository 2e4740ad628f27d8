// The inputs at which kernels are tried, with names, and what checks share: rounded inputs back to their domain, sizes.
//
// Deterministic: the same bits on every IEEE machine (see directions.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "numeric/basis.hpp"
#include "numeric/checks/family_check.hpp"

namespace sh::numeric {

// x, y, z of length 1: axes, near poles, diagonals, equator and `random_count` random ones.
std::vector<NamedInput> direction_inputs(int random_count);

// The degree l of the coefficient with index l(l+1)+m.
inline int degree_of(std::size_t index) { return static_cast<int>(std::sqrt(static_cast<double>(index))); }

// out (3) = in (3) scaled to length 1.
template <class Real>
void scale_to_unit(const Real* in, Real* out) {
  const auto unit = normalised(in[0], in[1], in[2]);
  for (std::size_t i = 0; i < 3; ++i) out[i] = unit[i];
}

}  // namespace sh::numeric
