// `shgen tex` and `shgen markdown`: print a table of the formulas of one family.
//
// Input: family, degree and the name of a convention. Output: a complete LaTeX document or Markdown text.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "codegen/commands/commands.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::codegen {
namespace {

// The options of `shgen tex` and `shgen markdown`.
struct TypesetOptions {
  std::string family;
  int degree = 0;
  std::string convention = "shforge";  // the name of a preset
};

symbolic::FormulaTable table_of(const TypesetOptions& options) {
  return symbolic::typeset_table(options.family, options.degree, symbolic::find_preset(options.convention));
}

// Both functions throw std::invalid_argument, one line, for an unknown family or convention (the line lists the known
// ones), for a degree beyond the family's largest, and for a convention that does not apply to the family.
std::string typeset_tex(const TypesetOptions& options) { return symbolic::tex_document(table_of(options)); }

std::string typeset_markdown(const TypesetOptions& options) { return symbolic::markdown_document(table_of(options)); }

}  // namespace

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
