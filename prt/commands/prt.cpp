// The tool `prt`: bakes, relights and renders. Exit: 0 done, 1 a check found a difference, 2 bad input, 130
// interrupted.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "numeric/output/progress.hpp"
#include "prt/commands/commands.hpp"

namespace {

void add_commands(CLI::App& tool) {
  using namespace sh::prt;
  tool.require_subcommand(1);
  tool.option_defaults()->always_capture_default();
  for (const auto add :
       {add_bake_command, add_relight_command, add_render_command, add_shader_command, add_info_command,
        add_project_command, add_plan_command, add_reconstruct_command, add_study_command, add_compare_command}) {
    add(tool);
  }
}

int run(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is then an error of write(), reported like a full disk
  sh::output::stop_on_interrupt();
  CLI::App tool("Precomputed radiance transfer with spherical harmonics: bake, relight, render.", "prt");
  add_commands(tool);
  try {
    tool.parse(argc, argv);  // runs the command
    return 0;
  } catch (const CLI::Success& done) {  // --help
    return tool.exit(done);
  } catch (const CLI::ParseError& error) {
    if (!tool.get_subcommands().empty()) throw;
    std::fprintf(
        stderr,
        "prt: expected a command (bake, relight, render, shader, info, project, reconstruct, plan, study or compare), "
        "got `%s`\n",
        argc > 1 ? argv[1] : "");
    return 2;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const sh::output::Interrupted& stop) {
    std::fprintf(stderr, "prt: %s\n", stop.what());
    return 130;
  } catch (const sh::prt::CheckFailed& difference) {
    std::fprintf(stderr, "prt: %s\n", difference.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "prt: %s\n", error.what());
    return 2;
  }
}
