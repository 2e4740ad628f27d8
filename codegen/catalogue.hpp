// The catalogue: which kernels exist, how each is made and checked, and the files they are printed to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "codegen/finished_kernel.hpp"
#include "codegen/pipeline.hpp"

namespace sh::codegen {

struct Family {
  std::string name;
  int largest_written = 0;  ///< `shgen write` writes degrees 0 to this
  int largest_emitted = 0;  ///< `shgen emit` prints degrees 0 to this
  Kernel (*recipe)(int degree) = nullptr;
  /// Exact outputs of the family at `count` points of its domain.
  Reference (*reference)(int degree, int count) = nullptr;
  MeasuredError (*measure_float)(const Kernel&) = nullptr;
  MeasuredError (*measure_double)(const Kernel&) = nullptr;
};

struct Language {
  std::string name;    ///< as in `--lang`, and the folder under generated/
  std::string suffix;  ///< of its files
  std::string (*print_kernel)(const FinishedKernel&) = nullptr;
  /// One file for the whole family; nullptr where the language has no such file.
  std::string (*print_family)(const std::vector<FinishedKernel>&) = nullptr;
};

const std::vector<Family>& families();
const std::vector<Language>& languages();

/// Throw std::invalid_argument listing what there is.
const Family& find_family(const std::string& name);
const Language& find_language(const std::string& name);

/// Throws std::invalid_argument unless 0 <= degree <= family.largest_emitted.
void require_degree(const Family& family, int degree);

/// The kernel after the recipe and after every pass; errors as run_pipeline and require_degree.
std::vector<Stage> kernel_stages(const Family& family, int degree);
/// The finished kernel with its cost and measured errors.
FinishedKernel finish_kernel(const Family& family, int degree);

/// Relative path -> content of every file under generated/. progress is called with each kernel's name.
std::map<std::string, std::string> render_all(const std::function<void(const std::string&)>& progress);

}  // namespace sh::codegen
