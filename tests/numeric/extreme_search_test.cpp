// The worst input of every family of generated kernels by search: beyond the inputs of its check, and within the proved
// bounds, or else kSearchedLimit times the limits that hold there (numeric/kernels/kernel_limits.hpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/kernels/kernel_search.hpp"
#include "tests/numeric/extreme.hpp"
#include "tests/numeric/extreme_kernels.hpp"

namespace sh::numeric {
namespace {

constexpr SearchEffort kEffort{3, 400, 1};

// A row for a family and scalar: the kernel that comes nearest to its limit.
template <class T>
void report_family(const FamilyCheck& check) {
  double part = -1, error = 0, limit = 0;
  std::string where;
  for (const BoundKernel& kernel : test::kernels_of({check.family})) {
    const KernelResult result = search_kernel<T>(kernel, check, kEffort);
    const double allowed = limits_for(kernel.family, kernel.degree, result.scalar).value().searched;
    const double found = result.rounding.scaled().max();
    if (found / allowed <= part) continue;
    part = found / allowed;
    error = found;
    limit = allowed;
    constexpr std::size_t kMostShown = 6;
    auto values = result.worst_rounding.values;
    const bool all = values.size() <= kMostShown;
    if (!all) values.resize(kMostShown);
    where = fmt::format("{}, {} at {}{}", result.kernel, result.worst_rounding.output, test::printed(values),
                        all ? "" : " ... (shcheck worst shows all)");
  }
  const char* const scalar = sizeof(T) == sizeof(float) ? "float" : "double";
  test::report_extreme(fmt::format("worst found by search: {} {}, eps", check.family, scalar), error, limit, where);
}

TEST(ExtremeSearch, OfEveryFamilyStaysWithinItsLimits) {
  for (const FamilyCheck& check : all_checks()) {
    report_family<float>(check);
    report_family<double>(check);
  }
}

// With a direction and 25 to 121 coefficients to choose, the search finds clearly larger errors than the inputs of the
// check do: 1.36 to 3 times as large.
TEST(ExtremeSearch, FindsMoreThanTheInputsOfTheCheckDo) {
  const FamilyCheck& check = check_of("evaluate");
  for (const BoundKernel& kernel : test::kernels_of({"evaluate"})) {
    if (kernel.degree < 4) continue;
    const double sampled = kernel_errors<float>(kernel, check).rounding.scaled().max();
    EXPECT_GT(search_kernel<float>(kernel, check, kEffort).rounding.scaled().max(), 1.2 * sampled) << kernel.name();
  }
}

// Shorter vectors lose their digits to underflow, which is no rounding error of the kernel.
TEST(ExtremeSearch, KeepsVectorsAtTestedLengths) {
  const FamilyCheck& check = check_of("basis_normalised");
  const auto length = [](const std::vector<double>& v) { return std::hypot(v[0], v[1], v[2]); };
  for (const BoundKernel& kernel : test::kernels_of({"basis_normalised", "basis_normalised_accurate"})) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const auto& input : check.inputs(kernel.degree)) {
      shortest = std::min(shortest, length(input.values));
      longest = std::max(longest, length(input.values));
    }
    const KernelResult found = search_kernel<float>(kernel, check, SearchEffort{});
    constexpr double kRounded = 1e-6;
    EXPECT_GE(length(found.worst_rounding.values), shortest * (1 - kRounded)) << kernel.name();
    EXPECT_LE(length(found.worst_rounding.values), longest * (1 + kRounded)) << kernel.name();
  }
}

}  // namespace
}  // namespace sh::numeric
