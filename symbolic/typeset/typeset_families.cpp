#include "symbolic/typeset/typeset_families.hpp"

#include <stdexcept>

#include "symbolic/number/require_degree.hpp"

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

const TypesetFamily& find_typeset_family(std::string_view name) {
  std::string names;
  for (const TypesetFamily& family : typeset_families()) {
    if (family.name == name) return family;
    names += (names.empty() ? "" : ", ") + family.name;
  }
  throw std::invalid_argument("unknown family '" + std::string(name) + "'; it should be one of " + names);
}

}  // namespace

std::string tex_indices(int first, int second) {
  return braces(std::to_string(first).append(",").append(std::to_string(second)));
}

std::string tex_indices(int first, int second, int third) {
  return braces(
      std::to_string(first).append(",").append(std::to_string(second)).append(",").append(std::to_string(third)));
}

std::string indexed(const char* name, int index) { return name + braces(std::to_string(index)); }

ConventionMap map_to(Convention convention, int degree) {
  convention.axes = SignedPermutation();
  return convention_map(Convention{}, convention, degree);
}

const std::vector<TypesetFamily>& typeset_families() {
  static const std::vector<TypesetFamily> families = all_families();
  return families;
}

FormulaTable typeset_table(std::string_view family, int degree, const Preset& preset) {
  const TypesetFamily& found = find_typeset_family(family);
  require_degree(found.name, degree, found.max_degree, found.limit);
  FormulaTable table = found.table(degree, preset.convention);
  table.title = found.title + ", degree " + std::to_string(degree) + ", convention " + preset.name;
  table.notes.insert(table.notes.begin(), "Convention " + preset.name + ": " + preset.covers + ".");
  return table;
}

}  // namespace sh::symbolic
