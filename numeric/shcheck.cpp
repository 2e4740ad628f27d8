// shcheck: the oracle at the command line.
//
//   shcheck kernels [--family NAME] [--json FILE] [--generated DIR]    every generated kernel against the oracle
//   shcheck worst [--family NAME] [--degree N] [--evaluations N]       the input at which each errs most, by search
//   shcheck worst --exhaustive                                         the same among all floats, for one variable
//   shcheck eval --degree L --order M --direction x,y,z --digits D [--gradient]    a reference value
//   shcheck legendre --degree L --order M (--z Z | --theta T) --digits D
//   shcheck rotation --degree L (--matrix R | --quaternion Q | --euler A | --axis V --angle A) --digits D
//                    [--row M --column N] [--format text|csv|json]     D_l, or an entry
//   shcheck gaunt --degrees a,b,c --orders m,n,p --digits D [--complex]
//   shcheck cap --degree L (--angle A | --one-minus-cos V) --digits D
//   shcheck identify FILE | --directions N                             the convention of a table of values
//   shcheck plot lobes|map ... -o FILE.svg|.png                        a picture of a function on the sphere
//   shcheck rotation-matrix FILE | --rotations N                       the same of rotation matrices, and their errors
//   shcheck report --out DIR [--quick] [--task TASK]                  error against run time, a page and JSON
//   shcheck advise --task TASK --degree L --error E ...                which method to take
//
// Results on standard output, progress and messages on standard error. Exit: 0 done, 1 a check found a difference, 2
// bad input, 130 interrupted.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "numeric/commands/commands.hpp"
#include "numeric/output/progress.hpp"

namespace sh::numeric {

void say(const std::string& line) { std::fprintf(stderr, "shcheck: %s\n", line.c_str()); }

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error("standard output: cannot be written");
  }
}

namespace {

void add_commands(CLI::App& tool, int& exit_code) {
  tool.require_subcommand(1);
  add_kernels_command(tool, exit_code);
  add_worst_command(tool, exit_code);
  add_eval_command(tool, exit_code);
  add_legendre_command(tool, exit_code);
  add_rotation_command(tool, exit_code);
  add_gaunt_command(tool, exit_code);
  add_cap_command(tool, exit_code);
  add_identify_command(tool, exit_code);
  add_plot_command(tool, exit_code);
  add_rotation_matrix_command(tool, exit_code);
  add_report_command(tool, exit_code);
  add_advise_command(tool, exit_code);
}

int run(int argc, char** argv) {
  CLI::App tool("Checks spherical-harmonics code against a multiprecision oracle", "shcheck");
  int exit_code = kDone;
  add_commands(tool, exit_code);
  try {
    tool.parse(argc, argv);             // runs the command
  } catch (const CLI::Success& done) {  // --help
    return tool.exit(done);
  }
  return exit_code;
}

}  // namespace
}  // namespace sh::numeric

int main(int argc, char** argv) {
  try {
    return sh::numeric::run(argc, argv);
  } catch (const sh::output::Interrupted& stop) {
    sh::numeric::say(stop.what());
    return sh::numeric::kInterrupted;
  } catch (const std::exception& error) {
    sh::numeric::say(error.what());
    return sh::numeric::kBadInput;
  }
}
