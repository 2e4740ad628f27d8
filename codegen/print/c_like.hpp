// Printer: one kernel in GLSL, HLSL or C99, from the table of what differs between these languages (dialect.hpp).
#pragma once

#include <string>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// One function for GLSL 4.50 core, on float also for GLSL ES 3.00; without a #version line.
std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar);
/// The same for GLSL ES only. Throws std::invalid_argument for double, which ES does not have.
std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar);
/// One function for HLSL, shader model 5.0 and later.
std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar);
/// One self-contained C99 header. C has no overloading: on double the function is called basis_l4_double.
std::string c99_kernel(const FinishedKernel& finished, Scalar scalar);

}  // namespace sh::codegen::print
