// Commands and their options: the part of CLI11 that shcheck needs. Only command_line.cpp compiles the headers of CLI11;
// each file that does takes 2 s longer.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sh::numeric {

/// The exit codes of `shcheck`.
enum ExitCode {
  kDone = 0,
  kDifferent = 1,  ///< a check found a difference
  kBadInput = 2,
  kInterrupted = 130,
};

class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option& required();
  /// The help shows the present value of the variable.
  Option& with_default();
  Option& one_of(const std::vector<std::string>& words);
  Option& positive();
  Option& within(int least, int most);
  Option& excludes(const Option& other);
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
};

class Command {
 public:
  Command(CLI::App* app, int* exit_code) : app_(app), exit_code_(exit_code) {}
  Command command(const std::string& name, const std::string& help);
  void require_command();

  /// The parser stores into `value`, which must live until the command runs. T: bool (a flag), int, double, size_t,
  /// std::string, std::optional<int>.
  template <class T>
  Option option(const std::string& names, T& value, const std::string& help);

  /// `action` returns the exit code.
  void run(const std::function<ExitCode()>& action);

 private:
  CLI::App* app_;
  int* exit_code_;
};

/// Parses the command line of shcheck and runs the command. An error is one line on standard error. Returns the exit
/// code.
int run_tool(int argc, char** argv, const std::string& help, const std::function<void(Command&)>& add_commands);

/// Writes to standard output. Throws std::runtime_error if that fails (a full disk, for example).
void print(const std::string& text);

/// "shcheck: line" on standard error.
void say(const std::string& line);

}  // namespace sh::numeric
