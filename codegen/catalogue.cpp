#include "codegen/catalogue.hpp"

#include <stdexcept>

#include "codegen/directions.hpp"
#include "codegen/manifest.hpp"
#include "codegen/print/cpp.hpp"
#include "codegen/print/glsl.hpp"
#include "codegen/recipes/basis.hpp"
#include "symbolic/basis.hpp"

namespace sh::codegen {
namespace {

constexpr int kReferencePoints = 3;

Reference basis_reference(int degree, int count) {
  Reference reference;
  for (const auto& d : rational_directions(count)) reference.push_back({{d[0], d[1], d[2]}, {}});
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const symbolic::BasisFunction f = symbolic::basis_function(l, m);
      for (ReferencePoint& point : reference) {
        // One exact rational factor and one irrational one, so the product is as precise as the latter.
        const symbolic::Surd value = symbolic::Surd(f.homogeneous.evaluate(point.inputs)) * f.factor;
        point.outputs.push_back(value.evaluate(kCheckDigits));
      }
    }
  }
  return reference;
}

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
  throw std::invalid_argument("unknown " + kind + " '" + name + "'; it should be one of: " + names_of(items));
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies{{"basis", 10, 20, recipes::basis_recurrence, basis_reference,
                                              measure_on_sphere<float>, measure_on_sphere<double>}};
  return kFamilies;
}

const std::vector<Language>& languages() {
  static const std::vector<Language> kLanguages{{"cpp", ".hpp", print::cpp_kernel, print::cpp_family},
                                                {"glsl", ".glsl", print::glsl_kernel, nullptr}};
  return kLanguages;
}

const Family& find_family(const std::string& name) { return find(families(), "family", name); }
const Language& find_language(const std::string& name) { return find(languages(), "language", name); }

void require_degree(const Family& family, int degree) {
  if (degree < 0 || degree > family.largest_emitted) {
    throw std::invalid_argument(family.name + ": degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(family.largest_emitted) +
                                ", beyond which straight-line code is too long to be useful");
  }
}

std::vector<Stage> kernel_stages(const Family& family, int degree) {
  require_degree(family, degree);
  return run_pipeline(family.recipe(degree), family.reference(degree, kReferencePoints), default_passes());
}

FinishedKernel finish_kernel(const Family& family, int degree) {
  FinishedKernel finished;
  finished.kernel = kernel_stages(family, degree).back().kernel;
  finished.cost = cost(finished.kernel);
  finished.in_float = family.measure_float(finished.kernel);
  finished.in_double = family.measure_double(finished.kernel);
  return finished;
}

std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress) {
  std::map<std::string, std::string> files;
  std::vector<ManifestEntry> manifest;
  for (const Family& family : families()) {
    std::vector<FinishedKernel> kernels;
    for (int degree = 0; degree <= family.largest_written; ++degree) {
      kernels.push_back(finish_kernel(family, degree));
      manifest.push_back({kernels.back(), {}});
      progress(kernels.back().kernel.name);
      for (const Language& language : languages()) {
        const std::string path = language.name + "/" + kernels.back().kernel.name + language.suffix;
        files[path] = language.print_kernel(kernels.back());
        manifest.back().files.push_back(path);
      }
    }
    for (const Language& language : languages()) {
      if (language.print_family == nullptr) continue;
      files[language.name + "/" + family.name + language.suffix] = language.print_family(kernels);
    }
  }
  files["MANIFEST"] = print_manifest(manifest);
  return files;
}

}  // namespace sh::codegen
