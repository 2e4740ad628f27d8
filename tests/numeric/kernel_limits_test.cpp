// The verdict on a kernel: each limit is enforced by itself, follows the record, and the line names the kernel.
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
          .bits = BitComparison{}};
}

// basis_l4 with errors that are easy to count with.
FamiliesRecord round_record() {
  FamilyRecord basis;
  basis.family = "basis";
  basis.kernels.push_back({"basis_l4", "basis", 4, {}, {1.5, 3}, {2, 0.01}});
  FamiliesRecord record;
  record.limit_factor = {4, 8};
  record.least_limit = 1;
  record.families.push_back(basis);
  record.promises.push_back({"basis_l", "float", {}, 7e-7, "a promise"});
  return record;
}

TEST(KernelLimits, AreTheRecordedErrorsTimesTheFactorsOfTheRecord) {
  const FamiliesRecord record = round_record();
  const auto in_float = limits_for("basis", 4, "float", record);
  EXPECT_EQ(in_float->rounding, 6);
  EXPECT_EQ(in_float->total, 24);
  EXPECT_EQ(in_float->total_absolute, 7e-7);
  const auto in_double = limits_for("basis", 4, "double", record);
  EXPECT_EQ(in_double->rounding, 8);
  EXPECT_EQ(in_double->total, 1);  // the least
  EXPECT_EQ(in_double->total_absolute, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(limits_for("basis", 5, "float", record));
}

TEST(KernelLimits, LetAPromiseBindWhereItIsTighter) {
  FamiliesRecord record = round_record();
  record.promises.push_back({"basis_l4", "float", 5, {}, "a tighter one"});
  record.promises.push_back({"basis_accurate_l", "float", 1, {}, "of other kernels"});
  EXPECT_EQ(limits_for("basis", 4, "float", record)->rounding, 5);
  EXPECT_EQ(limits_for("basis", 4, "double", record)->rounding, 8);
}

TEST(KernelLimits, LetAProvedBoundBindWhereItIsTighterAndInASearch) {
  FamiliesRecord record = round_record();
  EXPECT_EQ(limits_for("basis", 4, "float", record)->searched, kSearchedLimit * 6);
  record.families[0].kernels[0].in_float.bound = 3.5;
  EXPECT_NEAR(limits_for("basis", 4, "float", record)->rounding, 3.5, 1e-5);
  EXPECT_NEAR(limits_for("basis", 4, "float", record)->searched, 3.5, 1e-5);
  EXPECT_GT(limits_for("basis", 4, "float", record)->rounding, 3.5) << "the check itself errs";
  EXPECT_GT(limits_for("basis", 4, "float", record)->searched, 3.5);
  record.families[0].kernels[0].in_float.bound = 7;  // beyond the limit of the check's inputs, but not of a search
  EXPECT_EQ(limits_for("basis", 4, "float", record)->rounding, 6);
  EXPECT_NEAR(limits_for("basis", 4, "float", record)->searched, 7, 1e-5);
}

TEST(KernelLimits, AcceptAKernelWithoutError) { EXPECT_TRUE(failures_of(clean_result(), round_record()).empty()); }

TEST(KernelLimits, AcceptAKernelThatMeetsThemAndPrintsNoBits) {
  auto result = clean_result();
  result.bits.reset();  // of c++ itself
  result.rounding.add({}, 6, 1);
  EXPECT_TRUE(failures_of(result, round_record()).empty());
}

// As many values as a quaternion has; the coefficients of a function would fill the screen.
TEST(KernelLimits, PrintUpToFourValuesOfTheWorstInput) {
  auto result = clean_result();
  result.rounding.add({}, 7, 1);
  for (std::size_t count = 0; count <= 5; ++count) {
    result.worst_rounding.values.assign(count, 0.5);
    const auto failures = failures_of(result, round_record());
    ASSERT_EQ(failures.size(), 1);
    std::string values;
    for (std::size_t i = 0; count <= 4 && i < count; ++i) values += i == 0 ? ": 0.5" : ", 0.5";
    EXPECT_EQ(failures[0],
              "basis_l4 glsl 450 float: rounding error in eps 7 exceeds 6 (out l=4 m=-3 at random 3" + values + ")");
  }
}

TEST(KernelLimits, RefuseTooMuchRounding) {
  auto result = clean_result();
  result.rounding.add({}, 1, 1 / 9.85);
  const auto failures = failures_of(result, round_record());
  ASSERT_EQ(failures.size(), 1);
  EXPECT_EQ(failures[0],
            "basis_l4 glsl 450 float: rounding error in eps 9.85 exceeds 6 (out l=4 m=-3 at random 3: "
            "0.59999999999999998, 0, 0.80000000000000004)");
}

// A kernel that errs as before against a record that says less: the record binds.
TEST(KernelLimits, RefuseAKernelThatIsWorseThanRecorded) {
  auto result = clean_result();
  result.rounding.add({}, 1, 1 / 5.9);
  FamiliesRecord record = round_record();
  EXPECT_TRUE(failures_of(result, record).empty());
  record.families[0].kernels[0].in_float.rounding /= 2;
  EXPECT_EQ(failures_of(result, record).size(), 1);
}

TEST(KernelLimits, RefuseATotalErrorOrOneThatIsNotANumber) {
  for (const double error : {7.1e-7, 1e3, std::nan("")}) {
    auto result = clean_result();
    result.total.add({}, error, 1e12);
    const auto failures = failures_of(result, round_record());
    ASSERT_EQ(failures.size(), std::isnan(error) ? 2 : 1);
    EXPECT_NE(failures[0].find("total error"), std::string::npos);
  }
  auto result = clean_result();
  result.total.add({}, 1e-9, 1e-12);
  const auto failures = failures_of(result, round_record());
  ASSERT_EQ(failures.size(), 1);
  EXPECT_NE(failures[0].find("total error in eps 1e+03 exceeds"), std::string::npos);
}

TEST(KernelLimits, RefuseADifferentBitButNotAFlushedOne) {
  auto result = clean_result();
  result.bits->flushed = 3;
  EXPECT_TRUE(failures_of(result).empty());
  result.bits->different = 1;
  EXPECT_EQ(failures_of(result).size(), 1);
  result.bits->compared = 25;
  result.bits->first_difference = "there";
  EXPECT_EQ(failures_of(result)[0],
            "basis_l4 glsl 450 float: 1 of 25 values differ from c++ float in their bits; first: there");
  for (const char* regrouped : {"product_l5", "basis_gradient_accurate_l2"}) {
    auto other = result;
    other.kernel = regrouped;
    EXPECT_TRUE(failures_of(other).empty()) << regrouped;
  }
  result.operations.other = 1;  // a square root, say: its last bit is the language's affair
  EXPECT_TRUE(failures_of(result).empty());
}

TEST(KernelLimits, RefuseAKernelThatDoesNotWorkInPlaceOrIsNotRecorded) {
  auto result = clean_result();
  result.different_in_place = 2;
  ASSERT_EQ(failures_of(result).size(), 1);
  EXPECT_NE(failures_of(result)[0].find("2 values change when an input array is overwritten"), std::string::npos);
  result = clean_result();
  result.family = "unknown";
  ASSERT_EQ(failures_of(result).size(), 1);
  EXPECT_NE(failures_of(result)[0].find("no error is recorded"), std::string::npos);
}

TEST(KernelLimits, KeepThePromisesOfTheBasis) {
  EXPECT_EQ(limits_for("basis", 4, "float")->total_absolute, 7e-7);
  EXPECT_EQ(limits_for("basis", 4, "double")->total_absolute, 3e-15);
  for (const char* scalar : {"float", "double"}) {
    for (const int l : {7, 9, 10}) EXPECT_LE(limits_for("basis_accurate", l, scalar)->rounding, 8);
  }
}

}  // namespace
}  // namespace sh::numeric
