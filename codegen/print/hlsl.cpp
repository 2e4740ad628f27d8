#include "codegen/print/hlsl.hpp"

#include "codegen/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"
#include "codegen/print/glsl.hpp"

namespace sh::codegen::print {

Dialect hlsl_dialect(Scalar scalar) {
  Dialect d = glsl_dialect(scalar);
  // A plain number is a float there, too; double takes the suffix L.
  if (scalar == Scalar::kDouble)
    d.literal = [](const ExactReal& value) { return decimal(nearest<double>(value)) + "L"; };
  d.renamed = {{"out", "result"}};
  return d;
}

std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = hlsl_dialect(scalar);
  return comment_block(describe(finished, "hlsl" + scalar_option(scalar), d)) + "// HLSL, shader model 5.0.\n\n" +
         function(finished.kernel, d);
}

}  // namespace sh::codegen::print
