// The catalogue: which kernels exist, how each is made and checked, and the files they are printed to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "codegen/families/families.hpp"
#include "codegen/passes/finished_kernel.hpp"
#include "codegen/passes/pipeline.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen {

struct Language {
  std::string name;      ///< as in `--lang`, and the folder under generated/
  std::string suffix;    ///< of its files
  bool written = false;  ///< `shgen write` writes it; the others are for `shgen emit`
  std::string (*print_kernel)(const FinishedKernel&, print::Scalar) = nullptr;
  /// One file for the whole family; nullptr where the language has no such file.
  std::string (*print_family)(const std::vector<FinishedKernel>&) = nullptr;
};

/// The aim of the choice among the recipes of a family.
enum class Prefer { kSpeed, kAccuracy, kSize };

const std::vector<Language>& languages();

/// Throw std::invalid_argument listing the known names.
const Family& find_family(const std::string& name, const std::vector<Family>& among = families());
const Language& find_language(const std::string& name);
const Recipe& find_recipe(const Family& family, int degree, const std::string& name);
Prefer find_preference(const std::string& name);
print::Scalar find_scalar(const std::string& name);

/// Throws std::invalid_argument unless 0 <= degree <= family.largest_emitted.
void require_degree(const Family& family, int degree);

/// The recipes that serve a degree, the fastest first according to the committed wisdom, else as the family lists them;
/// none where the family has no such kernel.
std::vector<Recipe> recipes_for(const Family& family, int degree);
/// The first of them. Throws std::invalid_argument listing the degrees when there is none.
Recipe fastest_recipe(const Family& family, int degree);

/// The kernel of the recipe, with the names and arguments of the catalogue. Errors as require_degree.
Kernel recipe_kernel(const Family& family, const Recipe& recipe, int degree);
/// At how many points a kernel is checked against the exact functions.
inline constexpr int kReferencePoints = 3;
/// The kernel after the recipe and after every pass; errors as run_pipeline and require_degree.
std::vector<Stage> kernel_stages(const Family& family, const Recipe& recipe, int degree);
/// The finished kernel with its cost and measured errors.
FinishedKernel finish_kernel(const Family& family, const Recipe& recipe, int degree);
/// The one that suits: the fastest, the one with the least float error, or the one with the fewest operations.
FinishedKernel preferred_kernel(const Family& family, int degree, Prefer prefer);

/// Relative path -> content of every file under generated/. progress is called with each kernel's name.
std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress,
                                              const std::vector<Family>& families = codegen::families());
/// The same for the kernels of some families alone: without MANIFEST, families.json and the drivers of
/// batches, which need them all.
std::map<std::string, std::string> render_families(const std::vector<std::string>& names,
                                                   const std::function<void(const std::string&)>& progress);

}  // namespace sh::codegen
