// Rotation matrices as users would send them, in memory: from the definition Y'(R^-1 s) = D^T Y'(s) by least squares
// over directions, which knows no formula of D; and with the digits lost that careless code loses.
#pragma once

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "numeric/identify/rotation_check.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/sampling/directions.hpp"

namespace sh::numeric::identify {

using Matrix3 = std::array<double, 9>;

inline RotationCase make_case(int line, const Matrix3& r) {
  RotationCase one;
  one.line = line;
  for (std::size_t i = 0; i < 9; ++i) one.r[i] = r[i];
  return one;
}

// General rotations, and tilts of the polar axis down to 1e-5.
inline std::vector<Matrix3> test_rotations() {
  std::vector<Matrix3> all = {tilted_turn<double>(0.4, 1.1, -0.9), tilted_turn<double>(2.5, 0.7, 1.3),
                              tilted_turn<double>(-1.2, 2.2, 0.3), tilted_turn<double>(0.9, 1.6, 2.9),
                              tilted_turn<double>(0, 0, 0)};
  for (const double tilt : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    all.push_back(tilted_turn<double>(0.3, tilt, 0.8));
    all.push_back(tilted_turn<double>(-2, tilt, 2.1));
  }
  return all;
}

// The convention's matrix, degree l, rows and columns in the convention's order.
inline std::vector<std::complex<double>> band_by_definition(const Convention& c, int l, const Matrix3& r) {
  const auto directions = random_directions(4 * l + 6, 9);
  const Eigen::Index width = 2 * l + 1;
  Eigen::MatrixXcd here(static_cast<Eigen::Index>(directions.size()), width), before = here;
  for (Eigen::Index k = 0; k < here.rows(); ++k) {
    const auto& [x, y, z] = directions[k];
    const std::array<double, 3> back = {r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z,
                                        r[2] * x + r[5] * y + r[8] * z};
    const auto at_s = convention_values(c, l, {x, y, z});
    const auto at_back = convention_values(c, l, back);
    for (Eigen::Index i = 0; i < width; ++i) {
      here(k, i) = at_s[l * l + i];
      before(k, i) = at_back[l * l + i];
    }
  }
  const Eigen::MatrixXcd d = here.householderQr().solve(before);
  std::vector<std::complex<double>> band;
  for (Eigen::Index i = 0; i < width; ++i) {
    for (Eigen::Index k = 0; k < width; ++k) band.push_back(d(i, k));
  }
  return band;
}

inline RotationCases make_rotations(const Convention& convention, int degree) {
  RotationCases cases{"rotations.csv", degree, convention.complex, {}};
  for (const Matrix3& r : test_rotations()) {
    cases.cases.push_back(make_case(static_cast<int>(cases.cases.size()) + 2, r));
    for (int l = 0; l <= degree; ++l) cases.cases.back().bands.push_back(band_by_definition(convention, l, r));
  }
  return cases;
}

// The float matrix of Rz Ry Rz whose sine of the tilt is taken from its cosine, as DirectXMath does: still a rotation.
inline std::array<float, 9> careless_rotation(const Matrix3& exact) {
  std::array<float, 9> r{};
  for (std::size_t i = 0; i < 9; ++i) r[i] = static_cast<float>(exact[i]);
  const float cb = r[8];
  const float sb = std::sqrt(std::max(0.0F, 1 - cb * cb));
  const bool upright = r[2] == 0 && r[5] == 0;
  const float a = upright ? 0 : std::atan2(r[5], r[2]);
  const float c = upright ? std::atan2(r[3], r[0]) : std::atan2(r[7], -r[6]);
  const float ca = std::cos(a), sa = std::sin(a), cc = std::cos(c), sc = std::sin(c);
  return tilted_turn(ca, sa, cb, sb, cc, sc);
}

// Matrices in float by a sound recursion, of the rotation itself or of the careless one.
inline RotationCases make_float_rotations(int degree, bool careless) {
  RotationCases cases{"rotations.csv", degree, false, {}};
  for (const Matrix3& r : test_rotations()) {
    cases.cases.push_back(make_case(static_cast<int>(cases.cases.size()) + 2, r));
    std::array<float, 9> single{};
    for (std::size_t i = 0; i < 9; ++i) single[i] = static_cast<float>(r[i]);
    if (careless) single = careless_rotation(r);
    for (const auto& band : rotation_bands<float>(degree, single.data())) {
      cases.cases.back().bands.emplace_back(band.begin(), band.end());
    }
  }
  return cases;
}

}  // namespace sh::numeric::identify
