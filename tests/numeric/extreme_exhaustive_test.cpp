// Generated kernels of one variable at every float beside the ends and the middle of their domain and at each 251st
// elsewhere; `shcheck worst --exhaustive` runs all of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "numeric/kernels/every_float.hpp"
#include "numeric/kernels/exhaustive.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

constexpr std::uint32_t kStride = 251;
constexpr std::uint32_t kBeside = 1 << 16;

float moved(float value, std::int64_t steps) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(std::bit_cast<std::uint32_t>(value) + steps));
}

FloatError worst_of(const OneVariableKernel& kernel) {
  FloatError worst;
  for (const FloatRange& range : {FloatRange{0, kernel.largest, kStride},
                                  {0, moved(0, kBeside), 1},
                                  {moved(1, -std::int64_t{kBeside}), moved(1, kernel.largest > 1 ? kBeside : 0), 1},
                                  {moved(kernel.largest, -std::int64_t{kBeside}), kernel.largest, 1}}) {
    const FloatError found = kernel.worst(range);
    if (found.error > worst.error) worst = found;
  }
  return worst;
}

TEST(ExtremeFloats, OfOneVariableKernelsKeepTheirLimits) {
  for (const OneVariableKernel& kernel : one_variable_kernels()) {
    const FloatError worst = worst_of(kernel);
    const double limit = limits_for(kernel.family, kernel.degree, "float").value().rounding;
    test::report_extreme("every float at the ends, each 251st between: " + kernel.name() + ", eps", worst.error, limit,
                         fmt::format("output {} at {:.9g} = {:a}", worst.output, worst.at, worst.at));
  }
}

// Every float counts once, the last one included, and a wrong value at one of them is found.
TEST(ExtremeFloats, AreAllTried) {
  const float bad = 0x1.fffffep-1F;
  const auto kernel = [bad]<class T>(const T& x, T* out) {
    out[0] = x;
    if constexpr (std::is_same_v<T, FloatLanes>) where(x == bad, out[0]) = 2;
  };
  const auto size = [](std::size_t /*output*/, const DoubleLanes& /*x*/) { return DoubleLanes(1); };
  const FloatError found = worst_float<1>({0.5F, bad, 1}, kernel, size);
  EXPECT_EQ(found.at, bad);
  EXPECT_GE(found.evaluated, 1U << 23U);
  EXPECT_EQ((worst_float<1>({0.5F, 0x1.fffffcp-1F, 1}, kernel, size).error), 0);
}

}  // namespace
}  // namespace sh::numeric
