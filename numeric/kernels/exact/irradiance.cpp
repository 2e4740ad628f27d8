// Irradiance in its forms: irradiance (c in place), irradiance_matrix, irradiance_evaluate, lightmap, lightmap_project,
// lightmap_evaluate. Against E(n) = sum A_l c_lm Y_lm(n) by the oracle's basis and clamped cosine.
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
