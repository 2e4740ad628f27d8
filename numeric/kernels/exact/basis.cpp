// basis and basis_normalised: the values of every degree, against the recurrences of the oracle; basis_gradient: values
// and Cartesian derivatives of the solid harmonics r^l Y_lm(d/r), any d.
#include "numeric/oracle/basis.hpp"

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/oracle/gradient.hpp"

namespace sh::numeric {

std::vector<ExactFamily> exact_basis() {
  return {{"basis", [](int degree, const auto* d, auto* out) { basis(degree, d[0], d[1], d[2], out); }},
          {"basis_normalised",
           [](int degree, const auto* d, auto* out) {
             const auto unit = normalised(d[0], d[1], d[2]);
             basis(degree, unit[0], unit[1], unit[2], out);
           }},
          {"basis_gradient", [](int degree, const auto* d, auto* out) {
             const int count = coefficient_count(degree);
             basis_gradient(degree, d[0], d[1], d[2], out, out + count, out + 2 * count, out + 3 * count);
           }}};
}

}  // namespace sh::numeric
