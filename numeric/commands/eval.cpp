// shcheck eval: one reference value of Y_lm.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/commands/split_numbers.hpp"
#include "numeric/reference.hpp"

namespace sh::numeric {
namespace {

struct Options {
  int degree = 0;
  int order = 0;
  std::string direction;
  int digits = 0;
};

}  // namespace

void add_eval_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command =
      tool.add_subcommand("eval", "print a reference value of Y_lm, orthonormal, without Condon-Shortley phase");
  command->add_option("--degree", options->degree, "l, 0 to 10000")->required();
  command->add_option("--order", options->order, "m, -l to l")->required();
  command->add_option("--direction", options->direction, "x,y,z: decimals, taken exactly; of any length but zero")
      ->required();
  command->add_option("--digits", options->digits, "significant decimals, 1 to 10000")->required();
  command->callback([options] {
    const auto direction = split_numbers<3>("--direction", options->direction, "three numbers x,y,z");
    print(reference_value(options->degree, options->order, direction, options->digits) + "\n");
  });
}

}  // namespace sh::numeric
