// shcheck: the oracle at the command line.
//
//   shcheck kernels [--family NAME] [--json FILE] [--generated DIR]    every generated kernel against the oracle
//   shcheck eval --degree L --order M --direction x,y,z --digits D     one reference value
// Results on standard output, progress and messages on standard error. Exit: 0 done, 1 a kernel differs or exceeds its
// limit, 2 bad input.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "numeric/kernel_check.hpp"
#include "numeric/kernel_limits.hpp"
#include "numeric/reference.hpp"
#include "numeric/report.hpp"

namespace {

struct Options {
  std::string generated = SHFORGE_GENERATED_DIR;
  std::string family;
  std::string json_file;
  int degree = 0;
  int order = 0;
  std::string direction;
  int digits = 0;
};

void say(const std::string& line) { std::fprintf(stderr, "shcheck: %s\n", line.c_str()); }

// Throws std::runtime_error when standard output cannot take the text (a full disk, say).
void print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
    throw std::runtime_error("standard output: cannot be written");
  }
}

int run_kernels(const Options& options) {
  const auto results = sh::numeric::check_kernels({options.generated, options.family}, say);
  std::vector<std::string> failures;
  for (const auto& kernel : sh::numeric::unchecked_kernels(sh::numeric::bound_kernels())) {
    failures.push_back(kernel + ": no check describes its family");
  }
  for (const auto& result : results) {
    for (auto& failure : failures_of(result)) failures.push_back(std::move(failure));
  }
  print(options.family.empty() ? format_summary(results) : format_details(results));
  if (!options.json_file.empty()) sh::numeric::write_file(options.json_file, format_json(results, failures));
  for (const auto& failure : failures) say(failure);
  return failures.empty() ? 0 : 1;
}

std::array<std::string, 3> split_direction(const std::string& text) {
  const auto first = text.find(',');
  const auto second = first == std::string::npos ? first : text.find(',', first + 1);
  if (second == std::string::npos || text.find(',', second + 1) != std::string::npos) {
    throw std::invalid_argument("--direction: '" + text + "' must be three numbers x,y,z separated by commas");
  }
  return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

int run_eval(const Options& options) {
  print(
      sh::numeric::reference_value(options.degree, options.order, split_direction(options.direction), options.digits) +
      "\n");
  return 0;
}

void describe(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  auto* kernels = app.add_subcommand("kernels", "compare every generated kernel with the oracle");
  kernels->add_option("--family", options.family, "only this family and its variants, a line a language and scalar");
  kernels->add_option("--json", options.json_file, "also write the results to this file");
  kernels->add_option("--generated", options.generated, "the folder generated/ whose GLSL files are run")
      ->capture_default_str();
  auto* eval =
      app.add_subcommand("eval", "print a reference value of Y_lm, orthonormal, without Condon-Shortley phase");
  eval->add_option("--degree", options.degree, "l, 0 to 10000")->required();
  eval->add_option("--order", options.order, "m, -l to l")->required();
  eval->add_option("--direction", options.direction, "x,y,z: decimals, taken exactly; of any length but zero")
      ->required();
  eval->add_option("--digits", options.digits, "significant decimals, 1 to 10000")->required();
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Checks spherical-harmonics kernels against a multiprecision oracle", "shcheck");
  describe(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    throw;
  }
  return app.got_subcommand("eval") ? run_eval(options) : run_kernels(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shcheck: %s\n", error.what());
    return 2;
  }
}
