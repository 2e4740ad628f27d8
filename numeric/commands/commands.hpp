// The commands of the tool `shcheck`, one file each: options in, results on standard output, progress and messages on
// standard error. An error is an exception with one line.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace sh::numeric {

// What `shcheck` exits with.
enum ExitCode {
  kDone = 0,
  kDifferent = 1,  // a check found a difference
  kBadInput = 2,
  kInterrupted = 130,
};

// Each adds its subcommand; parsing the command line then runs it and sets `exit_code`, which has to live until then.
void add_kernels_command(CLI::App& tool, int& exit_code);
void add_worst_command(CLI::App& tool, int& exit_code);
void add_eval_command(CLI::App& tool, int& exit_code);
void add_legendre_command(CLI::App& tool, int& exit_code);
void add_rotation_command(CLI::App& tool, int& exit_code);
void add_gaunt_command(CLI::App& tool, int& exit_code);
void add_cap_command(CLI::App& tool, int& exit_code);
void add_identify_command(CLI::App& tool, int& exit_code);
void add_plot_command(CLI::App& tool, int& exit_code);
void add_rotation_matrix_command(CLI::App& tool, int& exit_code);
void add_report_command(CLI::App& tool, int& exit_code);
void add_advise_command(CLI::App& tool, int& exit_code);

// Standard output; throws std::runtime_error when it cannot take the text (a full disk, say).
void print(const std::string& text);

// "shcheck: line" on standard error.
void say(const std::string& line);

}  // namespace sh::numeric
