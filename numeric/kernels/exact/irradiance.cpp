// Irradiance in its forms: irradiance (c in place), irradiance_matrix, irradiance_evaluate, irradiance_zh3, lightmap,
// lightmap_project, lightmap_evaluate. Against E(n) = sum A_l c_lm Y_lm(n) by the oracle's basis and clamped cosine.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric {
namespace {

// E(n) = sum A_l c_lm Y_lm(n), |n| = 1.
template <class Real>
Real irradiance_at(int degree, const Real* c, const Real& x, const Real& y, const Real& z) {
  Real sum = 0;
  const std::vector<Real> values = basis(degree, x, y, z);
  auto value = values.begin();
  for (int l = 0; l <= degree; ++l) {
    const Real factor = clamped_cosine_factor<Real>(l);
    for (int m = -l; m <= l; ++m) sum += factor * *c++ * *value++;
  }
  return sum;
}

// E is this matrix between (x, y, z, 1); x^2 + y^2 + z^2 = 1 leaves one entry free, settled by m_xx + m_yy = 0 as in
// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001, equation 12.
// Found from values of E alone: its odd and even parts along the axes and along the diagonals between them.
template <class Real>
void quadratic_form(const Real* c, Real* m) {
  using std::sqrt;
  constexpr std::size_t kOne = 3;
  const auto at = [&](const std::array<Real, 3>& n) { return irradiance_at(2, c, n[0], n[1], n[2]); };
  const auto set = [&](std::size_t i, std::size_t k, const Real& value) { m[4 * i + k] = m[4 * k + i] = value; };
  std::array<Real, 3> even;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Real, 3> axis = {0, 0, 0};
    axis[i] = 1;
    const Real ahead = at(axis);
    axis[i] = -1;
    const Real behind = at(axis);
    even[i] = (ahead + behind) / 2;
    set(i, kOne, (ahead - behind) / 4);
  }
  const Real one = (even[0] + even[1]) / 2;
  set(kOne, kOne, one);
  const Real half_root = sqrt(Real(0.5));
  for (std::size_t i = 0; i < 3; ++i) {
    set(i, i, even[i] - one);
    const std::size_t k = (i + 1) % 3;
    std::array<Real, 3> n = {0, 0, 0};
    n[i] = n[k] = half_root;
    const Real along = at(n) + at({-n[0], -n[1], -n[2]});
    n[k] = -half_root;
    const Real across = at(n) + at({-n[0], -n[1], -n[2]});
    set(i, k, (along - across) / 4);
  }
}

// E(n) = e0 + e1 y + e2 z + e3 x
template <class Real>
void linear_form(const Real* c, Real* e) {
  const auto difference = [&](const Real& x, const Real& y, const Real& z) -> Real {
    return (irradiance_at(1, c, x, y, z) - irradiance_at(1, c, Real(-x), Real(-y), Real(-z))) / 2;
  };
  const std::array<Real, 4> all = {irradiance_at(0, c, Real(0), Real(0), Real(1)), difference(0, 1, 0),
                                   difference(0, 0, 1), difference(1, 0, 0)};
  std::copy(all.begin(), all.end(), e);
}

// E of bands 0 and 1 and of a zonal band 2 about the axis of band 1, by a fit [RoughtonSloan24]; of three channels about
// the axis of luminance.
template <class Real>
void with_suggested_band(std::size_t channels, const Real* c, Real* out) {
  using std::abs;
  using std::sqrt;
  const Real* const n = c + 4 * channels;
  const std::array<Real, 3> weights = {Real(2126) / 10000, Real(7152) / 10000, Real(722) / 10000};
  std::array<Real, 3> axis = {0, 0, 0};  // x, y, z
  for (std::size_t k = 0; k < channels; ++k) {
    const Real weight = channels == 1 ? Real(1) : weights[k];
    for (std::size_t i = 0; i < 3; ++i) axis[i] += weight * c[4 * k + (i == 0 ? 3 : i)];
  }
  const Real length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  for (Real& component : axis) component = length > 0 ? Real(component / length) : Real(0);
  const Real cosine = axis[0] * n[0] + axis[1] * n[1] + axis[2] * n[2];
  // Y_20 at this angle from the pole.
  const Real y20 = basis(2, Real(sqrt(1 - cosine * cosine)), Real(0), cosine)[6];
  const Real most = sqrt(Real(3));
  for (std::size_t k = 0; k < channels; ++k) {
    const Real size = abs(axis[0] * c[4 * k + 3] + axis[1] * c[4 * k + 1] + axis[2] * c[4 * k + 2]);
    const Real quotient = size < most * c[4 * k] ? Real(size / c[4 * k]) : most;
    out[k] = irradiance_at(1, c + 4 * k, n[0], n[1], n[2]) +
             clamped_cosine_factor<Real>(2) * size * (Real(8) / 100 + Real(6) / 10 * quotient) * y20;
  }
}

}  // namespace

std::vector<ExactFamily> exact_irradiance() {
  return {{"irradiance",
           [](int degree, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             for (int l = 0; l <= degree; ++l) {
               const Real factor = clamped_cosine_factor<Real>(l);
               for (int m = -l; m <= l; ++m) *out++ = factor * *in++;
             }
           }},
          {"irradiance_matrix", [](int /*degree*/, const auto* in, auto* out) { quadratic_form(in, out); }},
          {"irradiance_evaluate",
           [](int degree, const auto* in, auto* out) {
             const auto* const n = in + coefficient_count(degree);
             *out = irradiance_at(degree, in, n[0], n[1], n[2]);
           }},
          {"irradiance_zh3", [](int /*degree*/, const auto* in, auto* out) { with_suggested_band(1, in, out); }},
          {"irradiance_zh3_rgb", [](int /*degree*/, const auto* in, auto* out) { with_suggested_band(3, in, out); }},
          {"lightmap", [](int /*degree*/, const auto* in, auto* out) { linear_form(in, out); }},
          {"lightmap_project",
           [](int /*degree*/, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             std::array<Real, 4> c;
             basis(1, in[0], in[1], in[2], c.data());
             for (Real& value : c) value *= in[3];
             linear_form(c.data(), out);
             for (std::size_t i = 0; i < 4; ++i) out[i] += in[4 + i];
           }},
          {"lightmap_evaluate", [](int /*degree*/, const auto* in, auto* out) {
             *out = in[0] + in[1] * in[5] + in[2] * in[6] + in[3] * in[4];
           }}};
}

}  // namespace sh::numeric
