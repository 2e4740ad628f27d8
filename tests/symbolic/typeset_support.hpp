// Shared by the tests of typeset tables: formulas read back from TeX, and points to compare them at.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation.hpp"
#include "symbolic/typeset/typeset_families.hpp"
#include "tests/symbolic/formula_reader.hpp"

namespace sh::symbolic::test {

using Formulas = std::map<std::string, std::string>;

// measured: at most 1.8e-15 on anything below
inline constexpr double kTolerance = 6e-15;

inline Formulas formulas(const std::string& family, int degree, const std::string& convention = "shforge") {
  return read_formulas(tex_document(typeset_table(family, degree, find_preset(convention))));
}

inline double real(const Formulas& table, const std::string& symbol, const Values& values) {
  const auto found = table.find(symbol);
  const std::complex<double> value = found == table.end() ? 0 : evaluate(found->second, values);
  EXPECT_EQ(value.imag(), 0) << symbol;
  return value.real();
}

inline std::vector<std::array<double, 3>> directions(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<std::array<double, 3>> result;
  while (static_cast<int>(result.size()) < count) {
    result.push_back(numeric::normalized(normal(random), normal(random), normal(random)));
  }
  return result;
}

inline Values point(const std::array<double, 3>& d) { return {{"x", d[0]}, {"y", d[1]}, {"z", d[2]}}; }

inline std::string function_symbol(int l, int m) { return "Y" + tex_indices(l, m); }

// Row-major rotation matrix of a unit quaternion (w, x, y, z).
inline std::array<double, 9> matrix_of(const std::array<double, 4>& q) {
  const auto [w, x, y, z] = q;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

inline Values entries_of(const std::array<double, 9>& r) {
  Values values;
  for (int i = 0; i < 9; ++i) {
    values["r_{" + std::to_string(i / 3) + std::to_string(i % 3) + "}"] = r[i];
  }
  return values;
}

}  // namespace sh::symbolic::test
