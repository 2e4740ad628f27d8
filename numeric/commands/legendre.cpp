// shcheck legendre: one reference value of an associated Legendre function.
#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/reference/legendre_reference.hpp"

namespace sh::numeric {
namespace {

struct Options {
  int degree = 0;
  int order = 0;
  std::string z;
  std::string theta;
  int digits = 0;
};

Colatitude colatitude(const Options& options) {
  if (options.z.empty() == options.theta.empty()) throw std::invalid_argument("give one of --z and --theta");
  if (!options.z.empty()) return {Colatitude::Kind::kCosine, "--z", options.z};
  return {Colatitude::Kind::kAngle, "--theta", options.theta};
}

}  // namespace

void add_legendre_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand(
      "legendre", "print a reference value of the orthonormal P_lm (Y_l0 = P_l0), without Condon-Shortley phase");
  command->add_option("--degree", options->degree, "l, 0 to 10000")->required();
  command->add_option("--order", options->order, "m, 0 to l")->required();
  command->add_option("--z", options->z, "cos theta: a decimal, taken exactly, -1 to 1");
  command->add_option("--theta", options->theta, "radians: a decimal, taken exactly, 0 to pi");
  command->add_option("--digits", options->digits, "significant decimals, 1 to 10000")->required();
  command->callback([options] {
    print(legendre_reference(options->degree, options->order, colatitude(*options), options->digits) + "\n");
  });
}

}  // namespace sh::numeric
