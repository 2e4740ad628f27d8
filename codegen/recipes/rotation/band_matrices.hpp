// Computes the band matrices D_l(R) entry by entry, in two ways that need neither a square root nor a division.
//
// `dense`: with the complex numbers A = ((r00 + r11) + i (r10 - r01)) / 2 = cos^2(b/2) e^(i(a+g)),
// B = ((r11 - r00) - i (r01 + r10)) / 2 = sin^2(b/2) e^(i(a-g)), P = r02 + i r12 = sin b e^(ia) and
// Q = -r20 + i r21 = sin b e^(ig), rows +-m and columns +-n, m >= n > 0, have the entries
//     (m, n) Re z + Re w    (m, -n) Im w - Im z    (-m, n) Im z + Im w    (-m, -n) Re z - Re w
// with z = p+(r22) P^(m-n) A^n and w = p-(r22) P^(m-n) B^n, where p+- are Jacobi polynomials of degree l - m. Above the
// diagonal, Q replaces P. The formulas follow from Wigner's formula, [Wigner59] eq. 15.27.
// `recursive`: [IvanicRuedenberg96+98] in the form of symbolic/rotation/rotation_recursion.hpp.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/signed_builder.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {

/// Element l is D_l, (2l+1, 2l+1), l = 0 .. degree.
using BandMatrices = std::vector<symbolic::Matrix<Value>>;

/// D_1, which is R with its axes in the order y, z, x.
symbolic::Matrix<Value> band_one(const std::array<NodeId, 9>& r);

/// Bands 0 .. degree in the way `dense`.
BandMatrices dense_bands(SignedBuilder& build, const std::array<NodeId, 9>& r, int degree);

/// The nodes of a complex number.
struct Complex {
  Value re;
  Value im;
};

/// The numbers of `dense`: cos b and the complex numbers 2A, 2B, P, Q.
struct RotationNumbers {
  NodeId cosine = -1;
  Complex a;
  Complex b;
  Complex p;
  Complex q;
};

/// Appends bands 2 .. degree in the way `dense` to bands 0 and 1.
void append_dense_bands(SignedBuilder& build, BandMatrices& bands, const RotationNumbers& numbers, int degree);
/// Bands 0 .. degree in the way `recursive`.
BandMatrices recursive_bands(SignedBuilder& build, const std::array<NodeId, 9>& r, int degree);

}  // namespace sh::codegen::recipes
