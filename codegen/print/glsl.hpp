// Printer: GLSL functions, valid in GLSL 4.50 core and GLSL ES 3.00 alike.
#pragma once

#include <string>

#include "codegen/finished_kernel.hpp"

namespace sh::codegen::print {

/// One function on float, without a #version line. The result array is called `result`.
std::string glsl_kernel(const FinishedKernel& finished);

}  // namespace sh::codegen::print
