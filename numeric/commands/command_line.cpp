#include "numeric/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <type_traits>

#include "numeric/output/printable.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/output/version.hpp"

namespace sh::numeric {

namespace {

// Refuses what CLI11 takes for numbers: nan and inf.
std::string flaw_of_number(const std::string& text) {
  return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "expected a finite number, got " + text;
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::with_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

Option& Option::positive() {
  option_->check(CLI::PositiveNumber);
  return *this;
}

Option& Option::within(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

bool Option::given() const { return option_->count() > 0; }

Command Command::command(const std::string& name, const std::string& help) {
  return {app_->add_subcommand(name, help), exit_code_};
}

void Command::require_command() { app_->require_subcommand(1); }

template <class T>
Option Command::option(const std::string& names, T& value, const std::string& help) {
  if constexpr (std::is_same_v<T, bool>) {
    return Option(app_->add_flag(names, value, help));
  } else {
    CLI::Option* const option = app_->add_option(names, value, help);
    if constexpr (std::is_same_v<T, double>) option->check(flaw_of_number);
    return Option(option);
  }
}

template Option Command::option(const std::string&, bool&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);
template Option Command::option(const std::string&, double&, const std::string&);
template Option Command::option(const std::string&, std::size_t&, const std::string&);
template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::optional<int>&, const std::string&);

void Command::run(const std::function<ExitCode()>& action) {
  app_->callback([action, code = exit_code_] { *code = action(); });
}

int run_tool(int argc, char** argv, const std::string& help, const std::function<void(Command&)>& add_commands) {
  CLI::App app(help, "shcheck");
  int exit_code = kDone;
  Command tool(&app, &exit_code);
  app.set_version_flag("--version", output::version_of("shcheck"));
  tool.require_command();
  try {
    add_commands(tool);
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const output::Interrupted& stop) {
    say(stop.what());
    return kInterrupted;
  } catch (const std::exception& error) {
    say(error.what());
    return kBadInput;
  }
}

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error("standard output: cannot be written");
  }
}

void say(const std::string& line) { std::fprintf(stderr, "shcheck: %s\n", output::printable(line).c_str()); }

}  // namespace sh::numeric
