#include "symbolic/typeset/typeset_families.hpp"

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/find_named.hpp"

namespace sh::symbolic {
namespace {

std::string braces(const std::string& inside) { return std::string("_{").append(inside).append("}"); }

std::vector<TypesetFamily> all_families() {
  std::vector<TypesetFamily> families;
  for (const auto& part : {basis_tables(), rotation_tables(), product_tables(), zonal_tables()}) {
    families.insert(families.end(), part.begin(), part.end());
  }
  return families;
}

}  // namespace

std::string tex_indices(int first, int second) { return braces(std::to_string(first) + "," + std::to_string(second)); }

std::string tex_indices(int first, int second, int third) {
  return braces(std::to_string(first) + "," + std::to_string(second) + "," + std::to_string(third));
}

std::string indexed(const char* name, int index) { return name + braces(std::to_string(index)); }

ConventionMap map_to(Convention convention, int degree) {
  convention.axes = SignedPermutation();
  return convention_map({}, convention, degree);
}

const std::vector<TypesetFamily>& typeset_families() {
  static const std::vector<TypesetFamily> families = all_families();
  return families;
}

FormulaTable typeset_table(std::string_view family, int degree, const Preset& preset) {
  const TypesetFamily& found = find_named(typeset_families(), family, "family");
  require_degree(found.name, degree, found.max_degree, found.limit);
  FormulaTable table{found.title + ", degree " + std::to_string(degree) + ", convention " + preset.name,
                     {"Convention " + preset.name + ": " + preset.covers + "."},
                     {}};
  table.notes.insert(table.notes.end(), found.notes.begin(), found.notes.end());
  found.fill(table, degree, preset.convention);
  return table;
}

}  // namespace sh::symbolic
