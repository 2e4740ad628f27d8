// Tables of the basis functions and their derivatives.
#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/basis/basis_derivatives.hpp"
#include "symbolic/convention/convention.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::symbolic {
namespace {

const std::vector<std::string> kPoint{"x", "y", "z"};
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

// factor * (re + i im)
std::vector<FormulaTerm> complex_terms(const Surd& factor, const Polynomial& re, const Polynomial& im) {
  std::vector<FormulaTerm> terms;
  if (!re.is_zero()) terms.push_back({factor, false, {{re, kPoint}}});
  if (!im.is_zero()) terms.push_back({factor, true, {{im, kPoint}}});
  return terms;
}

template <class Visit>
void for_each_function(int degree, const Convention& convention, Visit visit) {
  require_convention(convention, 0);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) visit("Y" + tex_indices(l, m), l, m);
  }
}

// q(z) Re or Im (x+iy)^|m|: as the reduced form of basis.hpp, with the convention's factor.
FormulaTable reduced_table(int degree, const Convention& convention) {
  FormulaTable table{{}, {"Reduced form, valid where x^2 + y^2 + z^2 = 1."}, {}};
  for_each_function(degree, convention, [&](const std::string& symbol, int l, int m) {
    const Surd factor = convention_factor(convention, l, m);
    const BasisFunction cosine = basis_function(l, std::abs(m));
    const BasisFunction sine = basis_function(l, -std::abs(m));
    const NamedPolynomial axial{cosine.axial, kPoint};
    Formula row{symbol, {}};
    if (convention.complex && m != 0) {
      row.terms.push_back({factor, false, {axial, {cosine.azimuthal, kPoint}}});
      row.terms.push_back({m < 0 ? -factor : factor, true, {axial, {sine.azimuthal, kPoint}}});
    } else {
      row.terms.push_back({factor, false, {axial, {(m < 0 ? sine : cosine).azimuthal, kPoint}}});
    }
    table.rows.push_back(std::move(row));
  });
  return table;
}

FormulaTable solid_table(int degree, const Convention& convention) {
  FormulaTable table{{}, {"Homogeneous form: the solid harmonic r^l Y everywhere, Y where x^2 + y^2 + z^2 = 1."}, {}};
  for_each_function(degree, convention, [&](const std::string& symbol, int l, int m) {
    const ConventionFunction f = convention_function(convention, l, m);
    table.rows.push_back({symbol, complex_terms(f.factor, f.re, f.im)});
  });
  return table;
}

FormulaTable gradient_table(int degree, const Convention& convention) {
  FormulaTable table{{}, {"Cartesian gradient of the homogeneous form."}, {}};
  for_each_function(degree, convention, [&](const std::string& symbol, int l, int m) {
    const ConventionFunction f = convention_function(convention, l, m);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string partial = std::string("\\partial_{") + kAxes[axis] + "} ";
      table.rows.push_back({partial + symbol, complex_terms(f.factor, f.re.derivative(axis), f.im.derivative(axis))});
    }
  });
  return table;
}

FormulaTable hessian_table(int degree, const Convention& convention) {
  FormulaTable table{{}, {"Second Cartesian derivatives of the homogeneous form."}, {}};
  for_each_function(degree, convention, [&](const std::string& symbol, int l, int m) {
    const ConventionFunction f = convention_function(convention, l, m);
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) {
        const std::string partial = std::string("\\partial_{") + kAxes[a] + kAxes[b] + "} ";
        table.rows.push_back({partial + symbol, complex_terms(f.factor, f.re.derivative(a).derivative(b),
                                                              f.im.derivative(a).derivative(b))});
      }
    }
  });
  return table;
}

}  // namespace

std::vector<TypesetFamily> basis_tables() {
  const std::string limit = "conventions are exact to degree 20";
  return {{"basis", "Spherical harmonics", kMaxConventionDegree, limit, reduced_table},
          {"solid", "Solid harmonics", kMaxConventionDegree, limit, solid_table},
          {"gradient", "Gradients of solid harmonics", kMaxConventionDegree, limit, gradient_table},
          {"hessian", "Second derivatives of solid harmonics", kMaxConventionDegree, limit, hessian_table}};
}

}  // namespace sh::symbolic
