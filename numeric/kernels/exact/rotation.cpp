// Rotations: rotate (r, c), rotate_quaternion (q, c), rotate_z (cos, sin, c) -> c'; rotate_build r -> m, rotate_apply
// (m, c) -> c'; rotate_evaluate (r, c, d) -> f(r^-1 d). Against the recursion of Ivanic and Ruedenberg of the oracle.
#include "numeric/oracle/rotation.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "numeric/oracle/rotation_matrices.hpp"

namespace sh::numeric {
namespace {

// The number of entries of all band matrices: sum (2l+1)^2.
int matrix_count(int degree) { return (degree + 1) * (2 * degree + 1) * (2 * degree + 3) / 3; }

// D_0, D_1, ... row by row.
template <class Real>
void all_bands(int degree, const Real* r, Real* out) {
  for (const auto& band : rotation_bands(degree, r)) out = std::copy(band.begin(), band.end(), out);
}

std::vector<NamedInput> band_matrices(int degree) {
  std::vector<NamedInput> all;
  for (const auto& rotation : matrix_inputs()) {
    all.push_back({rotation.name, std::vector<double>(matrix_count(degree))});
    all_bands(degree, rotation.values.data(), all.back().values.data());
  }
  return all;
}

}  // namespace

std::vector<ExactFamily> exact_rotation() {
  return {{"rotate", [](int degree, const auto* in, auto* out) { rotate(degree, in, in + 9, out); }},
          {"rotate_quaternion",
           [](int degree, const auto* in, auto* out) {
             std::array<std::remove_cvref_t<decltype(*in)>, 9> r;
             matrix_of_quaternion(in, r.data());
             rotate(degree, r.data(), in + 4, out);
           }},
          {"rotate_z",
           [](int degree, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             const std::array<Real, 9> r = {in[0], -in[1], 0, in[1], in[0], 0, 0, 0, 1};
             rotate(degree, r.data(), in + 2, out);
           }},
          {"rotate_build", [](int degree, const auto* in, auto* out) { all_bands(degree, in, out); }},
          {"rotate_apply",
           [](int degree, const auto* in, auto* out) {
             const auto* const c = in + matrix_count(degree);
             for (int l = 0; l <= degree; ++l) {
               for (int row = l * l; row < coefficient_count(l); ++row) {
                 out[row] = 0;
                 for (int column = l * l; column < coefficient_count(l); ++column) out[row] += *in++ * c[column];
               }
             }
           },
           band_matrices},
          {"rotate_evaluate", [](int degree, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             std::vector<Real> turned(coefficient_count(degree));
             rotate(degree, in, in + 9, turned.data());
             const Real* const d = in + 9 + turned.size();
             const auto values = basis(degree, d[0], d[1], d[2]);
             *out = 0;
             for (std::size_t i = 0; i < turned.size(); ++i) *out += turned[i] * values[i];
           }}};
}

}  // namespace sh::numeric
