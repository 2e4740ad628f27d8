// Irradiance in its forms: irradiance (c in place), irradiance_matrix, irradiance_evaluate, lightmap, lightmap_project,
// lightmap_evaluate. Against E(n) = sum A_l c_lm Y_lm(n) by numeric's basis and clamped cosine.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/kernels/checks/zonal_oracle.hpp"

namespace sh::numeric {
namespace {

constexpr int kVectors = 200;
constexpr int kRandomDirections = 100;

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

double length_of_coefficients(int degree, const double* in, std::size_t /*output*/) {
  return length(in, coefficient_count(degree));
}

Signature coefficients_and_normal(int degree) {
  return {{in_array("c", coefficient_count(degree)), scalar("x"), scalar("y"), scalar("z")}, true};
}

std::vector<NamedInput> vectors_and_normals(int degree) {
  return combined(coefficient_inputs(degree, 61, 85), direction_inputs(kRandomDirections));
}

RealFunction with_unit_normal() {
  return with_unit_direction(coefficient_count, [](int degree) { return coefficient_count(degree) + 3; });
}

std::vector<NamedInput> vectors(int degree) { return coefficient_inputs(degree, kVectors, 81); }

}  // namespace

FamilyCheck irradiance_check() {
  return {.family = "irradiance",
          .signature = [](int degree) { return Signature{{in_out_array("c", coefficient_count(degree))}}; },
          .inputs = vectors,
          .oracle =
              [](int degree, const auto* in, auto* out) {
                using Real = std::remove_cvref_t<decltype(*in)>;
                for (int l = 0; l <= degree; ++l) {
                  const Real factor = clamped_cosine_factor<Real>(l);
                  for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] = factor * in[i];
                }
              },
          .nearest = {},
          .size =
              [](int /*degree*/, const double* in, std::size_t output) {
                return std::abs(clamped_cosine_factor<double>(degree_of(output)) * in[output]);
              },
          .unit = "|A_l c_lm|"};
}

FamilyCheck irradiance_matrix_check() {
  return {.family = "irradiance_matrix",
          .signature =
              [](int /*degree*/) {
                return Signature{{in_array("c", 9), out_array("m", 16)}};
              },
          .inputs = vectors,
          .oracle = [](int /*degree*/, const auto* in, auto* out) { quadratic_form(in, out); },
          .nearest = {},
          .size = length_of_coefficients,
          .unit = "|c|"};
}

FamilyCheck irradiance_evaluate_check() {
  return {.family = "irradiance_evaluate",
          .signature = coefficients_and_normal,
          .inputs = vectors_and_normals,
          .oracle =
              [](int degree, const auto* in, auto* out) {
                const auto* const n = in + coefficient_count(degree);
                *out = irradiance_at(degree, in, n[0], n[1], n[2]);
              },
          .nearest = with_unit_normal(),
          .size = length_of_coefficients,
          .unit = "|c|"};
}

FamilyCheck lightmap_check() {
  return {.family = "lightmap",
          .signature =
              [](int /*degree*/) {
                return Signature{{in_array("c", 4), out_array("out", 4)}};
              },
          .inputs = vectors,
          .oracle = [](int /*degree*/, const auto* in, auto* out) { linear_form(in, out); },
          .nearest = {},
          .size = [](int /*degree*/, const double* in, std::size_t output) { return std::abs(in[output]); },
          .unit = "|c_lm|"};
}

FamilyCheck lightmap_project_check() {
  return {
      .family = "lightmap_project",
      .signature =
          [](int /*degree*/) {
            return Signature{{scalar("x"), scalar("y"), scalar("z"), scalar("weight"), in_out_array("sum", 4)}};
          },
      .inputs = [](int /*degree*/) { return combined(direction_inputs(kRandomDirections), vector_inputs(5, 71, 88)); },
      .oracle =
          [](int /*degree*/, const auto* in, auto* out) {
            using Real = std::remove_cvref_t<decltype(*in)>;
            std::array<Real, 4> c;
            basis(1, in[0], in[1], in[2], c.data());
            for (Real& value : c) value *= in[3];
            linear_form(c.data(), out);
            for (std::size_t i = 0; i < 4; ++i) out[i] += in[4 + i];
          },
      .nearest = with_unit_direction([](int) { return 0; }, [](int) { return 8; }),
      .size = [](int /*degree*/, const double* in,
                 std::size_t output) { return std::abs(in[3]) / 2 + std::abs(in[4 + output]); },
      .unit = "(|weight| / 2 + |sum|)"};
}

FamilyCheck lightmap_evaluate_check() {
  return {.family = "lightmap_evaluate",
          .signature =
              [](int /*degree*/) {
                return Signature{{in_array("e", 4), scalar("x"), scalar("y"), scalar("z")}, true};
              },
          .inputs = vectors_and_normals,
          .oracle = [](int /*degree*/, const auto* in,
                       auto* out) { *out = in[0] + in[1] * in[5] + in[2] * in[6] + in[3] * in[4]; },
          .nearest = with_unit_normal(),
          .size = length_of_coefficients,
          .unit = "|e|"};
}

}  // namespace sh::numeric
