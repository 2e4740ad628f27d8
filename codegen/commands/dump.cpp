// `shgen dump`: the SSA of a kernel after a stage of the pipeline.
#include "codegen/print/describe.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "codegen/choose/catalogue.hpp"
#include "codegen/commands/commands.hpp"

namespace sh::codegen {
namespace {

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
  std::string known;
  for (const Stage& s : stages_of(kernel)) {
    if (s.name == stage) {
      std::cout << print::dump(s.kernel);
      return;
    }
    known += (known.empty() ? "" : ", ") + s.name;
  }
  throw std::invalid_argument("unknown stage '" + stage + "': expected one of: " + known);
}

}  // namespace

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
