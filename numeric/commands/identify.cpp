// shcheck identify: which convention a table of someone's values follows, or what is wrong with it.
#include "numeric/identify/identify.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string file;
  int directions = 0;
  bool normalise = false;
  bool all = false;
  bool json = false;
};

ExitCode run(const Options& options) {
  const auto table = identify::read_table(options.file);
  const auto result = identify::identify(identify::read_samples(table, options.normalise));
  print(options.json ? format_json(result) : format_text(result, options.all));
  return result.recognised() ? kDone : kDifferent;
}

}  // namespace

void add_identify_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("identify", "name the convention of a table of your own values");
  auto* file = command->add_option("file", options->file, "CSV: x,y,z,v0,v1,..., a direction a line");
  auto* directions = command->add_option("--directions", options->directions, "print so many directions to fill in");
  directions->excludes(file);
  command->add_flag("--normalise", options->normalise, "scale directions to length 1");
  command->add_flag("--all", options->all, "list every reading that fits, not presets alone");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, file, directions, &exit_code] {
    if (directions->count() > 0) return print(identify::suggested_directions(options->directions));
    if (file->count() == 0) throw std::invalid_argument("identify: it needs FILE or --directions N");
    exit_code = run(*options);
  });
}

}  // namespace sh::numeric
