// Printer: GLSL functions, valid in GLSL 4.50 core and GLSL ES 3.00 alike.
#pragma once

#include <string>

#include "codegen/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// `out` is a word of the language: that array is called `result`.
const Dialect& glsl_dialect();

/// One function on float, without a #version line.
std::string glsl_kernel(const FinishedKernel& finished);

}  // namespace sh::codegen::print
