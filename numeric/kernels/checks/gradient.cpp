// basis_gradient(d) -> values and Cartesian derivatives of the solid harmonics r^l Y_lm(d/r), any d;
// basis_normalised(d) -> Y_lm(d/|d|). Against numeric's gradient and basis.
#include "numeric/oracle/gradient.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {
namespace {

constexpr int kRandomDirections = 150;

// Directions of several lengths; every second one of length 1.
std::vector<NamedInput> vectors(const std::array<double, 4>& lengths) {
  auto inputs = direction_inputs(kRandomDirections);
  for (std::size_t i = 1; i < inputs.size(); i += 2) {
    const double size = lengths[i / 2 % lengths.size()];
    for (double& value : inputs[i].values) value *= size;
    inputs[i].name += " times " + std::to_string(size);
  }
  return inputs;
}

}  // namespace

FamilyCheck basis_gradient_check() {
  return {.family = "basis_gradient",
          .signature =
              [](int degree) {
                const int count = coefficient_count(degree);
                return Signature{{scalar("x"), scalar("y"), scalar("z"), out_array("out", count),
                                  out_array("dx", count), out_array("dy", count), out_array("dz", count)}};
              },
          .inputs =
              [](int /*degree*/) {
                return vectors({0.1, 0.7, 1.5, 4});
              },
          .oracle =
              [](int degree, const auto* in, auto* out) {
                const auto count = static_cast<std::size_t>(coefficient_count(degree));
                basis_gradient(degree, in[0], in[1], in[2], out, out + count, out + 2 * count, out + 3 * count);
              },
          .nearest = {},
          .size =
              [](int degree, const double* in, std::size_t output) {
                const auto count = static_cast<std::size_t>(coefficient_count(degree));
                const int l = degree_of(output % count);
                const double r = length(in, 3);
                return output < count ? band_maximum(l) * std::pow(r, l) : l * band_maximum(l) * std::pow(r, l - 1);
              },
          .unit = "sqrt((2l+1)/4pi) r^l, for derivatives l sqrt((2l+1)/4pi) r^(l-1)"};
}

FamilyCheck basis_normalised_check() {
  return {
      .family = "basis_normalised",
      .signature =
          [](int degree) {
            return Signature{{scalar("x"), scalar("y"), scalar("z"), out_array("out", coefficient_count(degree))}};
          },
      .inputs =
          [](int /*degree*/) {
            return vectors({1e-15, 0.01, 3, 1e15});
          },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            const auto unit = normalised(in[0], in[1], in[2]);
            basis(degree, unit[0], unit[1], unit[2], out);
          },
      .nearest = {},
      .size = [](int /*degree*/, const double* /*in*/, std::size_t output) { return band_maximum(degree_of(output)); },
      .unit = "sqrt((2l+1)/4pi)"};
}

}  // namespace sh::numeric
