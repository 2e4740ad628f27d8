#include "codegen/commands/typeset.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "codegen/commands/commands.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::codegen {
namespace {

symbolic::FormulaTable table_of(const TypesetOptions& options) {
  return symbolic::typeset_table(options.family, options.degree, symbolic::find_preset(options.convention));
}

}  // namespace

std::string typeset_tex(const TypesetOptions& options) { return symbolic::tex_document(table_of(options)); }

std::string typeset_markdown(const TypesetOptions& options) { return symbolic::markdown_document(table_of(options)); }

void add_typeset_commands(CLI::App& tool, int& exit_code) {
  const auto add = [&](const char* name, const char* what, std::string (*typeset)(const TypesetOptions&)) {
    const auto options = std::make_shared<TypesetOptions>();
    CLI::App* const command = tool.add_subcommand(name, what);
    command->add_option("family", options->family, "Family, e.g. basis, rotation, gaunt, cap")->required();
    command->add_option("--degree", options->degree, "Largest degree l")->required();
    command->add_option("--convention", options->convention, "Convention, e.g. shforge, directxmath, unity");
    command->callback([options, typeset, &exit_code] {
      std::cout << typeset(*options);
      exit_code = kDone;
    });
  };
  add("tex", "Print formulas as a LaTeX document", typeset_tex);
  add("markdown", "Print formulas as Markdown with TeX mathematics", typeset_markdown);
}

}  // namespace sh::codegen
