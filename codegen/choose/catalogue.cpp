#include "codegen/choose/catalogue.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "codegen/choose/families_record.hpp"
#include "codegen/choose/manifest.hpp"
#include "codegen/choose/wisdom.hpp"
#include "codegen/print/batch.hpp"
#include "codegen/print/files.hpp"

namespace sh::codegen {
namespace {

// `shgen write` writes a second kernel for accuracy if its error is below this fraction of the fastest kernel's error.
constexpr double kWorthwhile = 0.75;

template <class T>
std::string names_of(const std::vector<T>& items) {
  std::string text;
  for (const T& item : items) text += (text.empty() ? "" : ", ") + item.name;
  return text;
}

template <class T>
const T& find(const std::vector<T>& items, const std::string& kind, const std::string& name) {
  for (const T& item : items) {
    if (item.name == name) return item;
  }
  throw std::invalid_argument("unknown " + kind + " '" + name + "': expected one of: " + names_of(items));
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> kLanguages{
      {.name = "cpp",
       .suffix = ".hpp",
       .written = true,
       .print_kernel = print::cpp_kernel,
       .print_family = print::cpp_family},
      {.name = "glsl", .suffix = ".glsl", .written = true, .print_kernel = print::glsl_kernel},
      {.name = "glsl-es", .suffix = ".glsl", .print_kernel = print::glsl_es_kernel},
      {.name = "hlsl", .suffix = ".hlsl", .print_kernel = print::hlsl_kernel},
      {.name = "c99", .suffix = ".h", .print_kernel = print::c99_kernel}};
  return kLanguages;
}

const Family& find_family(const std::string& name, const std::vector<Family>& among) {
  return find(among, "family", name);
}
const Language& find_language(const std::string& name) { return find(languages(), "language", name); }

namespace {

// The first recipe that counts as equally fast as the fastest; the first recipe if some have no measured time.
std::vector<Recipe>::iterator fastest(const Family& family, int degree, std::vector<Recipe>& recipes) {
  std::vector<double> times;
  for (const Recipe& recipe : recipes) {
    if (!recipe.for_speed) {
      times.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    const std::optional<Timing> timing = committed_wisdom().find(family.name, degree, recipe.name);
    if (!timing) return recipes.begin();
    times.push_back(timing->call);
  }
  if (times.empty()) return recipes.begin();
  const double enough = kNoise * *std::min_element(times.begin(), times.end());
  const auto found = std::find_if(times.begin(), times.end(), [enough](double time) { return time <= enough; });
  return recipes.begin() + (found - times.begin());
}

}  // namespace

const Recipe& find_recipe(const Family& family, int degree, const std::string& name) {
  const Recipe& recipe = find(family.recipes, "recipe of " + family.name, name);
  if (degree < recipe.smallest || degree > recipe.largest) {
    throw std::invalid_argument("recipe " + name + " of " + family.name + ": expected degree " +
                                std::to_string(recipe.smallest) + " to " + std::to_string(recipe.largest) + ", got " +
                                std::to_string(degree));
  }
  return recipe;
}

Prefer find_preference(const std::string& name) {
  if (name == "speed") return Prefer::kSpeed;
  if (name == "accuracy") return Prefer::kAccuracy;
  if (name == "size") return Prefer::kSize;
  throw std::invalid_argument("unknown preference '" + name + "': expected one of: speed, accuracy, size");
}

print::Scalar find_scalar(const std::string& name) {
  if (name == "float") return print::Scalar::kFloat;
  if (name == "double") return print::Scalar::kDouble;
  throw std::invalid_argument("unknown scalar '" + name + "': expected one of: float, double");
}

void require_degree(const Family& family, int degree) {
  if (degree < 0 || degree > family.largest_emitted) {
    throw std::invalid_argument(family.name + ": expected degree 0 to " + std::to_string(family.largest_emitted) +
                                ", got " + std::to_string(degree) + " (" + family.limit + ")");
  }
}

std::vector<Recipe> recipes_for(const Family& family, int degree) {
  require_degree(family, degree);
  std::vector<Recipe> serving;
  for (const Recipe& recipe : family.recipes) {
    if (recipe.smallest <= degree && degree <= recipe.largest) serving.push_back(recipe);
  }
  std::rotate(serving.begin(), fastest(family, degree, serving), serving.end());
  return serving;
}

Recipe fastest_recipe(const Family& family, int degree) {
  const std::vector<Recipe> serving = recipes_for(family, degree);
  if (!serving.empty()) return serving.front();
  std::string degrees;
  for (int other = 0; other <= family.largest_emitted; ++other) {
    if (recipes_for(family, other).empty()) continue;
    degrees += (degrees.empty() ? "" : ", ") + std::to_string(other);
  }
  throw std::invalid_argument(family.name + ": expected a degree among " + degrees + ", got " + std::to_string(degree));
}

Kernel recipe_kernel(const Family& family, const Recipe& recipe, int degree) {
  require_degree(family, degree);
  Kernel kernel = recipe.make(degree);
  kernel.name = family.name + "_l" + std::to_string(degree);
  kernel.family = family.name;
  kernel.degree = degree;
  kernel.recipe = recipe.name;
  kernel.arguments =
      (family.arguments.empty() ? family.name : family.arguments) + " --degree " + std::to_string(degree);
  return kernel;
}

std::vector<Stage> kernel_stages(const Family& family, const Recipe& recipe, int degree) {
  Kernel kernel = recipe_kernel(family, recipe, degree);
  return run_pipeline(std::move(kernel), family.reference(degree, kReferencePoints), default_passes());
}

FinishedKernel finish_kernel(const Family& family, const Recipe& recipe, int degree) {
  FinishedKernel finished;
  finished.kernel = kernel_stages(family, recipe, degree).back().kernel;
  finished.domain = family.domain;
  finished.cost = cost(finished.kernel);
  finished.in_float = measure<float>(finished.kernel, family.domain);
  finished.in_double = measure<double>(finished.kernel, family.domain);
  return finished;
}

namespace {

std::vector<FinishedKernel> finish_all(const Family& family, int degree) {
  std::vector<FinishedKernel> finished;
  for (const Recipe& recipe : recipes_for(family, degree)) finished.push_back(finish_kernel(family, recipe, degree));
  return finished;
}

// kernels: one for every recipe, the fastest first.
FinishedKernel choose(const std::vector<FinishedKernel>& kernels, Prefer prefer) {
  const auto error = [](const FinishedKernel& k) { return k.in_float.rounding.eps; };
  const auto size = [](const FinishedKernel& k) { return k.cost.operations(); };
  const auto least = [&](const auto& of) {
    return *std::min_element(kernels.begin(), kernels.end(),
                             [&](const FinishedKernel& a, const FinishedKernel& b) { return of(a) < of(b); });
  };
  if (prefer == Prefer::kSpeed) return kernels.front();
  FinishedKernel chosen = prefer == Prefer::kSize ? least(size) : least(error);
  if (chosen.kernel.recipe == kernels.front().kernel.recipe) return chosen;
  if (prefer == Prefer::kSize) {
    chosen.kernel.arguments += " --prefer size";
  } else {
    chosen.kernel.arguments += " --prefer accuracy";
    chosen.kernel.name = chosen.kernel.family + "_accurate_l" + std::to_string(chosen.kernel.degree);
  }
  return chosen;
}

// Prints a kernel in every written language and returns the paths.
std::vector<std::string> add_files(std::map<std::string, std::string>& files, const FinishedKernel& finished) {
  std::vector<std::string> paths;
  for (const Language& language : languages()) {
    if (!language.written) continue;
    paths.push_back(language.name + "/" + finished.kernel.name + language.suffix);
    files[paths.back()] = language.print_kernel(finished, print::Scalar::kFloat);
  }
  return paths;
}

}  // namespace

FinishedKernel preferred_kernel(const Family& family, int degree, Prefer prefer) {
  const Recipe fastest = fastest_recipe(family, degree);
  if (prefer == Prefer::kSpeed) return finish_kernel(family, fastest, degree);
  return choose(finish_all(family, degree), prefer);
}

namespace {

struct Rendering {
  std::map<std::string, std::string> files;
  std::vector<ManifestEntry> manifest;
  std::vector<print::WrittenFamily> written;
  std::vector<RecordedFamily> record;
};

void render_family(const Family& family, const std::function<void(const std::string&)>& progress,
                   Rendering& rendering) {
  rendering.written.push_back({family.name, family.batch, {}});
  std::vector<FinishedKernel>& written = rendering.written.back().kernels;
  std::vector<FinishedKernel>& recorded = rendering.record.emplace_back(RecordedFamily{&family, {}}).kernels;
  for (int degree = 0; degree <= family.largest_written; ++degree) {
    const std::vector<FinishedKernel> all = finish_all(family, degree);
    if (all.empty()) continue;
    written.push_back(choose(all, Prefer::kSpeed));
    recorded.push_back(written.back());
    progress(written.back().kernel.name);
    const FinishedKernel accurate = choose(all, Prefer::kAccuracy);
    const bool worthwhile = accurate.in_float.rounding.eps < kWorthwhile * all.front().in_float.rounding.eps;
    if (worthwhile) recorded.push_back(accurate);
    for (const FinishedKernel& candidate : all) {
      const std::string& recipe = candidate.kernel.recipe;
      ManifestEntry entry{candidate, {}, committed_wisdom().find(family.name, degree, recipe)};
      if (recipe == written.back().kernel.recipe) entry.files = add_files(rendering.files, written.back());
      if (worthwhile && recipe == accurate.kernel.recipe) entry.files = add_files(rendering.files, accurate);
      rendering.manifest.push_back(entry);
    }
  }
  for (const Language& language : languages()) {
    if (language.print_family == nullptr) continue;
    rendering.files[language.name + "/" + family.name + language.suffix] = language.print_family(written);
  }
}

}  // namespace

std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress,
                                              const std::vector<Family>& families) {
  Rendering rendering;
  for (const Family& family : families) render_family(family, progress, rendering);
  rendering.files.merge(print::batch_files(rendering.written));
  rendering.files["families.json"] = print_families_record(rendering.record);
  rendering.files["MANIFEST"] = print_manifest(rendering.manifest);
  return rendering.files;
}

std::map<std::string, std::string> render_families(const std::vector<std::string>& names,
                                                   const std::function<void(const std::string&)>& progress) {
  std::vector<const Family*> chosen;
  for (const std::string& name : names) chosen.push_back(&find_family(name));
  Rendering rendering;
  for (const Family* family : chosen) render_family(*family, progress, rendering);
  return rendering.files;
}

}  // namespace sh::codegen
