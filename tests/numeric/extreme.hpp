// A row of the table of extremes: what was tried, the largest error found, its limit, the input it was found at.
// Out: a line on standard output and one in build/extremes.part, which ctest prints as one table after the tests
// (tests/print_extremes.cmake). Such tests are named Extreme...: `ctest --test-dir build -R Extreme` shows them all.
#pragma once

#include <string>

namespace sh::test {

/// Prints and keeps a row, and expects error <= limit (so not NaN). Say the unit in `what`, as "basis_l10 float at the
/// poles, eps x band maximum"; worst_input is what to feed the function under test to see that error again.
void report_extreme(const std::string& what, double error, double limit, const std::string& worst_input);

}  // namespace sh::test
