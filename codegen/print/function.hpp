// A kernel as one function of a C-like language: signature, constants, statements.
#pragma once

#include <string>

#include "codegen/ir/ir.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// "T x, T y, T z, T* out". A parameter that is also a result appears once, in the parameter's place.
std::string signature(const Kernel& kernel, const Dialect& dialect);

/// "x, y, z, out": the names that a call passes on.
std::string arguments(const Kernel& kernel, const Dialect& dialect);

/// "T" or "void".
std::string return_type(const Kernel& kernel, const Dialect& dialect);

/// The whole definition, from `dialect.head` to the closing brace and a line end.
std::string function(const Kernel& kernel, const Dialect& dialect);

}  // namespace sh::codegen::print
