// NaN and infinity go into every generated kernel at every argument: no output that depends on that
// argument may come out as an ordinary number, and nothing may trap.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/flat_call.hpp"
#include "numeric/oracle/basis.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

// Which outputs change when one input does, found on Wide at an input of the check where nothing vanishes.
std::vector<bool> dependent(FlatCall<Wide>& call, std::vector<Wide> in, std::size_t changed, std::size_t outputs) {
  std::vector<Wide> before(outputs), after(outputs);
  call(in.data(), before.data());
  in[changed] = in[changed] * Wide(1.03125) + Wide(0.03125);
  call(in.data(), after.data());
  std::vector<bool> result(outputs);
  for (std::size_t i = 0; i < outputs; ++i) result[i] = std::abs((after[i] - before[i]).high()) > 1e-12;
  return result;
}

struct Silent {
  int count = 0;
  std::string first = "none";
};

template <class T>
void count_silent(const BoundKernel& kernel, const FamilyCheck& check, T bad, Silent& silent) {
  const Signature signature = check.signature(kernel.degree);
  const auto inputs = check.inputs(kernel.degree);
  const auto& usual = inputs[inputs.size() * 3 / 4].values;
  const auto outputs = static_cast<std::size_t>(signature.output_count());
  FlatCall<T> call(kernel, signature);
  FlatCall<Wide> wide_call(kernel, signature);
  std::vector<T> out(outputs);
  constexpr std::size_t kMostTried = 24;
  const std::size_t step = 1 + usual.size() / kMostTried;
  for (std::size_t i = usual.size() - 1; i < usual.size(); i -= step) {
    const auto depends = dependent(wide_call, {usual.begin(), usual.end()}, i, outputs);
    std::vector<T> in(usual.begin(), usual.end());
    in[i] = bad;
    call(in.data(), out.data());
    for (std::size_t k = 0; k < outputs; ++k) {
      if (!depends[k] || !std::isfinite(out[k])) continue;
      if (silent.count++ == 0) silent.first = fmt::format("{} input {} output {}: {}", kernel.name(), i, k, out[k]);
    }
  }
}

// Where an infinite argument may give numbers: a Laplacian window of infinite strength lets nothing through, and
// a direction of infinite length has components that are none; see the last test.
bool may_be_finite(const BoundKernel& kernel) {
  return kernel.family == "window_laplacian" || without_variant(kernel.family) == "basis_normalised";
}

template <class T>
Silent silent_kernels(T bad) {
  Silent silent;
  for (const BoundKernel& kernel : bound_kernels()) {
    if (kernel.degree > 4 && kernel.degree < 10) continue;
    if (std::isinf(bad) && may_be_finite(kernel)) continue;
    count_silent(kernel, check_of(kernel.family), bad, silent);
  }
  return silent;
}

template <class T>
void report_silent(const std::string& name, T bad) {
  const Silent silent = silent_kernels(bad);
  test::report_extreme(name, silent.count, 0, silent.first);
}

TEST(ExtremeValues, NotANumberComesOutOfWhateverDependsOnIt) {
  report_silent("NaN in, ordinary numbers out: all kernels, float", std::numeric_limits<float>::quiet_NaN());
  report_silent("NaN in, ordinary numbers out: all kernels, double", std::numeric_limits<double>::quiet_NaN());
}

TEST(ExtremeValues, InfinityComesOutAsInfinityOrNotANumber) {
  report_silent("infinity in, ordinary numbers out: all kernels, float", std::numeric_limits<float>::infinity());
  report_silent("infinity in, ordinary numbers out: all kernels, double", -std::numeric_limits<double>::infinity());
}

TEST(ExtremeValues, ADirectionOfInfiniteLengthLeavesNoBandOfNumbers) {
  int bands = 0;
  std::string first = "none";
  for (const BoundKernel& kernel : bound_kernels()) {
    if (without_variant(kernel.family) != "basis_normalised") continue;
    std::vector<double> out(coefficient_count(kernel.degree));
    FlatCall<double> call(kernel, check_of("basis_normalised").signature(kernel.degree));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 3> d = {0.3, -0.5, 0.7};
      d[axis] = std::numeric_limits<double>::infinity();
      call(d.data(), out.data());
      for (int l = 1; l <= kernel.degree; ++l) {
        const auto first_of_band = out.begin() + coefficient_index(l, -l);
        const auto last_of_band = out.begin() + coefficient_index(l, l);
        if (std::any_of(first_of_band, last_of_band + 1, [](double v) { return std::isnan(v); })) continue;
        if (bands++ == 0) first = fmt::format("{} component {} band {}", kernel.name(), axis, l);
      }
    }
  }
  test::report_extreme("infinite direction, bands all numbers: basis_normalised, double", bands, 0, first);
}

}  // namespace
}  // namespace sh::numeric
