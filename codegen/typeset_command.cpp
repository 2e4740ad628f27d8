#include "codegen/typeset_command.hpp"

#include "symbolic/typeset_families.hpp"

namespace sh::codegen {
namespace {

symbolic::FormulaTable table_of(const TypesetOptions& options) {
  return symbolic::typeset_table(options.family, options.degree, symbolic::find_preset(options.convention));
}

}  // namespace

std::string typeset_tex(const TypesetOptions& options) { return symbolic::tex_document(table_of(options)); }

std::string typeset_markdown(const TypesetOptions& options) { return symbolic::markdown_document(table_of(options)); }

}  // namespace sh::codegen
