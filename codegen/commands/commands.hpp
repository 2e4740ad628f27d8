// The commands of the tool `shgen`.
//
// Input: options. Output: results on standard output, progress on standard error. A command reports an error by an
// exception with one line.
#pragma once

namespace CLI {
class App;
}

namespace sh::codegen {

/// The exit codes of `shgen`.
enum ExitCode {
  kDone = 0,
  kDifferent = 1,  ///< `check` found a difference, `prove` a false identity, `errata` a false verdict, `tune` a loser
  kBadInput = 2,
};

/// Each function adds its subcommand to the tool. Parsing the command line then runs the subcommand and sets
/// `exit_code`, which has to live until then.
void add_write_command(CLI::App& tool, int& exit_code);
void add_check_command(CLI::App& tool, int& exit_code);
void add_list_command(CLI::App& tool, int& exit_code);
void add_tune_command(CLI::App& tool, int& exit_code);
void add_emit_command(CLI::App& tool, int& exit_code);
void add_dump_command(CLI::App& tool, int& exit_code);
void add_bound_command(CLI::App& tool, int& exit_code);
void add_prove_command(CLI::App& tool, int& exit_code);
void add_errata_command(CLI::App& tool, int& exit_code);
void add_typeset_commands(CLI::App& tool, int& exit_code);

}  // namespace sh::codegen
