// shcheck eval: one reference value of Y_lm.
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/reference.hpp"

namespace sh::numeric {
namespace {

struct Options {
  int degree = 0;
  int order = 0;
  std::string direction;
  int digits = 0;
};

std::array<std::string, 3> split_direction(const std::string& text) {
  const auto first = text.find(',');
  const auto second = first == std::string::npos ? first : text.find(',', first + 1);
  if (second == std::string::npos || text.find(',', second + 1) != std::string::npos) {
    throw std::invalid_argument("--direction: '" + text + "' must be three numbers x,y,z separated by commas");
  }
  return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

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
    print(reference_value(options->degree, options->order, split_direction(options->direction), options->digits) +
          "\n");
  });
}

}  // namespace sh::numeric
