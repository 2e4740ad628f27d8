#include "codegen/print/hlsl.hpp"

#include "codegen/ir/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"
#include "codegen/print/glsl.hpp"

namespace sh::codegen::print {
namespace {

template <Scalar kScalar>
std::string table_definition(const std::string& name, const std::vector<std::vector<ExactReal>>& rows) {
  return "static const " + scalar_name(kScalar) + " " + name + "[" + std::to_string(rows.size() * rows[0].size()) +
         "] = {\n" + table_rows(rows, hlsl_dialect(kScalar).literal) + "};\n\n";
}

}  // namespace

Dialect hlsl_dialect(Scalar scalar) {
  Dialect d = glsl_dialect(scalar);
  // A plain number is a float there, too; double takes the suffix L.
  if (scalar == Scalar::kDouble)
    d.literal = [](const ExactReal& value) { return decimal(nearest<double>(value)) + "L"; };
  d.table_definition = scalar == Scalar::kFloat ? table_definition<Scalar::kFloat> : table_definition<Scalar::kDouble>;
  d.renamed = {{"out", "result"}};
  return d;
}

std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = hlsl_dialect(scalar);
  return comment_block(describe(finished, "hlsl" + scalar_option(scalar), d)) + "// HLSL, shader model 5.0.\n\n" +
         function(finished.kernel, d);
}

}  // namespace sh::codegen::print
