// The verdict on a kernel: each limit is enforced by itself, and the line names the kernel.
#include <gtest/gtest.h>

#include <cmath>

#include "numeric/cpp_kernels.hpp"
#include "numeric/kernel_limits.hpp"

namespace sh::numeric {
namespace {

KernelResult clean_result() {
  return {"basis_l4", "glsl 450", "float", 4, {46, 12}, ErrorStats(1.2e-7), ErrorStats(1.2e-7), {}, BitComparison{}};
}

TEST(KernelLimits, AcceptAKernelWithoutError) { EXPECT_TRUE(failures_of(clean_result()).empty()); }

TEST(KernelLimits, RefuseTooMuchRounding) {
  auto result = clean_result();
  result.rounding.add(4, -3, {0.6, 0, 0.8}, 1e-6);
  const auto failures = failures_of(result);
  ASSERT_EQ(failures.size(), 1);
  EXPECT_EQ(failures[0].find("basis_l4 glsl 450 float: rounding error in eps x band maximum 9.85 exceeds"), 0)
      << failures[0];
  EXPECT_NE(failures[0].find("(l=4 m=-3 at 0.59999999999999998, 0, "), std::string::npos) << failures[0];
}

TEST(KernelLimits, RefuseATotalErrorOrOneThatIsNotANumber) {
  for (const double error : {7.1e-7, std::nan("")}) {
    auto result = clean_result();
    result.total.add(4, 0, {0, 0, 1}, error);
    ASSERT_EQ(failures_of(result).size(), 1);
    EXPECT_NE(failures_of(result)[0].find("total error"), std::string::npos);
  }
}

TEST(KernelLimits, RefuseADifferentBitButNotAFlushedOne) {
  auto result = clean_result();
  result.bits->flushed = 3;
  EXPECT_TRUE(failures_of(result).empty());
  result.bits->different = 1;
  EXPECT_EQ(failures_of(result).size(), 1);
}

TEST(KernelLimits, KeepThePromiseOfDegreeFourAndGrowWithDegree) {
  EXPECT_EQ(limits_for(4, "float").total, 7e-7);
  EXPECT_EQ(limits_for(4, "double").total, 3e-15);
  for (const char* scalar : {"float", "double"}) {
    for (int l = 1; l <= kMaxKernelDegree; ++l) {
      EXPECT_GE(limits_for(l, scalar).rounding, limits_for(l - 1, scalar).rounding);
      EXPECT_GE(limits_for(l, scalar).total, limits_for(l - 1, scalar).total);
    }
  }
}

// Sloan 2013 counts 14+3 at degree 2 and 47+12 at degree 4; the generated kernels must not need more.
TEST(Counted, CountsTheOperationsOfAKernel) {
  EXPECT_EQ(count_operations(0).mul, 0);
  EXPECT_EQ(count_operations(1).mul, 3);
  EXPECT_LE(count_operations(2).mul + count_operations(2).add, 17);
  EXPECT_LE(count_operations(4).mul + count_operations(4).add, 59);
  const auto before = Counted::counts();
  const Counted a(2);
  const Counted b = -(a * a + a) - a;
  static_cast<void>(b);
  const auto counted = Counted::counts() - before;
  EXPECT_EQ(counted.mul, 1);
  EXPECT_EQ(counted.add, 2);
}

}  // namespace
}  // namespace sh::numeric
