// basis(x, y, z) -> out (bands^2): the values of every degree, against the recurrences of numeric/basis.
#include "numeric/oracle/basis.hpp"

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {

FamilyCheck basis_check() {
  constexpr int kRandomDirections = 4096;
  return {
      .family = "basis",
      .signature =
          [](int degree) {
            return Signature{{scalar("x"), scalar("y"), scalar("z"), out_array("out", coefficient_count(degree))}};
          },
      .inputs = [](int /*degree*/) { return direction_inputs(kRandomDirections); },
      .oracle = [](int degree, const auto* d, auto* out) { basis(degree, d[0], d[1], d[2], out); },
      .nearest = with_unit_direction([](int) { return 0; }, [](int) { return 3; }),
      .size = [](int /*degree*/, const double* /*in*/, std::size_t output) { return band_maximum(degree_of(output)); },
      .unit = "sqrt((2l+1)/4pi)"};
}

}  // namespace sh::numeric
