// shgen: writes, checks and shows the generated kernels.
//
//   shgen write [FAMILY...] [--out DIR]              write the files of generated/ that differ
//   shgen check [FAMILY...] [--dir DIR]              compare generated/ with the output of the generator
//   shgen list [FAMILY...] [--table [--degree N,...]]  list kernels and recipes: operations, errors, times, files
//   shgen tune [FAMILY...] [--degree N] [--out FILE] [--check]  measure the recipes, so that `write` takes the fastest
//   shgen emit FAMILY --degree N --lang cpp|glsl|glsl-es|hlsl|c99 [--scalar float|double]
//                     [--prefer speed|accuracy|size | --recipe NAME]  print the file of one kernel
//                     [--left S] [--right S] [--keep-bands L,...] [--keep-orders=M,...] [--outputs S|I,...]
//                                                    leave out known zeros and unwanted results
//                     [--degree-left A --degree-right B]  a product of factors of these degrees
//   shgen dump STAGE KERNEL                          print the SSA of a kernel after a stage: dump share basis_l4
//   shgen bound FAMILY --degree N --scalar half|float|double   prove a bound of the kernel's rounding error
//   shgen prove [NAME...] [--degree L] [--json FILE] prove every identity of symbolic/, or the named ones
//   shgen errata [ID|SOURCE...] [--verdict V] [--json FILE]  decide every formula of the sources exactly
//   shgen tex|markdown FAMILY --degree N [--convention C]  print formulas of symbolic/
//
// Exit codes: 0 done; 2 bad input; 1 `check` found a difference, `prove` a false identity, `errata` a false verdict or
// `tune --check` a slow choice.
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "codegen/commands/commands.hpp"
#include "numeric/output/printable.hpp"
#include "numeric/output/version.hpp"

namespace {

using namespace sh::codegen;

void add_commands(CLI::App& tool, int& exit_code) {
  tool.require_subcommand(0, 1);
  add_write_command(tool, exit_code);
  add_check_command(tool, exit_code);
  add_list_command(tool, exit_code);
  add_tune_command(tool, exit_code);
  add_emit_command(tool, exit_code);
  add_dump_command(tool, exit_code);
  add_bound_command(tool, exit_code);
  add_prove_command(tool, exit_code);
  add_errata_command(tool, exit_code);
  add_typeset_commands(tool, exit_code);
}

int run(int argc, char** argv) {
  CLI::App tool{"Writes, checks and shows the generated spherical-harmonics kernels."};
  int exit_code = kDone;
  tool.set_version_flag("--version", sh::output::version_of("shgen"));
  add_commands(tool, exit_code);
  try {
    tool.parse(argc, argv);                // runs the command
  } catch (const CLI::Success& request) {  // --help, --version
    return tool.exit(request);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  if (tool.get_subcommands().empty()) {
    throw std::invalid_argument(
        "no command: expected one of: write, check, list, tune, emit, dump, bound, prove, errata, tex, markdown");
  }
  if (!std::cout.flush())
    throw std::runtime_error("standard output: expected a writable file with enough space, got an error");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "shgen: " << sh::output::printable(error.what()) << '\n';
    return kBadInput;
  }
}
