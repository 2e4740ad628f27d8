// Rotations: rotate (r, c), rotate_quaternion (q, c), rotate_z (cos, sin, c) -> c'; rotate_build r -> m, rotate_apply
// (m, c) -> c'; rotate_evaluate (r, c, d) -> f(r^-1 d). Against the recursion of Ivanic and Ruedenberg in
// numeric/rotation, at the rotation nearest to the rounded input.
#include "numeric/oracle/rotation.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/kernels/checks/rotation_inputs.hpp"
#include "numeric/oracle/rotation_matrices.hpp"

namespace sh::numeric {
namespace {

constexpr int kVectors = 47;

// The number of entries of all band matrices: sum (2l+1)^2.
int matrix_count(int degree) { return (degree + 1) * (2 * degree + 1) * (2 * degree + 3) / 3; }

std::vector<NamedInput> with_coefficients(const std::vector<NamedInput>& rotations, int degree) {
  return combined(rotations, coefficient_inputs(degree, kVectors, 1959));
}

// |c| for inputs that begin with `first` other numbers.
auto length_after(int first) {
  return [first](int degree, const double* in, std::size_t /*output*/) {
    return length(in + first, coefficient_count(degree));
  };
}

// D_0, D_1, ... row by row.
template <class Real>
void all_bands(int degree, const Real* r, Real* out) {
  for (const auto& band : rotation_bands(degree, r)) out = std::copy(band.begin(), band.end(), out);
}

std::vector<NamedInput> band_matrices(int degree) {
  std::vector<NamedInput> all;
  for (const auto& rotation : matrix_inputs()) {
    all.push_back({rotation.name, std::vector<double>(static_cast<std::size_t>(matrix_count(degree)))});
    all_bands(degree, rotation.values.data(), all.back().values.data());
  }
  return all;
}

}  // namespace

FamilyCheck rotate_check() {
  return {.family = "rotate",
          .signature =
              [](int degree) {
                const int count = coefficient_count(degree);
                return Signature{{in_matrix("r", 3, 3), in_array("c", count), out_array("out", count)}};
              },
          .inputs = [](int degree) { return with_coefficients(matrix_inputs(), degree); },
          .oracle = [](int degree, const auto* in, auto* out) { rotate(degree, in, in + 9, out); },
          .nearest =
              [](int degree, const auto* in, auto* out) {
                nearest_rotation(in, out);
                std::copy_n(in + 9, coefficient_count(degree), out + 9);
              },
          .size = length_after(9),
          .unit = "|c|"};
}

FamilyCheck rotate_quaternion_check() {
  return {.family = "rotate_quaternion",
          .signature =
              [](int degree) {
                const int count = coefficient_count(degree);
                return Signature{{in_matrix("q", 4, 1), in_array("c", count), out_array("out", count)}};
              },
          .inputs = [](int degree) { return with_coefficients(quaternion_inputs(), degree); },
          .oracle =
              [](int degree, const auto* in, auto* out) {
                std::array<std::remove_cvref_t<decltype(*in)>, 9> r;
                matrix_of_quaternion(in, r.data());
                rotate(degree, r.data(), in + 4, out);
              },
          .nearest =
              [](int degree, const auto* in, auto* out) {
                scale_to_unit(4, in, out);
                std::copy_n(in + 4, coefficient_count(degree), out + 4);
              },
          .size = length_after(4),
          .unit = "|c|"};
}

FamilyCheck rotate_z_check() {
  return {
      .family = "rotate_z",
      .signature =
          [](int degree) {
            const int count = coefficient_count(degree);
            return Signature{{scalar("cos_angle"), scalar("sin_angle"), in_array("c", count), out_array("out", count)}};
          },
      .inputs = [](int degree) { return with_coefficients(turn_inputs(), degree); },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            using Real = std::remove_cvref_t<decltype(*in)>;
            const std::array<Real, 9> r = {in[0], -in[1], 0, in[1], in[0], 0, 0, 0, 1};
            rotate(degree, r.data(), in + 2, out);
          },
      .nearest =
          [](int degree, const auto* in, auto* out) {
            scale_to_unit(2, in, out);
            std::copy_n(in + 2, coefficient_count(degree), out + 2);
          },
      .size = length_after(2),
      .unit = "|c|"};
}

FamilyCheck rotate_build_check() {
  return {.family = "rotate_build",
          .signature =
              [](int degree) {
                return Signature{{in_matrix("r", 3, 3), out_array("m", matrix_count(degree))}};
              },
          .inputs = [](int /*degree*/) { return matrix_inputs(); },
          .oracle = [](int degree, const auto* in, auto* out) { all_bands(degree, in, out); },
          .nearest = [](int /*degree*/, const auto* in, auto* out) { nearest_rotation(in, out); },
          .size = [](int /*degree*/, const double* /*in*/, std::size_t /*output*/) { return 1.0; },
          .unit = "1"};
}

FamilyCheck rotate_apply_check() {
  return {.family = "rotate_apply",
          .signature =
              [](int degree) {
                const int count = coefficient_count(degree);
                return Signature{{in_array("m", matrix_count(degree)), in_array("c", count), out_array("out", count)}};
              },
          .inputs = [](int degree) { return with_coefficients(band_matrices(degree), degree); },
          .oracle =
              [](int degree, const auto* in, auto* out) {
                const auto* const c = in + matrix_count(degree);
                for (int l = 0; l <= degree; ++l) {
                  for (int row = l * l; row < (l + 1) * (l + 1); ++row) {
                    out[row] = 0;
                    for (int column = l * l; column < (l + 1) * (l + 1); ++column) out[row] += *in++ * c[column];
                  }
                }
              },
          .nearest = {},
          .size = [](int degree, const double* in,
                     std::size_t /*output*/) { return length(in + matrix_count(degree), coefficient_count(degree)); },
          .unit = "|c|"};
}

FamilyCheck rotate_evaluate_check() {
  constexpr int kRandomDirections = 80;
  return {.family = "rotate_evaluate",
          .signature =
              [](int degree) {
                return Signature{{in_matrix("r", 3, 3), in_array("c", coefficient_count(degree)), scalar("x"),
                                  scalar("y"), scalar("z")},
                                 true};
              },
          .inputs =
              [](int degree) {
                return combined(with_coefficients(matrix_inputs(), degree), direction_inputs(kRandomDirections));
              },
          .oracle =
              [](int degree, const auto* in, auto* out) {
                const int count = coefficient_count(degree);
                std::vector<std::remove_cvref_t<decltype(*in)>> turned(static_cast<std::size_t>(count));
                rotate(degree, in, in + 9, turned.data());
                const auto* const d = in + 9 + count;
                const auto values = basis(degree, d[0], d[1], d[2]);
                *out = 0;
                for (std::size_t i = 0; i < turned.size(); ++i) *out += turned[i] * values[i];
              },
          .nearest =
              [](int degree, const auto* in, auto* out) {
                const int count = coefficient_count(degree);
                nearest_rotation(in, out);
                std::copy_n(in + 9, count, out + 9);
                scale_to_unit(3, in + 9 + count, out + 9 + count);
              },
          .size =
              [](int degree, const double* in, std::size_t /*output*/) {
                return length(in + 9, coefficient_count(degree)) * (degree + 1) / std::sqrt(4 * std::numbers::pi);
              },
          .unit = "|c| sqrt(sum (2l+1) / 4 pi)"};
}

}  // namespace sh::numeric
