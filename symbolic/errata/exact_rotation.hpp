// Rotations at which recursions are run exactly: rational matrices with rational half angles, and their band matrices
// by routes that have nothing to do with a recursion over the bands.
#pragma once

#include <cln/rational.h>

#include <array>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {

inline constexpr int kHighestBand = 6;

/// R = Rz(alpha) Ry(beta) Rz(gamma).
struct ExactRotation {
  std::array<CosSin<cln::cl_RA>, 3> half_angles;  ///< of alpha, beta, gamma
  Matrix<cln::cl_RA> matrix;                      ///< (3, 3), acts on columns x, y, z
  std::vector<Matrix<RadicalSum>> real;           ///< D_l(R), c' = D c, from quaternion_rotation, l <= kHighestBand
  std::vector<Matrix<RadicalSum>> complex;        ///< exp(-i m alpha) d_mn(beta) exp(-i n gamma) from wigner_d
};

/// Two rotations without any special angle.
const std::vector<ExactRotation>& sample_rotations();

/// cos and sin of the whole angle.
CosSin<cln::cl_RA> doubled(const CosSin<cln::cl_RA>& half);

/// (cosine + i sine)^power, of either sign.
RadicalSum unit_power(const CosSin<cln::cl_RA>& angle, int power);

/// d^l_(row,column) at the half angle (cosine, sine).
RadicalSum wigner_value(int degree, int row, int column, const CosSin<cln::cl_RA>& half);

/// The entry of row m, column n, both from -l to l; zero outside.
template <class T>
T entry_or_zero(const Matrix<T>& band, int m, int n) {
  const int l = band.rows() / 2;
  return m < -l || m > l || n < -l || n > l ? T() : band(l + m, l + n);
}

/// Each entry conjugated.
Matrix<RadicalSum> conjugate(const Matrix<RadicalSum>& m);

/// Re and Im of each entry.
Matrix<RadicalSum> real_part(const Matrix<RadicalSum>& m);
Matrix<RadicalSum> imaginary_part(const Matrix<RadicalSum>& m);

}  // namespace sh::symbolic::errata
