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

}  // namespace

void add_typeset_commands(CLI::App& tool, int& exit_code) {
  const auto add = [&](const char* name, const char* what, std::string (*print)(const symbolic::FormulaTable&)) {
    const auto options = std::make_shared<TypesetOptions>();
    CLI::App* const command = tool.add_subcommand(name, what);
    command->add_option("family", options->family, "Family, e.g. basis, rotation, gaunt, cap")->required();
    command->add_option("--degree", options->degree, "Largest degree l")->required();
    command->add_option("--convention", options->convention, "Convention, e.g. shforge, directxmath, unity");
    command->callback([options, print, &exit_code] {
      const symbolic::Preset& preset = symbolic::find_preset(options->convention);
      std::cout << print(symbolic::typeset_table(options->family, options->degree, preset));
      exit_code = kDone;
    });
  };
  add("tex", "Print formulas as a LaTeX document", symbolic::tex_document);
  add("markdown", "Print formulas as Markdown with TeX mathematics", symbolic::markdown_document);
}

}  // namespace sh::codegen
