// `shgen bound` proves a bound of a kernel's rounding error and searches for the largest error beside it.
#include "codegen/bound/bound.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "codegen/bound/gappa.hpp"
#include "codegen/choose/catalogue.hpp"
#include "codegen/commands/commands.hpp"
#include "codegen/measure/half.hpp"
#include "codegen/measure/search.hpp"

namespace sh::codegen {
namespace {

struct BoundOptions {
  std::string family;
  int degree = 0;
  std::string scalar = "float";
  std::string recipe;   // empty: the one that `shgen write` takes
  int evaluations = 0;  // of a climb; 0: as many as for the heads of files
  bool gappa = false;
};

template <class T>
MeasuredError seen_as(const Kernel& kernel, const Family& family, const bound::Bound& proved, int evaluations) {
  return largest_seen<T>(kernel, family.domain, {proved.worst}, evaluations);
}

MeasuredError seen(const Kernel& kernel, const Family& family, const bound::Bound& proved,
                   const BoundOptions& options) {
  const int evaluations = options.evaluations > 0 ? options.evaluations : search_evaluations(kernel);
  const auto search = options.scalar == "half"    ? seen_as<Half>
                      : options.scalar == "float" ? seen_as<float>
                                                  : seen_as<double>;
  return search(kernel, family, proved, evaluations);
}

std::string both_units(double absolute, double eps) {
  return absolute > 0 ? fmt::format("{:.2g} ({:.2f} eps)", absolute, eps) : fmt::format("{:.2f} eps", eps);
}

void print_report(const Kernel& kernel, const Family& family, const bound::Bound& proved, const MeasuredError& found) {
  const Error& error = found.rounding;
  if (proved.is_proved()) {
    std::cout << "rounding at most  " << both_units(proved.absolute, proved.eps) << ", proved on " << proved.boxes
              << (proved.every_number ? " numbers, all of the domain" : " boxes") << ", with and without contraction\n";
  } else {
    std::cout << "rounding          no bound is proved: " << proved.missing << '\n';
  }
  std::cout << "largest seen      " << both_units(error.absolute, error.eps) << ", among " << found.inputs << ' '
            << family.domain.inputs << " and " << found.searched << " evaluations of a search\n";
  std::cout << "at                ";
  std::string separator;
  for (const double value : found.worst) {
    std::cout << separator << fmt::format("{:.17g}", value);
    separator = ", ";
  }
  std::cout << '\n';
  if (proved.is_proved() && error.eps > 0) {
    std::cout << fmt::format("bound / seen      {:.2f}\n", proved.eps / error.eps);
  }
  if (proved.is_proved()) std::cout << "domain            " << proved.domain << '\n';
  std::cout << "eps               machine epsilon x " << family.domain.unit << '\n';
  std::cout << "kernel            " << kernel.name << ", recipe " << kernel.recipe << '\n';
}

int print_bound(const BoundOptions& options) {
  const Family& family = find_family(options.family);
  const bound::Format& format = bound::find_format(options.scalar);
  require_degree(family, options.degree);
  const Recipe recipe = options.recipe.empty() ? fastest_recipe(family, options.degree)
                                               : find_recipe(family, options.degree, options.recipe);
  const Kernel kernel = kernel_stages(family, recipe, options.degree).back().kernel;
  const bound::Bound proved = bound::bound(kernel, family.domain, format);
  if (options.gappa) {
    std::cout << bound::gappa_script(kernel, family.domain, format, proved);
    return kDone;
  }
  print_report(kernel, family, proved, seen(kernel, family, proved, options));
  return kDone;
}

}  // namespace

void add_bound_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<BoundOptions>();
  CLI::App* const command = tool.add_subcommand("bound", "Prove a bound of the rounding error of a kernel");
  command->add_option("family", options->family, "Family, e.g. basis")->required();
  command->add_option("--degree", options->degree, "Largest degree l")->required();
  command->add_option("--scalar", options->scalar, "Scalar type: half, float or double (default: float)");
  command->add_option("--recipe", options->recipe, "Name of the recipe (default: the one that `shgen write` takes)");
  command->add_option("--evaluations", options->evaluations, "Evaluations of each of the eight climbs of the search")
      ->check(CLI::Range(1, 100'000'000));
  command->add_flag("--gappa", options->gappa, "Print a script with which Gappa proves the error on the worst box");
  command->callback([options, &exit_code] { exit_code = print_bound(*options); });
}

}  // namespace sh::codegen
