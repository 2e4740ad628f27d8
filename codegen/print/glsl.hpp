// Printer: GLSL functions. On float they are valid in GLSL 4.50 core and GLSL ES 3.00 alike; ES has no double.
#pragma once

#include <string>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// `out` is a word of the language: that array is called `result`.
Dialect glsl_dialect(Scalar scalar = Scalar::kFloat);

/// One function, without a #version line.
std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar);
/// The same for GLSL ES only. Throws std::invalid_argument for double.
std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar);

}  // namespace sh::codegen::print
