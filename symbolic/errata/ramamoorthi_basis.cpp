#include "symbolic/errata/ramamoorthi_basis.hpp"

#include <algorithm>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/exact_tools.hpp"
#include "symbolic/number/substitute.hpp"

namespace sh::symbolic::errata {
namespace {

// The number that multiplies `printed` in Y_lm; zero when Y_lm is no multiple of it on the sphere.
Surd constant_before(const Polynomial& printed, int degree, int order) {
  const BasisFunction y = basis_function(degree, order);
  const Polynomial ours = reduce_on_sphere(y.homogeneous);
  const Polynomial theirs = reduce_on_sphere(printed);
  const auto& [monomial, coefficient] = *theirs.terms().begin();
  const cln::cl_RA multiple = ours.coefficient(monomial) / coefficient;
  return ours == multiple * theirs ? Surd(multiple) * y.factor : Surd();
}

}  // namespace

std::vector<PrintedFunction> ramamoorthi_functions() {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  const Polynomial one(1);
  return {{0, 0, "0.282095", one},
          {1, 1, "0.488603", x},
          {1, 0, "0.488603", z},
          {1, -1, "0.488603", y},
          {2, 1, "1.092548", x * z},
          {2, -1, "1.092548", y * z},
          {2, -2, "1.092548", x * y},
          {2, 0, "0.315392", 3 * (z * z) - one},
          {2, 2, "0.546274", x * x - y * y}};
}

bool ramamoorthi_functions_are(Surd (*band_factor)(int degree)) {
  const std::vector<PrintedFunction> functions = ramamoorthi_functions();
  return std::all_of(functions.begin(), functions.end(), [&](const PrintedFunction& f) {
    return rounds_to(band_factor(f.degree) * constant_before(f.polynomial, f.degree, f.order), f.decimal);
  });
}

}  // namespace sh::symbolic::errata
