// The functions of [Brown04]: his definition, and his tables as printed.
#pragma once

#include <vector>

#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {

/// Y_l^m by his definition, P taken at cos theta: factor * polynomial in the angles, reduced.
SurdTerm brown_function(int degree, int order);

/// P_l^m(cos theta) by his four recursion rules, m >= 0.
Polynomial brown_legendre(int degree, int order);

/// The factor of Theta_lm and of Phi_m.
Surd brown_theta_factor(int degree, int order);
SurdTerm brown_phi(int order);

/// A row of a table: factor * trigonometric form, and the same in x, y, z where a second column is printed.
struct BrownRow {
  int degree = 0;
  int order = 0;  ///< as labelled
  Surd factor;
  Polynomial angles;
  Polynomial cartesian;  ///< zero where there is no second column
};

std::vector<BrownRow> brown_table_to_2();
std::vector<BrownRow> brown_table_3();
std::vector<BrownRow> brown_table_4();

}  // namespace sh::symbolic::errata
