// Printers: one kernel as a file of each language, and the C++ header of a whole family.
#pragma once

#include <string>
#include <vector>

#include "codegen/measure/measure.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// The definitions that functions in C++ rest on: constants, square roots, selections. Needs <cmath> and <type_traits>.
std::string cpp_prelude();

/// One self-contained header with one kernel, for every scalar.
std::string cpp_kernel(const FinishedKernel& finished, Scalar scalar);

/// The header of a whole family: includes every kernel's header and chooses by degree, `sh::basis<4>(x, y, z, out)`.
/// kernels: of one family, in order of degree without a gap.
std::string cpp_family(const std::vector<FinishedKernel>& kernels);

/// One function for GLSL 4.50 core, on float also for GLSL ES 3.00; without a #version line.
std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar);
/// The same for GLSL ES only. Throws std::invalid_argument for double, which ES does not have.
std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar);
/// One function for HLSL, shader model 5.0 and later.
std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar);
/// One self-contained C99 header. C has no overloading: on double the function is called basis_l4_double.
std::string c99_kernel(const FinishedKernel& finished, Scalar scalar);

}  // namespace sh::codegen::print
