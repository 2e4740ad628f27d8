// Printer: C++17 headers, templated on the scalar.
#pragma once

#include <string>
#include <vector>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// The definitions that functions in C++ rest on: constants, square roots, selections. Needs <cmath> and <type_traits>.
std::string cpp_prelude();

/// One self-contained header with one kernel, for every scalar.
std::string cpp_kernel(const FinishedKernel& finished, Scalar scalar);

/// The header of a whole family: includes every kernel's header and chooses by degree, `sh::basis<4>(x, y, z, out)`.
/// kernels: of one family, in order of degree without a gap.
std::string cpp_family(const std::vector<FinishedKernel>& kernels);

}  // namespace sh::codegen::print
