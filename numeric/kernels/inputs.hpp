// The inputs at which kernels are tried, with names: by the roles of their parameters, and one role at a time.
//
// Deterministic: the same bits on every IEEE machine (see directions.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::numeric {

/// Values for every parameter that is read, by its role: unit directions, rotations, coefficients of length 1 (in
/// place: sums before, half of them zero). `made`: the values of the parameter that another kernel makes. lengths:
/// the least and the largest of vectors. Lists of different lengths are joined in parallel; each starts again at its end.
std::vector<NamedInput> inputs_by_role(const Signature& signature, int degree, const std::array<double, 2>& lengths,
                                       const std::function<std::vector<NamedInput>(int degree)>& made);

/// x, y, z of length 1: axes, near poles, diagonals, equator and `random_count` random ones.
std::vector<NamedInput> direction_inputs(int random_count);

/// `count` vectors of bands^2 coefficients of length 1 in random directions; every second one has the highest band
/// only.
std::vector<NamedInput> coefficient_inputs(int degree, int count, std::uint64_t seed);

/// `count` vectors of `size` numbers of length 1 in random directions.
std::vector<NamedInput> vector_inputs(int size, int count, std::uint64_t seed);

/// 1 - cos of the half-angles of caps: none, tiny ones down to 1e-300, random ones, a hemisphere, all but tiny, the
/// whole sphere.
std::vector<NamedInput> cap_inputs();

/// Unit quaternions (w, x, y, z): identity; quarter, third and half turns; half turns about horizontal and other axes;
/// turns by 1e-300 to 0.1; tilts of z by 1e-300 to pi - 1e-300 between random turns about z; random ones.
std::vector<NamedInput> quaternion_inputs();

/// The same as matrices (3x3, row by row).
std::vector<NamedInput> matrix_inputs();

/// cos, sin of angles: quarter turns, tiny ones, random ones.
std::vector<NamedInput> turn_inputs();

/// first[i] followed by second[i], the shorter list again from its start.
std::vector<NamedInput> combined(const std::vector<NamedInput>& first, const std::vector<NamedInput>& second);

/// out (n) = in (n) / |in|.
template <class Real>
void scale_to_unit(int n, const Real* in, Real* out) {
  using std::sqrt;
  Real sum = 0;
  for (int i = 0; i < n; ++i) sum += in[i] * in[i];
  const Real norm = sqrt(sum);
  for (int i = 0; i < n; ++i) out[i] = in[i] / norm;
}

}  // namespace sh::numeric
