// Runs a printed kernel from its text alone, in the arithmetic of its language.
//
// The reader knows the part of C++, C99, GLSL and HLSL that the printers use: straight-line code of one scalar type,
// arrays with constant indices, + - * /, square roots and selections. Everything else is an error. Literals have the
// type that the language gives them: 0.5f is a float in C99, a plain 0.5 is a float in GLSL and HLSL. A value of the
// wrong type therefore loses its digits here as it does on the machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/print/dialect.hpp"

namespace sh::codegen::test {

/// One parameter of the printed function, in order: an array, or a scalar of one element. The function updates it.
using Arguments = std::vector<std::vector<double>>;

/// Runs the function `name` of the text. An element that a function writes without a value before is NaN in `arguments`.
/// Returns what the function returns. Throws std::runtime_error, which names the text where it leaves the known part of
/// the language, uses an unknown name, reads outside of an array or writes to a constant one.
std::optional<double> run_printed(const std::string& language, print::Scalar scalar, const std::string& text,
                                  const std::string& name, Arguments& arguments);

}  // namespace sh::codegen::test
