// shcheck cap: one reference coefficient of a cap.
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
  std::string angle;
  std::string one_minus_cos;
  int digits = 0;
};

Colatitude half_angle(const Options& options) {
  if (options.angle.empty() == options.one_minus_cos.empty()) {
    throw std::invalid_argument("give one of --angle and --one-minus-cos");
  }
  if (!options.angle.empty()) return {Colatitude::Kind::kAngle, "--angle", options.angle};
  return {Colatitude::Kind::kOneMinusCos, "--one-minus-cos", options.one_minus_cos};
}

}  // namespace

void add_cap_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand(
      "cap", "print the coefficient of Y_l0 of the function that is 1 in a cap about +z, 0 outside");
  command->add_option("--degree", options->degree, "l, 0 to 10000")->required();
  command->add_option("--angle", options->angle, "half-angle in radians: a decimal, taken exactly, 0 to pi");
  command->add_option("--one-minus-cos", options->one_minus_cos,
                      "1 - cos(half-angle): a decimal, taken exactly, 0 to 2; 1 is a hemisphere");
  command->add_option("--digits", options->digits, "significant decimals, 1 to 10000")->required();
  command->callback([options] { print(cap_reference(options->degree, half_angle(*options), options->digits) + "\n"); });
}

}  // namespace sh::numeric
