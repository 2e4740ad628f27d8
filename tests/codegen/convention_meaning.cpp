#include "tests/codegen/convention_meaning.hpp"

#include <set>
#include <stdexcept>

#include "tests/codegen/meaning_check.hpp"

namespace sh::codegen::test {
namespace {

constexpr int kRepetitions = 3;

const std::vector<Meaning>& meanings() {
  static const std::vector<Meaning> all = [] {
    std::vector<Meaning> list = basis_meanings();
    for (const auto& part : {light_meanings(), rotation_and_product_meanings()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

bool is_among(const std::string& family, const std::set<std::string>& families) { return families.contains(family); }

}  // namespace

double deviation(const std::string& family, const World& world, const Call& call) {
  Check check(world, call);
  const auto found = std::find_if(meanings().begin(), meanings().end(),
                                  [&](const Meaning& meaning) { return meaning.family == family; });
  if (found == meanings().end()) throw std::invalid_argument(family + ": expected a family with a meaning here");
  for (int i = 0; i < kRepetitions; ++i) found->check(check);
  return check.largest;
}

std::vector<std::string> families_with_meaning() {
  std::vector<std::string> names;
  for (const Meaning& meaning : meanings()) names.push_back(meaning.family);
  return names;
}

bool has_no_functions(const std::string& family) {
  return is_among(family, {"evaluate_prepared", "project_moments", "lightmap_project", "lightmap_evaluate"});
}

bool has_no_axes(const std::string& family) {
  return family == "transfer_prepare" || family.starts_with("transfer_apply") || family.starts_with("relight") ||
         is_among(family, {"evaluate_prepare", "project_finish", "cap", "irradiance", "window_hann", "window_lanczos",
                           "window_lanczos2", "window_lanczos4", "window_gaussian", "window_laplacian", "rotate_z",
                           "rotate_apply", "lightmap_project", "lightmap_evaluate", "product", "product_full", "square",
                           "product_zonal", "triple"});
}

bool is_shared(const std::string& family, const Definition& definition) {
  return has_no_functions(family) && (!definition.own_axes || has_no_axes(family));
}

bool needs_radiance(const std::string& family) {
  return family.starts_with("transfer_") || family.starts_with("relight") ||
         is_among(family, {"irradiance", "product", "product_full", "square", "product_zonal", "triple"});
}

int degree_of(const std::string& family, int wanted) {
  if (family.starts_with("lightmap") || family.starts_with("irradiance_zh3")) return 1;
  if (family == "irradiance_matrix") return 2;
  return family.find("window") == 0 ? std::max(wanted, 1) : wanted;
}

}  // namespace sh::codegen::test
