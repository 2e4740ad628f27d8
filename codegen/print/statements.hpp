// From a kernel to named constants and infix statements, which C-like languages have in common.
//
// A value used once is written into the expression that uses it (with brackets wherever the order of operations would
// change otherwise); a value used more often becomes a variable under its hint, or a name made from its operands.
// An array parameter that has the shape of a result may be the same array: its elements become variables before the
// element of the same index is stored, unless only that store needs them.
//
// The loop over the rows of a table adds to variables that are declared before it; all results are stored after it.
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
  enum class Kind { kVariable, kStore, kReturn, kSumStart, kLoopStart, kSumStep, kLoopEnd };
  Kind kind = Kind::kVariable;
  std::string target;  ///< a new variable, or an element of a result such as "out[4]"; empty for a return
  std::string expression;
  std::string comment;  ///< stores: which value this is
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

/// Pads every row's cells so that columns line up; the last cell of a row is never padded.
std::vector<std::string> align_columns(const std::vector<std::vector<std::string>>& rows);

}  // namespace sh::codegen::print
