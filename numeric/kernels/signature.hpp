// The parameters and results of a kernel, the same in every language: scalars and arrays in, arrays out, arrays updated
// in place, perhaps a returned scalar.
//
// Flat order, used wherever inputs or outputs travel as one array: inputs are the `in` and `in-out` parameters one
// after the other; outputs are the returned scalar, if any, then the `out` and `in-out` parameters.
#pragma once

#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace sh::numeric {

enum class Access { kIn, kOut, kInOut };

struct Parameter {
  std::string name;
  int count = 0;  // 0: a scalar; n: an array of n
  Access access = Access::kIn;
  int rows = 1;           // of an array: a 3x3 matrix is an array of 9 in 3 rows
  std::string role = {};  // its meaning, as generated/families.json names it: "direction", "coefficients"
  int degree = -1;        // of the function that an array holds; -1: it holds none
  int channels = 1;       // the functions that an array of coefficients holds

  [[nodiscard]] int values() const { return count == 0 ? 1 : count; }
  [[nodiscard]] bool is_read() const { return access != Access::kOut; }
  [[nodiscard]] bool is_written() const { return access != Access::kIn; }
  /// True for numbers that another kernel makes and that only make sense together.
  [[nodiscard]] bool is_prepared() const {
    return role == "band matrices" || role == "polynomial" || role == "sampled function";
  }
};

struct Signature {
  std::vector<Parameter> parameters;
  bool returns_value = false;

  [[nodiscard]] int input_count() const {
    return std::accumulate(parameters.begin(), parameters.end(), 0,
                           [](int sum, const Parameter& p) { return sum + (p.is_read() ? p.values() : 0); });
  }
  [[nodiscard]] int output_count() const {
    return std::accumulate(parameters.begin(), parameters.end(), returns_value ? 1 : 0,
                           [](int sum, const Parameter& p) { return sum + (p.is_written() ? p.values() : 0); });
  }
};

inline Parameter scalar(std::string name) { return {std::move(name)}; }
inline Parameter in_array(std::string name, int count) { return {std::move(name), count, Access::kIn}; }
inline Parameter in_matrix(std::string name, int rows, int columns) {
  return {std::move(name), rows * columns, Access::kIn, rows};
}
inline Parameter out_array(std::string name, int count) { return {std::move(name), count, Access::kOut}; }
inline Parameter in_out_array(std::string name, int count) { return {std::move(name), count, Access::kInOut}; }

}  // namespace sh::numeric
