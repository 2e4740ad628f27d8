// shcheck eval: one reference value of Y_lm, or of its gradient.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/commands/split_numbers.hpp"
#include "numeric/reference/reference.hpp"

namespace sh::numeric {
namespace {

struct Options {
  int degree = 0;
  int order = 0;
  std::string direction;
  int digits = 0;
  bool gradient = false;
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
  command->add_flag("--gradient", options->gradient,
                    "d/dx, d/dy, d/dz of the homogeneous form r^l Y_lm at x,y,z scaled to length 1, a line each");
  command->callback([options] {
    const auto direction = split_numbers<3>("--direction", options->direction, "three numbers x,y,z");
    if (!options->gradient) {
      print(reference_value(options->degree, options->order, direction, options->digits) + "\n");
      return;
    }
    const auto [x, y, z] = reference_gradient(options->degree, options->order, direction, options->digits);
    print(x + "\n" + y + "\n" + z + "\n");
  });
}

}  // namespace sh::numeric
