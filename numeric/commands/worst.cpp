// shcheck worst: the worst input of every generated kernel, by search, or among all floats where there is one variable.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/kernels/exhaustive.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/kernels/kernel_search.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string family;
  std::optional<int> degree;
  std::size_t evaluations = 2000;
  bool exhaustive = false;

  // Whether to show a kernel of this family or of a variant of it.
  [[nodiscard]] bool wants(const std::string& of, int its_degree) const {
    return (family.empty() || family == of || family == without_variant(of)) && (!degree || *degree == its_degree);
  }
};

// A line a kernel and scalar; false if the error is beyond `allowed`.
bool print_line(const std::string& name, const std::string& scalar, double error, double allowed,
                const std::string& where) {
  const bool kept = error <= allowed;
  print(
      fmt::format("{:<30} {:<6} {:>9.3g} eps{}  {}\n", name, scalar, error, kept ? "" : " (beyond its limit)", where));
  return kept;
}

template <class T>
bool search(const BoundKernel& kernel, const FamilyCheck& check, const Options& options) {
  const KernelResult found = search_kernel<T>(kernel, check, {4, options.evaluations, 1});
  const auto limits = limits_for(kernel.family, kernel.degree, found.scalar);
  std::string where = found.worst_rounding.output + " at";
  constexpr std::size_t kMostShown = 6;
  const auto& values = found.worst_rounding.values;
  const std::size_t shown = options.family.empty() ? std::min(kMostShown, values.size()) : values.size();
  for (std::size_t i = 0; i < shown; ++i) where += fmt::format(" {:.17g}", values[i]);
  if (shown < values.size()) where += " ... (--family shows all)";
  return print_line(kernel.name(), found.scalar, found.rounding.scaled().max(),
                    limits ? kSearchedLimit * limits->rounding : 0, where);
}

ExitCode search_all(const Options& options) {
  bool kept = true;
  std::size_t count = 0;
  for (const BoundKernel& kernel : bound_kernels()) {
    const FamilyCheck* const check = find_check(kernel.family);
    if (check == nullptr || !options.wants(kernel.family, kernel.degree)) continue;
    ++count;
    kept = search<float>(kernel, *check, options) && kept;
    kept = search<double>(kernel, *check, options) && kept;
  }
  if (count == 0) throw std::invalid_argument("worst: no such kernel; `shcheck kernels` lists families and degrees");
  return kept ? kDone : kDifferent;
}

ExitCode try_every_float(const Options& options) {
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
        "worst: --exhaustive is for kernels of one variable, cap and window_hann, "
        "window_gaussian, window_laplacian");
  }
  return kept ? kDone : kDifferent;
}

}  // namespace

void add_worst_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("worst", "search for the input at which each generated kernel rounds worst");
  command->add_option("--family", options->family, "only this family and its variants, with every value of the input");
  command->add_option("--degree", options->degree, "only this degree");
  command->add_option("--evaluations", options->evaluations, "of each of the four climbs of a search")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  command->add_flag("--exhaustive", options->exhaustive, "try every float, for kernels of one variable");
  command->callback(
      [options, &exit_code] { exit_code = options->exhaustive ? try_every_float(*options) : search_all(*options); });
}

}  // namespace sh::numeric
