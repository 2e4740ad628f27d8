// The command line of the tool `prt`: all commands, `--version`, and errors as one line.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <string_view>

#include "numeric/output/log.hpp"
#include "numeric/output/machine_error.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/output/version.hpp"
#include "prt/commands/commands.hpp"
#include "prt/commands/large_arrays.hpp"

namespace {

struct Command {
  std::string_view name;
  void (*add)(CLI::App&);
};

constexpr Command kCommands[] = {{"bake", sh::prt::add_bake_command},
                                 {"merge", sh::prt::add_merge_command},
                                 {"shards", sh::prt::add_shards_command},
                                 {"volume", sh::prt::add_volume_command},
                                 {"translucent", sh::prt::add_translucent_command},
                                 {"relight", sh::prt::add_relight_command},
                                 {"render", sh::prt::add_render_command},
                                 {"shader", sh::prt::add_shader_command},
                                 {"fix-view", sh::prt::add_fix_view_command},
                                 {"info", sh::prt::add_info_command},
                                 {"project", sh::prt::add_project_command},
                                 {"plan", sh::prt::add_plan_command},
                                 {"reconstruct", sh::prt::add_reconstruct_command},
                                 {"light-at", sh::prt::add_light_at_command},
                                 {"probes", sh::prt::add_probes_command},
                                 {"lightmap", sh::prt::add_lightmap_command},
                                 {"study", sh::prt::add_study_command},
#if defined(SHFORGE_EMIT)
                                 {"emit", sh::prt::add_emit_command},
#endif
                                 {"view", sh::prt::add_view_command},
                                 {"grid", sh::prt::add_grid_command},
                                 {"export", sh::prt::add_export_command},
                                 {"import", sh::prt::add_import_command},
                                 {"compare", sh::prt::add_compare_command},
                                 {"splats", sh::prt::add_splats_command}};

// The command that the first word names, or all of them, for the help and for messages.
void add_commands(std::string_view first_word, CLI::App& tool) {
  tool.require_subcommand(1);
  tool.option_defaults()->always_capture_default();
  const auto* named = std::find_if(std::begin(kCommands), std::end(kCommands),
                                   [&](const Command& command) { return command.name == first_word; });
  if (named != std::end(kCommands)) {
    named->add(tool);
    return;
  }
  for (const Command& command : kCommands) command.add(tool);
}

// Refuses what CLI11 takes for numbers: nan, inf, and what exceeds single precision.
std::string flaw_of_number(const std::string& text) {
  const double value = std::strtod(text.c_str(), nullptr);
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())
             ? ""
             : "expected a finite number, got " + text;
}

// Numbers are finite; behind the values of an option that takes so many, `--at 1,2,3`, stands what belongs to the command.
void settle_options(CLI::App& tool) {
  for (CLI::App* command : tool.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      if (option->get_type_name().starts_with("FLOAT")) option->check(flaw_of_number);
      if (option->get_items_expected_max() < CLI::detail::expected_max_vector_size) option->allow_extra_args(false);
    }
    settle_options(*command);
  }
}

// `--log` and `--scratch` of every command that does something.
void add_common_options(CLI::App& tool) {
  for (CLI::App* command : tool.get_subcommands({})) {
    add_common_options(*command);
    if (!command->get_subcommands({}).empty()) continue;
    command
        ->add_option_function<std::string>(
            "--scratch", [](const std::string& folder) { sh::prt::use_scratch(folder); },
            "folder on a disk for large arrays, for work that is larger than memory; default: memory")
        ->default_str("")
        ->trigger_on_parse();
    command
        ->add_option_function<std::string>(
            "--log",
            [](const std::string& format) {
              sh::output::set_log_format(format == "json" ? sh::output::LogFormat::kJson
                                                          : sh::output::LogFormat::kText);
            },
            "text or json: progress and messages on standard error as lines for people, or as one JSON object a line")
        ->check(CLI::IsMember({"text", "json"}))
        ->default_str("text")
        ->trigger_on_parse();  // so that errors of other options are in this format, too
  }
}

// "bake, relight or render"
std::string command_names(CLI::App& tool) {
  const std::vector<CLI::App*> commands = tool.get_subcommands({});
  std::string names;
  for (const CLI::App* command : commands) {
    names += (names.empty() ? "" : command == commands.back() ? " or " : ", ") + command->get_name();
  }
  return names;
}

int run(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is then an error of write(), reported like a full disk
  sh::output::stop_on_interrupt();
  sh::output::set_log_format(sh::output::LogFormat::kText);
  CLI::App tool("Precomputed radiance transfer with spherical harmonics: bake, relight, render.", "prt");
  tool.set_version_flag("--version", sh::output::version_of("prt"));
  add_commands(argc > 1 ? argv[1] : "", tool);
  add_common_options(tool);
  settle_options(tool);
  if (argc == 1) {
    std::fputs(tool.help().c_str(), stderr);
    return 2;
  }
  try {
    tool.parse(argc, argv);  // runs the command
    return 0;
  } catch (const CLI::Success& done) {  // --help, --version
    return tool.exit(done);
  } catch (const CLI::ParseError& error) {
    if (!tool.get_subcommands().empty()) throw;
    const std::string got = argc > 1 ? argv[1] : "";
    sh::output::log_line("error", "prt: ", "expected a command (" + command_names(tool) + "), got `" + got + "`");
    return 2;
  }
}

}  // namespace

namespace sh::prt {

int tell_error(const std::exception_ptr& error) {
  const auto failed = [](std::string_view line, int status) {
    output::log_line("error", "prt: ", line);
    return status;
  };
  try {
    std::rethrow_exception(error);
  } catch (const output::Interrupted& stop) {
    return failed(stop.what(), 130);
  } catch (const CheckFailed& difference) {
    return failed(difference.what(), 1);
  } catch (const output::MachineError& machine) {
    return failed(machine.what(), kRetry);
  } catch (const ScratchFull& full) {
    return failed(full.what(), kRetry);
  } catch (const std::bad_alloc&) {
    return failed("this machine has too little memory for it", kRetry);
  } catch (const std::exception& other) {
    return failed(other.what(), 2);
  }
}

int run_tool(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception&) {
    return tell_error(std::current_exception());
  }
}

}  // namespace sh::prt
