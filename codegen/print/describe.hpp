// The comment at the head of every generated file: what it computes, from what, at what cost and with what error.
#pragma once

#include <string>
#include <vector>

#include "codegen/passes/finished_kernel.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// Lines without comment marks. language: as in `shgen emit --lang`.
std::vector<std::string> describe(const FinishedKernel& finished, const std::string& language, const Dialect& dialect);

/// "1.2e-07": two significant digits.
std::string two_digits(double value);

}  // namespace sh::codegen::print
