// cap(one_minus_cos) -> zonal; zonal(zonal, d) -> out; add_cap and add_cap_rgb (d, one_minus_cos, colour, sum in
// place). Against quadrature over the cap and numeric's basis in the direction of the light.
#include "numeric/oracle/cap.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/kernels/checks/zonal_oracle.hpp"

namespace sh::numeric {
namespace {

constexpr int kRandomDirections = 100;

// The largest coefficient a cap of this area has in band l, up to a factor near 1; for l = 0 the coefficient. The whole
// sphere and no cap at all have to be exact.
double cap_size(double u, int l) { return std::sqrt((2 * l + 1) * std::numbers::pi) * (l == 0 ? u : u * (2 - u) / 2); }

// x, y, z, one_minus_cos, one value a channel, sum (channels, bands^2)
FamilyCheck light_check(const std::string& family, int channels) {
  const auto first_sum = [channels](int /*degree*/) { return 4 + channels; };
  const auto count = [channels](int degree) { return 4 + channels + channels * coefficient_count(degree); };
  return {.family = family,
          .signature =
              [channels](int degree) {
                Signature signature{{scalar("x"), scalar("y"), scalar("z"), scalar("one_minus_cos")}};
                for (int i = 0; i < channels; ++i) signature.parameters.push_back(scalar("colour"));
                signature.parameters.push_back(in_out_array("sum", channels * coefficient_count(degree)));
                return signature;
              },
          .inputs =
              [channels](int degree) {
                const int sums = channels * coefficient_count(degree);
                auto lights = combined(combined(direction_inputs(kRandomDirections), cap_inputs()),
                                       vector_inputs(channels, 37, 75));
                auto before = vector_inputs(sums, 41, 76);
                // Every second light is added to nothing, so that its own error shows.
                for (std::size_t i = 0; i < before.size(); i += 2) {
                  before[i] = {"from zero", std::vector<double>(static_cast<std::size_t>(sums))};
                }
                return combined(lights, before);
              },
          .oracle =
              [channels, first_sum](int degree, const auto* in, auto* out) {
                using Real = std::remove_cvref_t<decltype(*in)>;
                std::vector<Real> zonal(static_cast<std::size_t>(degree) + 1);
                cap_zonal_quadrature(degree, in[3], zonal.data());
                const auto coefficients = static_cast<std::size_t>(coefficient_count(degree));
                std::vector<Real> turned(coefficients);
                turned_zonal(degree, zonal.data(), in, turned.data());
                const Real* const sum = in + first_sum(degree);
                for (std::size_t i = 0; i < static_cast<std::size_t>(channels) * coefficients; ++i) {
                  out[i] = sum[i] + in[4 + i / coefficients] * turned[i % coefficients];
                }
              },
          .nearest = with_unit_direction([](int) { return 0; }, count),
          .size =
              [first_sum](int degree, const double* in, std::size_t output) {
                const auto coefficients = static_cast<std::size_t>(coefficient_count(degree));
                const double colour = std::abs(in[4 + output / coefficients]);
                return colour * cap_size(in[3], degree_of(output % coefficients)) +
                       std::abs(in[static_cast<std::size_t>(first_sum(degree)) + output]);
              },
          .unit = "(|colour| sqrt((2l+1) pi) (1 - cos^2) / 2, at l = 0 |colour| sqrt(pi) (1 - cos), plus |sum|)"};
}

}  // namespace

FamilyCheck cap_check() {
  return {.family = "cap",
          .signature =
              [](int degree) {
                return Signature{{scalar("one_minus_cos"), out_array("zonal", degree + 1)}};
              },
          .inputs = [](int /*degree*/) { return cap_inputs(); },
          .oracle = [](int degree, const auto* in, auto* out) { cap_zonal_quadrature(degree, in[0], out); },
          .nearest = {},
          .size = [](int /*degree*/, const double* in,
                     std::size_t output) { return cap_size(in[0], static_cast<int>(output)); },
          .unit = "sqrt((2l+1) pi) (1 - cos^2) / 2, at l = 0 sqrt(pi) (1 - cos)"};
}

FamilyCheck zonal_check() {
  const auto direction = [](int degree) { return degree + 1; };
  return {
      .family = "zonal",
      .signature =
          [](int degree) {
            return Signature{{in_array("zonal", degree + 1), scalar("x"), scalar("y"), scalar("z"),
                              out_array("out", coefficient_count(degree))}};
          },
      .inputs =
          [](int degree) { return combined(vector_inputs(degree + 1, 53, 72), direction_inputs(kRandomDirections)); },
      .oracle = [direction](int degree, const auto* in,
                            auto* out) { turned_zonal(degree, in, in + direction(degree), out); },
      .nearest = with_unit_direction(direction, [](int degree) { return degree + 4; }),
      .size = [](int /*degree*/, const double* in, std::size_t output) { return std::abs(in[degree_of(output)]); },
      .unit = "|zonal[l]|"};
}

FamilyCheck add_cap_check() { return light_check("add_cap", 1); }
FamilyCheck add_cap_rgb_check() { return light_check("add_cap_rgb", 3); }

}  // namespace sh::numeric
