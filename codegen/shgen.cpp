// shgen: writes, checks and shows the generated kernels.
//
//   shgen write [FAMILY...] [--out DIR]              write generated/ (unchanged files are left alone)
//   shgen check [FAMILY...] [--dir DIR]              compare generated/ with what would be written
//   shgen list [FAMILY...]                           kernels and recipes: operations, measured error, time, files
//   shgen tune [FAMILY...] [--degree N] [--out FILE] [--check]  measure the recipes, so that `write` takes the fastest
//   shgen emit FAMILY --degree N --lang cpp|glsl|glsl-es|hlsl|c99 [--scalar float|double]
//                     [--prefer speed|accuracy|size | --recipe NAME]  print one kernel's file
//                     [--left S] [--right S] [--keep-bands L,...] [--keep-orders=M,...] [--outputs S|I,...]
//                                                   without what these say is zero or not wanted (codegen/choose/mask.hpp)
//                     [--degree-left A --degree-right B]  of a product: factors of these degrees, a result of degree N
//   shgen dump STAGE KERNEL                          print the SSA of a kernel after a stage: dump share basis_l4
//   shgen prove [NAME...] [--degree L] [--json FILE] prove every identity of symbolic/, or those named
//   shgen errata [ID|SOURCE...] [--verdict V] [--json FILE]  formulas of the sources, each decided exactly
//   shgen tex|markdown FAMILY --degree N [--convention C]  formulas of symbolic/, typeset
//
// Exit: 0 done, 1 `check` found a difference, `prove` a false identity or `errata` a false verdict, 2 bad input.
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "codegen/commands/commands.hpp"

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
  add_prove_command(tool, exit_code);
  add_errata_command(tool, exit_code);
  add_typeset_commands(tool, exit_code);
}

int run(int argc, char** argv) {
  CLI::App tool{"Writes, checks and shows the generated spherical-harmonics kernels."};
  int exit_code = kDone;
  add_commands(tool, exit_code);
  try {
    tool.parse(argc, argv);                // runs the command
  } catch (const CLI::Success& request) {  // --help
    return tool.exit(request);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  if (tool.get_subcommands().empty()) {
    throw std::invalid_argument(
        "no command; it should be one of: write, check, list, tune, emit, dump, prove, errata, tex, markdown");
  }
  if (!std::cout.flush()) throw std::runtime_error("standard output: cannot be written; the disk should have space");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "shgen: " << error.what() << '\n';
    return kBadInput;
  }
}
