#include "codegen/choose/catalogue.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "codegen/bound/stated.hpp"
#include "codegen/choose/records.hpp"
#include "codegen/choose/wisdom.hpp"
#include "codegen/output/processes.hpp"
#include "codegen/print/batch.hpp"
#include "codegen/print/files.hpp"
#include "symbolic/number/find_named.hpp"

namespace sh::codegen {
namespace {

// `shgen write` writes a second kernel for accuracy if its error is below this fraction of the fastest kernel's error.
constexpr double kWorthwhile = 0.75;

template <class T>
struct Named {
  const char* name;
  T value;
};

// The first recipe that counts as equally fast as the fastest, on average over the machines; the first recipe if some have no
// measured time.
std::vector<Recipe>::iterator fastest(const Family& family, int degree, std::vector<Recipe>& recipes) {
  std::vector<std::string> names;
  std::vector<std::ptrdiff_t> places;
  for (auto recipe = recipes.begin(); recipe != recipes.end(); ++recipe) {
    if (!recipe->for_speed) continue;
    names.push_back(recipe->name);
    places.push_back(recipe - recipes.begin());
  }
  const std::vector<double> slowdowns = mean_slowdowns(committed_wisdom(), family.name, degree, names);
  if (slowdowns.empty()) return recipes.begin();
  const double enough = kNoise * *std::min_element(slowdowns.begin(), slowdowns.end());
  const auto found = std::find_if(slowdowns.begin(), slowdowns.end(), [enough](double time) { return time <= enough; });
  return recipes.begin() + places[found - slowdowns.begin()];
}

std::vector<FinishedKernel> finish_all(const Family& family, int degree) {
  std::vector<FinishedKernel> finished;
  for (const Recipe& recipe : recipes_for(family, degree)) finished.push_back(finish_kernel(family, recipe, degree));
  return finished;
}

// kernels: one for every recipe, the fastest first.
FinishedKernel choose(const std::vector<FinishedKernel>& kernels, Prefer prefer) {
  if (prefer == Prefer::kSpeed) return kernels.front();
  FinishedKernel chosen = *std::min_element(kernels.begin(), kernels.end(), [&](const auto& a, const auto& b) {
    return prefer == Prefer::kSize ? a.cost.operations() < b.cost.operations()
                                   : a.in_float.rounding.eps < b.in_float.rounding.eps;
  });
  if (chosen.kernel.recipe == kernels.front().kernel.recipe) return chosen;
  chosen.kernel.arguments += prefer == Prefer::kSize ? " --prefer size" : " --prefer accuracy";
  if (prefer == Prefer::kAccuracy) {
    chosen.kernel.name = chosen.kernel.family + "_accurate_l" + std::to_string(chosen.kernel.degree);
  }
  return chosen;
}

// Prints a kernel in every written language; its line of the manifest gets the paths and the stated errors.
void add_files(std::map<std::string, std::string>& files, const FinishedKernel& finished, ManifestEntry& entry) {
  for (const Language& language : languages()) {
    if (!language.written) continue;
    entry.files.push_back(language.name + "/" + finished.kernel.name + language.suffix);
    files[entry.files.back()] = language.print_kernel(finished, print::Scalar::kFloat);
  }
  entry.finished.in_float = finished.in_float;
  entry.finished.in_double = finished.in_double;
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
  return symbolic::find_named(among, name, "family");
}
const Language& find_language(const std::string& name) { return symbolic::find_named(languages(), name, "language"); }

const Recipe& find_recipe(const Family& family, int degree, const std::string& name) {
  const Recipe& recipe = symbolic::find_named(family.recipes, name, "recipe of " + family.name);
  if (degree < recipe.smallest || degree > recipe.largest) {
    throw std::invalid_argument("recipe " + name + " of " + family.name + ": expected degree " +
                                std::to_string(recipe.smallest) + " to " + std::to_string(recipe.largest) + ", got " +
                                std::to_string(degree));
  }
  return recipe;
}

Prefer find_preference(const std::string& name) {
  constexpr Named<Prefer> kPreferences[] = {
      {"speed", Prefer::kSpeed}, {"accuracy", Prefer::kAccuracy}, {"size", Prefer::kSize}};
  return symbolic::find_named(kPreferences, name, "preference").value;
}

print::Scalar find_scalar(const std::string& name) {
  constexpr Named<print::Scalar> kScalars[] = {{"float", print::Scalar::kFloat}, {"double", print::Scalar::kDouble}};
  return symbolic::find_named(kScalars, name, "scalar").value;
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
  return finish(kernel_stages(family, recipe, degree).back().kernel, family.domain);
}

FinishedKernel preferred_kernel(const Family& family, int degree, Prefer prefer) {
  const Recipe fastest = fastest_recipe(family, degree);
  if (prefer == Prefer::kSpeed) return finish_kernel(family, fastest, degree);
  return choose(finish_all(family, degree), prefer);
}

namespace {

// A part of the files. Text alone, which passes between processes.
struct Rendered {
  std::map<std::string, std::string> files;
  std::string nearest;               // nearest_point() of the family
  std::vector<ManifestRow> rows;     // of one degree of it
  std::vector<std::string> records;  // the same
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rendered, files, nearest, rows, records)

Rendered render_degree(const Family& family, int degree) {
  Rendered rendered;
  const std::vector<FinishedKernel> all = finish_all(family, degree);
  FinishedKernel written = choose(all, Prefer::kSpeed);
  FinishedKernel accurate = choose(all, Prefer::kAccuracy);
  const bool worthwhile = accurate.in_float.rounding.eps < kWorthwhile * all.front().in_float.rounding.eps;
  bound::state_errors(written);
  rendered.nearest = nearest_point(written.kernel.parameters);
  rendered.records.push_back(kernel_record(written));
  if (worthwhile) {
    bound::state_errors(accurate);
    rendered.records.push_back(kernel_record(accurate));
  }
  for (const FinishedKernel& candidate : all) {
    const std::string& recipe = candidate.kernel.recipe;
    ManifestEntry entry{candidate, {}, {}};
    for (const auto& [machine, wisdom] : committed_wisdom())
      entry.timings.push_back(wisdom.find(family.name, degree, recipe));
    if (recipe == written.kernel.recipe) add_files(rendered.files, written, entry);
    if (worthwhile && recipe == accurate.kernel.recipe) add_files(rendered.files, accurate, entry);
    rendered.rows.push_back(manifest_row(entry));
  }
  return rendered;
}

// The kernels of a family that are written, without passes and errors.
std::vector<FinishedKernel> written_kernels(const Family& family) {
  std::vector<FinishedKernel> kernels;
  for (int degree = 0; degree <= family.largest_written; ++degree) {
    const std::vector<Recipe> serving = recipes_for(family, degree);
    if (!serving.empty()) kernels.push_back({recipe_kernel(family, serving.front(), degree), {}, {}, {}, {}});
  }
  return kernels;
}

std::vector<print::WrittenFamily> written_families(const std::vector<const Family*>& families) {
  std::vector<print::WrittenFamily> written;
  for (const Family* family : families) written.push_back({family->name, family->batch, written_kernels(*family)});
  return written;
}

// The files of whole families, which need no kernel's errors.
std::map<std::string, std::string> family_files(const std::vector<print::WrittenFamily>& families) {
  std::map<std::string, std::string> files;
  for (const print::WrittenFamily& family : families) {
    for (const Language& language : languages()) {
      if (language.print_family == nullptr) continue;
      files[language.name + "/" + family.name + language.suffix] = language.print_family(family.kernels);
    }
  }
  return files;
}

std::vector<const Family*> pointers_to(const std::vector<Family>& families) {
  std::vector<const Family*> pointers;
  pointers.reserve(families.size());
  for (const Family& family : families) pointers.push_back(&family);
  return pointers;
}

struct Rendering {
  std::map<std::string, std::string> files;
  std::vector<ManifestRow> rows;
  std::vector<RecordedFamily> record;
};

// In as many processes as there are cores. The highest degrees come first, since they take longest.
Rendering render(const std::vector<const Family*>& families, bool with_batch,
                 const std::function<void(const std::string&)>& progress) {
  struct Piece {
    std::size_t family;
    int degree;
  };
  std::vector<Piece> pieces;
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (int degree = 0; degree <= families[f]->largest_written; ++degree) {
      if (!recipes_for(*families[f], degree).empty()) pieces.push_back({f, degree});
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.degree > b.degree; });
  const auto render_families = [&] {
    const std::vector<print::WrittenFamily> written = written_families(families);
    Rendered part{family_files(written), {}, {}, {}};
    if (with_batch) part.files.merge(print::batch_files(written));
    return part;
  };
  std::vector<std::map<int, Rendered>> degrees(families.size());
  Rendering rendering;
  in_processes(
      pieces.size() + 1, core_count(),
      [&](std::size_t i) {
        if (i == 0) return nlohmann::json(render_families()).dump();
        return nlohmann::json(render_degree(*families[pieces[i - 1].family], pieces[i - 1].degree)).dump();
      },
      [&](std::size_t i, const std::string& text) {
        auto part = nlohmann::json::parse(text).get<Rendered>();
        rendering.files.merge(part.files);
        if (i == 0) return;
        const Piece& piece = pieces[i - 1];
        progress(families[piece.family]->name + "_l" + std::to_string(piece.degree));
        degrees[piece.family][piece.degree] = std::move(part);
      });
  for (std::size_t f = 0; f < families.size(); ++f) {
    RecordedFamily& recorded = rendering.record.emplace_back(RecordedFamily{families[f], {}, {}});
    for (auto& [degree, part] : degrees[f]) {
      recorded.nearest = part.nearest;
      recorded.kernels.insert(recorded.kernels.end(), part.records.begin(), part.records.end());
      rendering.rows.insert(rendering.rows.end(), part.rows.begin(), part.rows.end());
    }
  }
  return rendering;
}

}  // namespace

std::map<std::string, std::string> render_batch() {
  return print::batch_files(written_families(pointers_to(families())));
}

std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress,
                                              const std::vector<Family>& families) {
  Rendering rendering = render(pointers_to(families), true, progress);
  rendering.files["families.json"] = print_families_record(rendering.record);
  rendering.files["MANIFEST"] = print_manifest(rendering.rows);
  return rendering.files;
}

std::map<std::string, std::string> render_families(const std::vector<std::string>& names,
                                                   const std::function<void(const std::string&)>& progress) {
  std::vector<const Family*> chosen;
  bool with_batch = false;
  for (const std::string& name : names) {
    if (name == kBatchFiles) {
      with_batch = true;
    } else {
      chosen.push_back(&find_family(name));
    }
  }
  std::map<std::string, std::string> files = render(chosen, false, progress).files;
  if (with_batch) files.merge(render_batch());
  return files;
}

}  // namespace sh::codegen
