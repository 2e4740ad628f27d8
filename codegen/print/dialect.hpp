// The differences between the C-like languages in which kernels are printed.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::print {

enum class Scalar { kFloat, kDouble };

enum class Unused {
  kUnnamed,    ///< a parameter that is not read stays unnamed: "T /*x*/"
  kNamed,      ///< it keeps its name
  kDiscarded,  ///< it keeps its name and is discarded at the top: "(void)x;"
};

/// Templates are texts for filled(): $word stands for a value.
struct Dialect {
  std::string scalar;    ///< the scalar type: "T", "float"
  std::string head;      ///< before the type that a function returns: "constexpr "
  std::string tail;      ///< between its parameters and its body: " noexcept"
  std::string indent;    ///< of its body
  std::string constant;  ///< before a named constant: "const float "
  std::string variable;  ///< before a new variable: "const float "
  std::function<std::string(const ExactReal& value)> literal;
  /// Templates of parameters that are arrays, $name, $size: "const float $name[$size]".
  std::string in_array;
  std::string out_array;
  std::string in_out_array;
  /// Where T may be a register of lanes: the head of a function with an array that all lanes share, and templates of that
  /// array and of its $element as a T. Empty: there are no lanes.
  std::string shared_head = {};
  std::string shared_array = {};
  std::string shared_element = {};
  std::string square_root = "sqrt";  ///< the function
  /// Template of a selection: $a, $b, $then, $otherwise.
  std::string select = "($a < $b ? $then : $otherwise)";
  /// A table of constants. Templates of its definition in front of the function ($name, $size, $rows), of a line at the
  /// top of the function ($name; may be empty) and of an element ($table, $at). Without `table_literal` the table uses
  /// the literals of the language. `local_table` is its name within the function, if the name differs there.
  std::string table;
  std::string table_use;
  std::string table_entry = "$table[$at]";
  std::function<std::string(const ExactReal& value)> table_literal;
  std::string local_table;
  std::map<std::string, std::string> renamed;  ///< names that the language keeps for itself: {"out", "result"}
  std::set<std::string> reserved;              ///< words that no variable may be called
  Unused unused = Unused::kNamed;

  [[nodiscard]] std::string name(const std::string& wanted) const {
    const auto found = renamed.find(wanted);
    return found == renamed.end() ? wanted : found->second;
  }
  /// The name of the table of a kernel within its function.
  [[nodiscard]] std::string table_name(const std::string& kernel) const {
    return local_table.empty() ? kernel + "_table" : local_table;
  }
};

/// C++17: functions are constexpr templates on the scalar T; arrays are pointers. T may be a register of lanes; a prepared
/// light has numbers of type S, which lanes share if that is their scalar.
const Dialect& cpp_dialect();
/// GLSL and HLSL. `out` is a word of these languages, so the array has the name `result`.
Dialect glsl_dialect(Scalar scalar = Scalar::kFloat);
Dialect hlsl_dialect(Scalar scalar);
Dialect c99_dialect(Scalar scalar);

/// "float" or "double".
std::string scalar_name(Scalar scalar);

/// The option of `shgen emit` for a scalar: "" for float, " --scalar double".
std::string scalar_option(Scalar scalar);

/// The text with every $word (letters, digits, _) replaced by its value. Throws std::logic_error for a word without one.
std::string filled(std::string_view text, const std::map<std::string, std::string>& words);

/// The second and third line at the head of a generated file.
extern const char* const kStamp;

/// Lines as line comments of C-like languages.
std::string comment_block(const std::vector<std::string>& lines);

}  // namespace sh::codegen::print
