// Texts about a kernel: the comment at the head of every generated file, and its nodes for people who work on the
// generator.
#pragma once

#include <string>
#include <vector>

#include "codegen/measure/measure.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

/// Lines without comment marks. language: as in `shgen emit --lang`.
std::vector<std::string> describe(const FinishedKernel& finished, const std::string& language, const Dialect& dialect);

/// "1.2e-07": two significant digits.
std::string two_digits(double value);
/// The value rounded up to `places` places after the point.
double raised(double value, int places);

/// The SSA of a kernel, one node a line.
std::string dump(const Kernel& kernel);

}  // namespace sh::codegen::print
