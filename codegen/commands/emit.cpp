// `shgen emit` prints the file of one kernel, in a language and a convention, with or without a mask. `shgen dump`
// prints its SSA after a stage of the pipeline.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "codegen/bound/stated.hpp"
#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"
#include "codegen/commands/commands.hpp"
#include "codegen/convention/in_convention.hpp"
#include "codegen/print/describe.hpp"
#include "symbolic/number/find_named.hpp"

namespace sh::codegen {
namespace {

struct EmitOptions {
  std::string family;
  int degree = 0;
  std::optional<int> left_degree;  // degrees of the factors of a product; empty: the degree of the result
  std::optional<int> right_degree;
  std::string language;
  std::string scalar = "float";
  std::string prefer = "speed";
  std::string recipe;  // empty: `prefer` decides
  MaskOptions mask;
  ConventionOptions convention;
};

Family family_of(const EmitOptions& options) {
  const Family& family = find_family(options.family);
  if (!options.left_degree) return family;
  if (family.of_degrees == nullptr) {
    std::string known;
    for (const Family& other : families()) {
      if (other.of_degrees != nullptr) known += (known.empty() ? "" : ", ") + other.name;
    }
    throw std::invalid_argument("--degree-left: expected family " + known + ", got " + family.name);
  }
  return family.of_degrees(*options.left_degree, *options.right_degree, options.degree);
}

FinishedKernel by_recipe(const Family& family, const EmitOptions& options) {
  FinishedKernel finished = finish_kernel(family, find_recipe(family, options.degree, options.recipe), options.degree);
  finished.kernel.arguments += " --recipe " + options.recipe;
  return finished;
}

FinishedKernel by_preference(const Family& family, const EmitOptions& options) {
  const Prefer prefer = find_preference(options.prefer);
  FinishedKernel finished = options.mask.empty() ? preferred_kernel(family, options.degree, prefer)
                                                 : masked_kernel(family, options.degree, prefer, options.mask);
  if (options.convention.empty()) return finished;
  return in_convention(finished, family.reference(options.degree, kReferencePoints), options.convention);
}

void emit(const EmitOptions& options) {
  const Language& language = find_language(options.language);
  const Family family = family_of(options);
  FinishedKernel finished = options.recipe.empty() ? by_preference(family, options) : by_recipe(family, options);
  bound::state_errors(finished);
  std::cout << language.print_kernel(finished, find_scalar(options.scalar));
}

// "basis_l4" -> the stages of family basis at degree 4.
std::vector<Stage> stages_of(const std::string& kernel) {
  const std::size_t split = kernel.rfind("_l");
  const std::string digits = split == std::string::npos ? "" : kernel.substr(split + 2);
  if (digits.empty() || digits.size() > 3 || digits.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("unknown kernel '" + kernel + "': expected FAMILY_lDEGREE such as basis_l4");
  }
  const Family& family = find_family(kernel.substr(0, split));
  const int degree = std::stoi(digits);
  return kernel_stages(family, fastest_recipe(family, degree), degree);
}

void dump(const std::string& stage, const std::string& kernel) {
  std::cout << print::dump(symbolic::find_named(stages_of(kernel), stage, "stage").kernel);
}

void add_mask_options(CLI::App& command, MaskOptions& mask) {
  command.add_option(
      "--left", mask.left,
      "Symmetries of the first coefficient array, e.g. zonal or mirror-x,mirror-y, or its nonzero entries, e.g. 0,2,6");
  command.add_option("--right", mask.right, "The same of the second coefficient array");
  command.add_option("--keep-bands", mask.keep_bands, "Degrees l to keep (all others are zero), e.g. 0,1,2,4")
      ->delimiter(',');
  command
      .add_option("--keep-orders", mask.keep_orders,
                  "Orders m to keep (all others are zero), e.g. --keep-orders=-2,0,2")
      ->delimiter(',');
  command.add_option("--outputs", mask.outputs, "Wanted results: a symmetry or a list of entries, e.g. 0,2,6");
}

}  // namespace

void add_emit_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<EmitOptions>();
  CLI::App* const command = tool.add_subcommand("emit", "Print the file of one kernel");
  command->add_option("family", options->family, "Family, e.g. basis")->required();
  command->add_option("--degree", options->degree, "Largest degree l")->required();
  command->add_option("--lang", options->language, "Language: cpp, glsl, glsl-es, hlsl or c99")->required();
  command->add_option("--scalar", options->scalar,
                      "Scalar type: float or double (C++ code takes it as a template parameter)");
  command->add_option("--prefer", options->prefer, "Quality that decides among the recipes: speed, accuracy or size");
  auto* left = command->add_option("--degree-left", options->left_degree, "Degree of the left factor of a product");
  auto* right = command->add_option("--degree-right", options->right_degree, "Degree of the right factor of a product");
  left->needs(right);
  right->needs(left);
  command->add_option("--convention", options->convention.convention, "Convention of arrays, e.g. directxmath, unity");
  command->add_option("--axes", options->convention.axes,
                      "Coordinates of the convention in terms of the caller's, e.g. x,z,-y");
  add_mask_options(*command, options->mask);
  command->add_option("--recipe", options->recipe, "Name of the recipe; replaces the choice by --prefer")
      ->excludes("--prefer", "--convention", "--axes", "--left", "--right", "--keep-bands", "--keep-orders",
                 "--outputs");
  command->callback([options, &exit_code] {
    emit(*options);
    exit_code = kDone;
  });
}

void add_dump_command(CLI::App& tool, int& exit_code) {
  const auto stage = std::make_shared<std::string>();
  const auto kernel = std::make_shared<std::string>();
  CLI::App* const command = tool.add_subcommand("dump", "Print the SSA of a kernel after a stage of the pipeline");
  command->add_option("stage", *stage, "Stage: recipe, share, factor, fold, prune, associate or schedule")->required();
  command->add_option("kernel", *kernel, "Kernel, e.g. basis_l4")->required();
  command->callback([stage, kernel, &exit_code] {
    dump(*stage, *kernel);
    exit_code = kDone;
  });
}

}  // namespace sh::codegen
