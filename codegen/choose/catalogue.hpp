// The catalogue: which kernels exist, how each is made and checked, and the files they are printed to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "codegen/families/family.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen {

/// A language and its printers.
struct Language {
  std::string name;      ///< the value of `--lang` and the name of the folder under generated/
  std::string suffix;    ///< the suffix of its files
  bool written = false;  ///< true: `shgen write` writes this language; false: only `shgen emit` prints it
  std::string (*print_kernel)(const FinishedKernel&, print::Scalar) = nullptr;
  /// One file for the whole family; nullptr where the language has no such file.
  std::string (*print_family)(const std::vector<FinishedKernel>&) = nullptr;
};

/// The quality by which a recipe of a family is chosen.
enum class Prefer { kSpeed, kAccuracy, kSize };

/// Every language that a kernel can be printed in.
const std::vector<Language>& languages();

/// These functions find an item by its name. They throw std::invalid_argument, which lists the known names.
const Family& find_family(const std::string& name, const std::vector<Family>& among = families());
const Language& find_language(const std::string& name);
const Recipe& find_recipe(const Family& family, int degree, const std::string& name);
Prefer find_preference(const std::string& name);
print::Scalar find_scalar(const std::string& name);

/// Throws std::invalid_argument unless 0 <= degree <= family.largest_emitted.
void require_degree(const Family& family, int degree);

/// The recipes that serve a degree. The committed wisdom puts the fastest first; without it they keep the family's
/// order. The list is empty if the family has no kernel of this degree.
std::vector<Recipe> recipes_for(const Family& family, int degree);
/// The first recipe of recipes_for. If there is none, throws std::invalid_argument, which lists the degrees.
Recipe fastest_recipe(const Family& family, int degree);

/// The kernel of the recipe, with the names and arguments of the catalogue. Throws the exceptions of require_degree.
Kernel recipe_kernel(const Family& family, const Recipe& recipe, int degree);
/// The number of points at which a kernel is checked against the exact functions.
inline constexpr int kReferencePoints = 3;
/// The kernel after the recipe and after every pass. Throws the exceptions of run_pipeline and require_degree.
std::vector<Stage> kernel_stages(const Family& family, const Recipe& recipe, int degree);
/// The finished kernel with its cost and measured errors.
FinishedKernel finish_kernel(const Family& family, const Recipe& recipe, int degree);
/// The kernel that suits `prefer`: the fastest, the one with the least float error, or the one with the fewest
/// operations.
FinishedKernel preferred_kernel(const Family& family, int degree, Prefer prefer);

/// Relative path -> content of every file under generated/. Calls progress with the name of each kernel.
std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress,
                                              const std::vector<Family>& families = codegen::families());
/// The files of generated/batch/ alone, in seconds: their text needs no kernel's error.
std::map<std::string, std::string> render_batch();
/// The name that stands for these files in place of a family.
inline constexpr const char* kBatchFiles = "batch";
/// The same for the kernels of some families, or `batch`, only. Leaves out MANIFEST and families.json, because these need
/// all families.
std::map<std::string, std::string> render_families(const std::vector<std::string>& names,
                                                   const std::function<void(const std::string&)>& progress);

}  // namespace sh::codegen
