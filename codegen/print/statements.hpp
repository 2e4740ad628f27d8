// From a kernel to named constants, infix statements and one function, which C-like languages have in common.
//
// A value that is used once stands in the expression that uses it, with brackets if the order of operations would
// change without them. A value that is used more often becomes a variable. Its name is its hint, or comes from its
// operands. An array parameter with the shape of a result may be the same array. Therefore its elements become
// variables before the function stores the element of the same index, unless only that store needs them.
//
// The loop over the rows of a table adds to variables that stand before it. All stores follow the loop.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"
#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

struct NamedConstant {
  std::string name;
  ExactReal value;
};

struct Statement {
  std::string text;     ///< "const T z2 = z * z;"
  std::string comment;  ///< stores: the value that this is
  bool in_loop = false;
};

/// The variables of the loop over a table: the row, and where it starts.
inline constexpr const char* kRow = "row";
inline constexpr const char* kRowStart = "at";

struct Listing {
  std::vector<NamedConstant> constants;  ///< in order of first use
  std::vector<Statement> statements;
};

/// Throws std::invalid_argument for operations without an infix form (fma: whether a * b + c contracts is left to the
/// compiler).
Listing make_listing(const Kernel& kernel, const Dialect& dialect);

/// The statements as lines, indented, comments in one column.
std::vector<std::string> statement_lines(const Listing& listing, const Dialect& dialect);

/// The items, separated by commas, in lines of at most about `width` characters behind `indent` spaces.
std::string wrapped_list(const std::vector<std::string>& items, std::size_t indent, std::size_t width);

/// Pads every row's cells so that columns line up; the last cell of a row is never padded.
std::vector<std::string> align_columns(const std::vector<std::vector<std::string>>& rows);

/// True if lanes share a parameter.
bool takes_shared(const Kernel& kernel);

/// "T x, T y, T z, T* out". A parameter that is also a result appears once, in the parameter's place.
std::string signature(const Kernel& kernel, const Dialect& dialect);

/// "x, y, z, out": the names that a call passes on.
std::string arguments(const Kernel& kernel, const Dialect& dialect);

/// "T" or "void".
std::string return_type(const Kernel& kernel, const Dialect& dialect);

/// The whole definition, from `dialect.head` to the closing brace and a line end.
std::string function(const Kernel& kernel, const Dialect& dialect);

}  // namespace sh::codegen::print
