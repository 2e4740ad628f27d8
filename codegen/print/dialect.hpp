// The differences between the C-like languages in which kernels are printed.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::print {

enum class Scalar { kFloat, kDouble };

enum class Unused {
  kUnnamed,    ///< a parameter that is not read stays unnamed: "T /*x*/"
  kNamed,      ///< it keeps its name
  kDiscarded,  ///< it keeps its name and is discarded at the top: "(void)x;"
};

struct Dialect {
  std::string scalar;    ///< the scalar type: "T", "float"
  std::string head;      ///< before the type that a function returns: "constexpr "
  std::string tail;      ///< between its parameters and its body: " noexcept"
  std::string indent;    ///< of its body
  std::string constant;  ///< before a named constant: "const float "
  std::string variable;  ///< before a new variable: "const float "
  std::string (*literal)(const ExactReal& value) = nullptr;
  /// Parameters that are arrays: "const float c[25]".
  std::string (*in_array)(const std::string& name, int size) = nullptr;
  std::string (*out_array)(const std::string& name, int size) = nullptr;
  std::string (*in_out_array)(const std::string& name, int size) = nullptr;
  std::string square_root;  ///< the function: "sqrt"
  /// a < b ? then : otherwise
  std::string (*select)(const std::string& a, const std::string& b, const std::string& then,
                        const std::string& otherwise) = nullptr;
  /// A table of constants: its name within the function, its definition in front of the function, a line at the top of
  /// the function ("" or nullptr for none) and an element.
  std::string (*table_name)(const std::string& kernel) = [](const std::string& kernel) { return kernel + "_table"; };
  std::string (*table_definition)(const std::string& name, const std::vector<std::vector<ExactReal>>& rows) = nullptr;
  std::string (*table_use)(const std::string& name) = nullptr;
  std::string (*table_entry)(const std::string& kernel, const std::string& index) = nullptr;
  std::map<std::string, std::string> renamed;  ///< names that the language keeps for itself: {"out", "result"}
  std::set<std::string> reserved;              ///< words that no variable may be called
  Unused unused = Unused::kNamed;

  [[nodiscard]] std::string name(const std::string& wanted) const {
    const auto found = renamed.find(wanted);
    return found == renamed.end() ? wanted : found->second;
  }
};

/// The numbers of a table, separated by commas, every row on lines of its own.
std::string table_rows(const std::vector<std::vector<ExactReal>>& rows, std::string (*literal)(const ExactReal& value));

/// "float" or "double".
std::string scalar_name(Scalar scalar);

/// An array parameter whose size follows its name: "const float c[25]".
std::string sized_array(const std::string& qualifier, Scalar scalar, const std::string& name, int size);

/// The option of `shgen emit`: "" for float, " --scalar double".
std::string scalar_option(Scalar scalar);

/// Lines as line comments of C-like languages.
std::string comment_block(const std::vector<std::string>& lines);

}  // namespace sh::codegen::print
