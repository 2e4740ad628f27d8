// shcheck kernels: every generated kernel against the oracle. shcheck worst: the input at which each kernel errs most, by
// search, or among all floats where there is one variable.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "numeric/commands/commands.hpp"
#include "numeric/kernels/exhaustive.hpp"
#include "numeric/kernels/kernel_check.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/kernels/kernel_search.hpp"
#include "numeric/output/atomic_file.hpp"

namespace sh::numeric {
namespace {

struct KernelOptions {
  std::string generated = SHFORGE_GENERATED_DIR;
  std::string family;
  std::string json_file;
};

ExitCode check(const KernelOptions& options) {
  if (!options.json_file.empty()) output::require_writable(options.json_file);
  const auto results = check_kernels({options.generated, options.family}, say);
  std::vector<std::string> failures;
  for (const auto& kernel : unchecked_kernels(bound_kernels())) {
    failures.push_back(kernel + ": no check describes its family");
  }
  for (const auto& result : results) {
    for (auto& failure : failures_of(result)) failures.push_back(std::move(failure));
  }
  print(options.family.empty() ? format_summary(results) : format_details(results));
  if (!options.json_file.empty()) output::write_file(options.json_file, format_json(results, failures));
  for (const auto& failure : failures) say(failure);
  return failures.empty() ? kDone : kDifferent;
}

struct WorstOptions {
  std::string family;
  std::optional<int> degree;
  std::size_t evaluations = 2000;
  bool exhaustive = false;

  // Whether to show a kernel of this family or of a variant of it.
  [[nodiscard]] bool wants(const std::string& of, int its_degree) const {
    return (family.empty() || family == of || family == without_variant(of)) && (!degree || *degree == its_degree);
  }
};

// A line for each kernel and scalar; false if the error exceeds `allowed`.
bool print_line(const std::string& name, const std::string& scalar, double error, double allowed,
                const std::string& where) {
  const bool kept = error <= allowed;
  print(
      fmt::format("{:<30} {:<6} {:>9.3g} eps{}  {}\n", name, scalar, error, kept ? "" : " (beyond its limit)", where));
  return kept;
}

template <class T>
bool search(const BoundKernel& kernel, const FamilyCheck& check, const WorstOptions& options) {
  const KernelResult found = search_kernel<T>(kernel, check, {4, options.evaluations, 1});
  const auto limits = limits_for(kernel.family, kernel.degree, found.scalar);
  std::string where = found.worst_rounding.output + " at";
  constexpr std::size_t kMostShown = 6;
  const auto& values = found.worst_rounding.values;
  const std::size_t shown = options.family.empty() ? std::min(kMostShown, values.size()) : values.size();
  for (std::size_t i = 0; i < shown; ++i) where += fmt::format(" {:.17g}", values[i]);
  if (shown < values.size()) where += " ... (--family shows all)";
  return print_line(kernel.name(), found.scalar, found.rounding.scaled().max(), limits ? limits->searched : 0, where);
}

ExitCode search_all(const WorstOptions& options) {
  bool kept = true;
  std::size_t count = 0;
  for (const BoundKernel& kernel : bound_kernels()) {
    const FamilyCheck* const check = find_check(kernel.family);
    if (check == nullptr || !options.wants(kernel.family, kernel.degree)) continue;
    ++count;
    kept = search<float>(kernel, *check, options) && kept;
    kept = search<double>(kernel, *check, options) && kept;
  }
  if (count == 0) throw std::invalid_argument("worst: expected a kernel that `shcheck kernels` lists");
  return kept ? kDone : kDifferent;
}

ExitCode try_every_float(const WorstOptions& options) {
  bool kept = true;
  std::size_t count = 0;
  for (const OneVariableKernel& kernel : one_variable_kernels()) {
    if (!options.wants(kernel.family, kernel.degree)) continue;
    ++count;
    const FloatError worst = kernel.worst({0, kernel.largest, 1});
    const auto limits = limits_for(kernel.family, kernel.degree, "float");
    const std::string where = fmt::format("output {} at {:.9g}, of {} floats", worst.output, worst.at, worst.evaluated);
    kept = print_line(kernel.name(), "float", worst.error, limits ? limits->rounding : 0, where) && kept;
  }
  if (count == 0) {
    throw std::invalid_argument(
        "worst: --exhaustive: expected a kernel of one variable: cap, window_hann, window_gaussian or "
        "window_laplacian");
  }
  return kept ? kDone : kDifferent;
}

}  // namespace

void add_kernel_commands(Command& tool) {
  const auto checked = std::make_shared<KernelOptions>();
  auto kernels = tool.command("kernels", "compare every generated kernel with the oracle");
  kernels.option("--family", checked->family, "only this family and its variants, a line a language and scalar");
  kernels.option("--json", checked->json_file, "also write the results to this file");
  kernels.option("--generated", checked->generated, "the folder generated/ whose GLSL files are run").with_default();
  kernels.run([checked] { return check(*checked); });

  const auto searched = std::make_shared<WorstOptions>();
  auto worst = tool.command("worst", "search for the input at which each generated kernel rounds worst");
  worst.option("--family", searched->family, "only this family and its variants, with every value of the input");
  worst.option("--degree", searched->degree, "only this degree");
  worst.option("--evaluations", searched->evaluations, "of each of the four climbs of a search")
      .within(1, 100'000'000)
      .with_default();
  worst.option("--exhaustive", searched->exhaustive, "try every float, for kernels of one variable");
  worst.run([searched] { return searched->exhaustive ? try_every_float(*searched) : search_all(*searched); });
}

}  // namespace sh::numeric
