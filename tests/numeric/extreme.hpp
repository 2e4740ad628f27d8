// A row of the table of extremes: the subject, the largest error found, its limit, its input.
// Out: a line on standard output and one in build/extremes.part, which ctest prints as one table after the tests
// (tests/print_extremes.cmake). Such tests are named Extreme...: `ctest --test-dir build -R Extreme` shows them all.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace sh::test {

/// Prints and keeps a row, and expects error <= limit (so not NaN). Say the unit in `what`, as "basis_l10 float at the
/// poles, eps x band maximum"; worst_input is the input that shows that error again.
void report_extreme(const std::string& what, double error, double limit, const std::string& worst_input);

/// The largest of several errors and its input. An error that is not a number counts as infinite.
struct Worst {
  double error = 0;
  std::string input = "none";

  template <class... Argument>
  void keep(double other, fmt::format_string<Argument...> format, Argument&&... arguments) {
    if (other <= error) return;
    error = std::isnan(other) ? HUGE_VAL : other;
    input = fmt::format(format, std::forward<Argument>(arguments)...);
  }
  void report(const std::string& what, double limit) const { report_extreme(what, error, limit, input); }
};

}  // namespace sh::test
