// The families of formulas that can be typeset, by name: `shgen tex|markdown FAMILY --degree N [--convention C]`.
//
// Input: a family, a degree and a preset. Output: a FormulaTable. The formulas are those of the convention in its own
// coordinates; a note says where a family does not depend on the convention.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/convention/convention.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/typeset/typeset.hpp"

namespace sh::symbolic {

struct TypesetFamily {
  std::string name;   ///< as on the command line
  std::string title;  ///< plain text
  int max_degree = 0;
  std::string limit;               ///< the reason for max_degree
  std::vector<std::string> notes;  ///< plain text, one sentence each
  /// Adds the rows, and notes that depend on the convention.
  std::function<void(FormulaTable& table, int degree, const Convention& convention)> fill;
};

/// basis, solid, gradient, hessian | rotation, rotation-quaternion, rotation-z, rotation-x90, rotation-y, wigner-d |
/// gaunt, product, square, zonal-product, transfer | irradiance, convolution, turned-zonal, every name of
/// zonal_families().
const std::vector<TypesetFamily>& typeset_families();

/// Throws std::invalid_argument, in one line, for an unknown family (lists them), a degree outside 0..max_degree (gives
/// the limit and the reason) and a convention that does not apply to the family.
FormulaTable typeset_table(std::string_view family, int degree, const Preset& preset);

/// The parts of the list, one a file.
std::vector<TypesetFamily> basis_tables();
std::vector<TypesetFamily> rotation_tables();
std::vector<TypesetFamily> product_tables();
std::vector<TypesetFamily> zonal_tables();

/// "_{1,-2}" or "_{1,2,3}".
std::string tex_indices(int first, int second);
std::string tex_indices(int first, int second, int third);

/// "a_{3}".
std::string indexed(const char* name, int index);

/// The map from our convention to `convention` in its own coordinates.
ConventionMap map_to(Convention convention, int degree);

}  // namespace sh::symbolic
