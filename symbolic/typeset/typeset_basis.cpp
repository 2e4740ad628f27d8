// Tables of the basis functions and their derivatives.
#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::symbolic {
namespace {

const std::vector<std::string> kPoint{"x", "y", "z"};

template <class Visit>
void for_each_function(int degree, const Convention& convention, Visit visit) {
  require_convention(convention, 0);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) visit("Y" + tex_indices(l, m), l, m);
  }
}

// q(z) Re or Im (x+iy)^|m|: as the reduced form of basis.hpp, with the convention's factor.
void fill_reduced(FormulaTable& table, int degree, const Convention& convention) {
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
}

// The homogeneous forms, differentiated along each list of axes; an empty list gives the functions themselves.
void fill_derivatives(FormulaTable& table, int degree, const Convention& convention,
                      const std::vector<std::vector<int>>& derivatives) {
  for_each_function(degree, convention, [&](const std::string& symbol, int l, int m) {
    for (const std::vector<int>& axes : derivatives) {
      ConventionFunction f = convention_function(convention, l, m);
      std::string names;
      for (const int axis : axes) {
        f.re = f.re.derivative(axis);
        f.im = f.im.derivative(axis);
        names += kPoint[axis];
      }
      Formula row{names.empty() ? symbol : "\\partial_{" + names + "} " + symbol, {}};
      if (!f.re.is_zero()) row.terms.push_back({f.factor, false, {{f.re, kPoint}}});
      if (!f.im.is_zero()) row.terms.push_back({f.factor, true, {{f.im, kPoint}}});
      table.rows.push_back(std::move(row));
    }
  });
}

TypesetFamily derivatives_family(const char* name, const char* title, const char* note,
                                 const std::vector<std::vector<int>>& derivatives) {
  return {name,
          title,
          kMaxConventionDegree,
          "conventions are exact to degree 20",
          {note},
          [derivatives](FormulaTable& table, int degree, const Convention& convention) {
            fill_derivatives(table, degree, convention, derivatives);
          }};
}

}  // namespace

std::vector<TypesetFamily> basis_tables() {
  return {
      {"basis",
       "Spherical harmonics",
       kMaxConventionDegree,
       "conventions are exact to degree 20",
       {"Reduced form, valid where x^2 + y^2 + z^2 = 1."},
       fill_reduced},
      derivatives_family("solid", "Solid harmonics",
                         "Homogeneous form: the solid harmonic r^l Y everywhere, Y where x^2 + y^2 + z^2 = 1.", {{}}),
      derivatives_family("gradient", "Gradients of solid harmonics", "Cartesian gradient of the homogeneous form.",
                         {{0}, {1}, {2}}),
      derivatives_family("hessian", "Second derivatives of solid harmonics",
                         "Second Cartesian derivatives of the homogeneous form.",
                         {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}})};
}

}  // namespace sh::symbolic
