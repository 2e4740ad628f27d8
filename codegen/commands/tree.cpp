// `shgen write`, `shgen check` and `shgen list`: the folder generated/.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "codegen/choose/catalogue.hpp"
#include "codegen/commands/commands.hpp"
#include "codegen/commands/table.hpp"
#include "codegen/output/output_tree.hpp"

namespace sh::codegen {
namespace {

// ./generated if it exists (in a checkout), otherwise the installed folder, otherwise the folder of the source tree.
std::string default_folder() {
  if (std::filesystem::is_regular_file("generated/MANIFEST")) return "generated";
  return installed_or("include/shforge/generated", SHFORGE_GENERATED_DIR);
}

std::string chosen_folder(const std::string& wanted) { return wanted.empty() ? default_folder() : wanted; }

void report_progress(const std::string& kernel) { std::cerr << "shgen: " << kernel << '\n'; }

void ignore_progress(const std::string& /*kernel*/) {}

// The files of a command: the whole folder, or the kernels of some families in it.
struct Selection {
  std::string folder;  // empty: the default
  std::vector<std::string> families;

  [[nodiscard]] RenderedFiles render(const std::function<void(const std::string&)>& progress) const {
    return families.empty() ? render_all(progress) : render_families(families, progress);
  }
};

int write(const Selection& selection) {
  const std::string folder = chosen_folder(selection.folder);
  make_folder(folder);
  const std::vector<std::string> written = write_tree(folder, selection.render(report_progress));
  for (const std::string& name : written) std::cout << name << '\n';
  std::cerr << "shgen: " << written.size() << " files written under " << folder << '\n';
  return kDone;
}

int check(const Selection& selection) {
  const std::string folder = chosen_folder(selection.folder);
  require_existing(folder);
  const RenderedFiles rendered = selection.render(ignore_progress);
  const auto compare = selection.families.empty() ? compare_tree : compare_files;
  const std::vector<std::string> differences = compare(folder, rendered);
  for (const std::string& line : differences) std::cout << line << '\n';
  if (!differences.empty()) return kDifferent;
  std::cerr << "shgen: " << rendered.size() << " files of " << folder << " equal the output of the generator\n";
  return kDone;
}

struct ListOptions {
  std::vector<std::string> families;  // empty: all
  std::vector<int> degrees;           // of a table; empty: all
  bool table = false;
};

// Prints the manifest of a folder: every line, or the lines of some families, or a table of them.
int list(const std::string& folder, const ListOptions& options) {
  std::vector<std::string> prefixes;
  prefixes.reserve(options.families.size());
  for (const std::string& name : options.families) prefixes.push_back(find_family(name).name + "_l");
  std::ifstream manifest(folder + "/MANIFEST");
  if (!manifest)
    throw std::runtime_error(folder + "/MANIFEST: expected a readable file (`shgen write` writes it), got none");
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(manifest, line)) {
    const bool comment = line.starts_with('#');
    const bool chosen = std::any_of(prefixes.begin(), prefixes.end(),
                                    [&](const std::string& prefix) { return line.rfind(prefix, 0) == 0; });
    if (options.table && !comment && (prefixes.empty() || chosen)) rows.push_back(line);
    if (!options.table && (prefixes.empty() || comment || chosen)) std::cout << line << '\n';
  }
  if (options.table) std::cout << manifest_table(rows, options.degrees);
  return kDone;
}

}  // namespace

void add_write_command(CLI::App& tool, int& exit_code) {
  const auto selection = std::make_shared<Selection>();
  CLI::App* const command = tool.add_subcommand("write", "Write the generated files that differ");
  command->add_option("family", selection->families,
                      "Families to write, or batch: the drivers over many records, in seconds (default: everything)");
  command->add_option("--out", selection->folder, "Folder to write to (default: ./generated or the source tree's)");
  command->callback([selection, &exit_code] { exit_code = write(*selection); });
}

void add_check_command(CLI::App& tool, int& exit_code) {
  const auto selection = std::make_shared<Selection>();
  CLI::App* const command =
      tool.add_subcommand("check", "Compare the generated files with the output of the generator");
  command->add_option("family", selection->families,
                      "Families to compare, or batch (default: every file of the folder)");
  command->add_option("--dir", selection->folder, "Folder to compare (default: ./generated or the source tree's)");
  command->callback([selection, &exit_code] { exit_code = check(*selection); });
}

void add_list_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App* const command =
      tool.add_subcommand("list", "List every kernel and recipe with its cost, error, time and files");
  command->add_option("family", options->families, "Families (default: all)");
  CLI::Option* const table =
      command->add_flag("--table", options->table, "A table in Markdown of the written kernels with their errors");
  command->add_option("--degree", options->degrees, "Degrees of the table, e.g. 2,4,6 (default: all)")
      ->delimiter(',')
      ->needs(table);
  command->callback([options, &exit_code] { exit_code = list(default_folder(), *options); });
}

}  // namespace sh::codegen
