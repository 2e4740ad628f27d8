// Rows of the table of extremes: tests/numeric/extreme.hpp.
#include "tests/numeric/extreme.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

namespace sh::test {
namespace {

// Adds a line to the file. Other tests may write at the same time: one write in append mode is never split.
void append(const std::string& line) {
  const int file = ::open(SHFORGE_EXTREMES_FILE, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) return;
  EXPECT_EQ(::write(file, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  ::close(file);
}

}  // namespace

void report_extreme(const std::string& what, double error, double limit, const std::string& worst_input) {
  const std::string row =
      fmt::format("extreme | {:<72} | {:>10.3g} | {:>10.3g} | {}\n", what, error, limit, worst_input);
  fmt::print("{}", row);
  std::fflush(stdout);
  append(row);
  EXPECT_LE(error, limit) << what << ", at " << worst_input;
}

}  // namespace sh::test
