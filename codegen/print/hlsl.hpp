// Printer: HLSL functions, shader model 5.0 and later.
#pragma once

#include <string>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// `out` is a word of the language: that array is called `result`.
Dialect hlsl_dialect(Scalar scalar);

/// One function.
std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar);

}  // namespace sh::codegen::print
