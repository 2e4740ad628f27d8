// Printer: C99 headers.
#pragma once

#include <string>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

Dialect c99_dialect(Scalar scalar);

/// One self-contained header. C has no overloading: on double the function is called basis_l4_double.
std::string c99_kernel(const FinishedKernel& finished, Scalar scalar);

}  // namespace sh::codegen::print
