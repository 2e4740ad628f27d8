// The verdict on a kernel: each limit is enforced by itself, and the line names the kernel.
#include "numeric/kernels/kernel_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sh::numeric {
namespace {

KernelResult clean_result() {
  return {.kernel = "basis_l4",
          .family = "basis",
          .language = "glsl 450",
          .scalar = "float",
          .degree = 4,
          .unit = "1",
          .inputs = 1,
          .operations = {46, 12, 0},
          .rounding = ErrorStats(1),
          .total = ErrorStats(1),
          .worst_rounding = {"random 3", {0.6, 0, 0.8}, "out l=4 m=-3"},
          .worst_total = {},
          .nanoseconds = {},
          .bits = BitComparison{}};
}

TEST(KernelLimits, AcceptAKernelWithoutError) { EXPECT_TRUE(failures_of(clean_result()).empty()); }

TEST(KernelLimits, RefuseTooMuchRounding) {
  auto result = clean_result();
  result.rounding.add({}, 1, 1 / 9.85);
  const auto failures = failures_of(result);
  ASSERT_EQ(failures.size(), 1);
  EXPECT_EQ(failures[0],
            "basis_l4 glsl 450 float: rounding error in eps 9.85 exceeds 5.6 (out l=4 m=-3 at random 3: "
            "0.59999999999999998, 0, 0.80000000000000004)");
}

TEST(KernelLimits, RefuseATotalErrorOrOneThatIsNotANumber) {
  for (const double error : {7.1e-7, 1e3, std::nan("")}) {
    auto result = clean_result();
    result.total.add({}, error, 1e12);
    ASSERT_EQ(failures_of(result).size(), std::isnan(error) ? 2 : 1);
    EXPECT_NE(failures_of(result)[0].find("total error"), std::string::npos);
  }
  auto result = clean_result();
  result.total.add({}, 1e-9, 1e-12);
  ASSERT_EQ(failures_of(result).size(), 1);
  EXPECT_NE(failures_of(result)[0].find("total error in eps 1e+03 exceeds"), std::string::npos);
}

TEST(KernelLimits, RefuseADifferentBitButNotAFlushedOne) {
  auto result = clean_result();
  result.bits->flushed = 3;
  EXPECT_TRUE(failures_of(result).empty());
  result.bits->different = 1;
  EXPECT_EQ(failures_of(result).size(), 1);
  result.operations.other = 1;  // a square root, say: its last bit is the language's affair
  EXPECT_TRUE(failures_of(result).empty());
}

TEST(KernelLimits, RefuseAKernelThatDoesNotWorkInPlaceOrHasNoLimit) {
  auto result = clean_result();
  result.different_in_place = 2;
  ASSERT_EQ(failures_of(result).size(), 1);
  EXPECT_NE(failures_of(result)[0].find("2 values change when an input array is overwritten"), std::string::npos);
  result = clean_result();
  result.family = "unknown";
  ASSERT_EQ(failures_of(result).size(), 1);
  EXPECT_NE(failures_of(result)[0].find("no limit is set"), std::string::npos);
}

TEST(KernelLimits, KeepThePromiseOfDegreeFourAndGrowWithDegree) {
  EXPECT_EQ(limits_for("basis", 4, "float")->total_absolute, 7e-7);
  EXPECT_EQ(limits_for("basis", 4, "double")->total_absolute, 3e-15);
  for (const char* scalar : {"float", "double"}) {
    for (int l = 1; l <= 10; ++l) {
      EXPECT_GE(limits_for("basis", l, scalar)->rounding, limits_for("basis", l - 1, scalar)->rounding);
      EXPECT_GE(limits_for("basis", l, scalar)->total, limits_for("basis", l - 1, scalar)->total);
    }
  }
}

}  // namespace
}  // namespace sh::numeric
