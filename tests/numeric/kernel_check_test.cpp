// The comparison finds kernels that are slightly wrong, wrong by formula, not in place, or not described.
#include "numeric/kernels/kernel_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "numeric/kernels/flat_call.hpp"
#include "numeric/kernels/kernel_limits.hpp"

namespace sh::numeric {
namespace {

// A kernel one of whose written values is multiplied by `factor`, in the scalars chosen.
struct Spoil {
  BoundKernel original;
  std::size_t argument = 0, element = 0;
  double factor = 1;
};
Spoil& spoil() {
  static Spoil current;
  return current;
}

template <class T>
void spoiled_call(T* const* arguments) {
  spoil().original.call<T>()(arguments);
  T& value = arguments[spoil().argument][spoil().element];
  value = value * T(static_cast<float>(spoil().factor));
}

// The last value of the kernel's first result times `factor`. (Further results may end in a zero, as derivatives do.)
BoundKernel spoiled(const BoundKernel& kernel, double factor) {
  const auto signature = check_of(kernel.family).signature(kernel.degree);
  spoil() = {kernel, signature.parameters.size(), 0, factor};
  for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
    const auto& parameter = signature.parameters[i];
    if (parameter.is_written()) {
      spoil().argument = i;
      spoil().element = static_cast<std::size_t>(parameter.values()) - 1;
      break;
    }
  }
  BoundKernel result = kernel;
  result.in_float = spoiled_call<float>;
  result.in_double = spoiled_call<double>;
  result.in_wide = spoiled_call<Wide>;
  return result;
}

std::vector<std::string> failures(const BoundKernel& kernel) {
  std::vector<std::string> all;
  for (const auto& result : check_kernel(kernel, {})) {
    for (auto& failure : failures_of(result)) all.push_back(std::move(failure));
  }
  return all;
}

// The kernel of each family that is best to experiment with: small, but of degree 2 where there is one.
std::vector<BoundKernel> one_of_each_family() {
  std::vector<BoundKernel> chosen;
  for (auto& kernel : bound_kernels()) {
    if (chosen.empty() || chosen.back().family != kernel.family) {
      chosen.push_back(std::move(kernel));
    } else if (kernel.degree <= 2) {
      chosen.back() = std::move(kernel);
    }
  }
  return chosen;
}

TEST(KernelCheck, KnowsEveryGeneratedKernel) {
  EXPECT_EQ(unchecked_kernels(bound_kernels()), std::vector<std::string>{});
  EXPECT_EQ(unchecked_kernels({{.family = "unheard_of", .degree = 3, .arguments = {}}}),
            std::vector<std::string>{"unheard_of_l3"});
}

TEST(KernelCheck, PassesAKernelOfEachFamilyAndFailsItWithOneValueWrongByAThousandth) {
  for (const auto& kernel : one_of_each_family()) {
    EXPECT_EQ(failures(kernel), std::vector<std::string>{});
    const auto found = failures(spoiled(kernel, 1.001));
    // Rounding and total error, float and double. The kernel on Wide is spoiled too: a wrong formula does not excuse
    // itself by being its own.
    EXPECT_GE(found.size(), 4) << kernel.name();
  }
}

TEST(KernelCheck, FailsABasisValueThatIsWrongByAFewOfItsLimits) {
  const auto kernels = bound_kernels();
  const auto kernel =
      std::find_if(kernels.begin(), kernels.end(), [](const auto& k) { return k.name() == "basis_l2"; });
  EXPECT_EQ(failures(spoiled(*kernel, 1 + 0x1p-18)).size(), 4);
}

template <class T>
void wrong_in_place(T* const* arguments) {
  spoil().original.call<T>()(arguments);
  if (arguments[1] == arguments[2]) arguments[2][8] = arguments[2][8] + T(1);  // the last output
}

// One output of each of the inputs that are tried: 16, or a few more where 16 does not divide their number.
TEST(KernelCheck, CountsTheValuesThatChangeInPlace) {
  const auto kernels = bound_kernels();
  BoundKernel kernel =
      *std::find_if(kernels.begin(), kernels.end(), [](const auto& k) { return k.name() == "rotate_l2"; });
  spoil().original = kernel;
  kernel.in_float = wrong_in_place<float>;
  kernel.in_double = wrong_in_place<double>;
  for (const auto& result : check_kernel(kernel, {})) {
    EXPECT_GE(result.different_in_place, 16U) << result.scalar;
    EXPECT_LT(result.different_in_place, 24U) << result.scalar;
    EXPECT_EQ(failures_of(result).size(), 1U) << "and nothing else is wrong";
  }
}

// Two inputs of two outputs each; every output has its own size.
TEST(CompareBits, CountsAsFlushedOnlyWhatIsSmallForItsSize) {
  const auto compare = [](const std::vector<float>& cpp, const std::vector<float>& glsl) {
    Samples<float> samples;
    samples.signature = {{scalar("x"), out_array("b", 2)}};
    samples.names = {"here", "there"};
    samples.inputs = {0.0F, 0.0F};
    samples.sizes = {1.0, 1e-3, 1e3, 0.0};
    return compare_bits(2, cpp, glsl, samples);
  };
  constexpr float kLeast = std::numeric_limits<float>::min();
  const BitComparison same = compare({1.0F, -2.0F, kLeast, 0.0F}, {1.0F, -2.0F, kLeast, 0.0F});
  EXPECT_EQ(same.compared, 4U);
  EXPECT_EQ(same.flushed + same.different + same.regrouped, 0U);
  EXPECT_EQ(same.first_difference, "");
  EXPECT_EQ(compare({1.0F, 0.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F, 0.0F}).different, 1U) << "another sign";
  for (const float sign : {1.0F, -1.0F}) {
    const float little = 200.0F * kLeast * sign;
    const float more = 300.0F * kLeast * sign;
    EXPECT_EQ(compare({little, little, little, little}, {0.0F, 0.0F, 0.0F, 0.0F}).flushed, 4U);
    EXPECT_EQ(compare({0.0F, 0.0F, 0.0F, 0.0F}, {little, little, little, little}).flushed, 4U);
    const BitComparison large = compare({more, more, more, more}, {0.0F, 0.0F, 0.0F, 0.0F});
    EXPECT_EQ(large.flushed, 1U);
    EXPECT_EQ(large.different, 3U);
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compare({1.0F, 1.0F, 1.0F, 1.0F}, {nan, 1.0F, 1.0F, 1.0F}).different, 1U);
  const BitComparison two = compare({1.0F, 1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F, 1.5F});
  EXPECT_EQ(two.different, 1U);
  EXPECT_NE(two.first_difference.find("at there: 1.5, c++ 1"), std::string::npos) << two.first_difference;
}

const std::filesystem::path kGenerated = std::filesystem::path(SHFORGE_SOURCE_DIR) / "generated";

// Near the poles some values are below the smallest normal number: they count as flushed, not as different.
TEST(KernelCheck, ComparesEveryBitOfGlslWithFloat) {
  const auto kernels = bound_kernels();
  const auto kernel =
      *std::find_if(kernels.begin(), kernels.end(), [](const auto& k) { return k.name() == "basis_l2"; });
  for (const bool is_spoiled : {false, true}) {
    const auto results = check_kernel(is_spoiled ? spoiled(kernel, 1.001) : kernel, kGenerated);
    ASSERT_EQ(results.size(), 4U);
    for (const KernelResult& result : results) {
      EXPECT_EQ(result.bits.has_value(), result.language != "c++") << result.language;
      EXPECT_EQ(failures_of(result).empty(), !is_spoiled) << "what is flushed is no error";
      if (!result.bits) continue;
      EXPECT_EQ(result.bits->compared, 9 * result.inputs);
      EXPECT_LT(result.bits->flushed, result.inputs / 10);
      EXPECT_EQ(result.bits->regrouped, result.bits->different) << "no grouping makes up for a thousandth";
      EXPECT_GE(result.bits->different, is_spoiled ? result.inputs / 2 : 0U);
      EXPECT_LE(result.bits->different, is_spoiled ? result.inputs : 0U);
      EXPECT_EQ(result.bits->first_difference.find("out l=2 m=2 at axis "), is_spoiled ? 0U : std::string::npos);
    }
  }
}

TEST(KernelCheck, ChecksOneFamilyOrAllAndNamesThem) {
  std::vector<std::string> said;
  const auto note = [&](const std::string& line) { said.push_back(line); };
  const auto results = check_kernels({kGenerated, "cap"}, note);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].find("GLSL: "), 0U);
  EXPECT_EQ(said[1], "checking cap");
  EXPECT_GE(results.size(), 4U * 11U);
  for (const KernelResult& result : results) {
    EXPECT_EQ(without_variant(result.family), "cap");
    EXPECT_EQ(failures_of(result), std::vector<std::string>{})
        << "GLSL may lose values below the smallest normal number";
  }
  ASSERT_EQ(results.size() % 4, 0U);
  for (std::size_t i = 0; i < results.size(); i += 4) {  // as format_summary needs them
    const auto word = [&](std::size_t k) { return results[i + k].language + " " + results[i + k].scalar; };
    EXPECT_EQ((std::vector{word(0), word(1), word(2), word(3)}),
              (std::vector<std::string>{"c++ float", "c++ double", "glsl 450 float", "glsl es 300 float"}));
    for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(results[i + k].kernel, results[i].kernel);
    if (i == 0 || results[i].family != results[i - 4].family) continue;
    EXPECT_GT(results[i].degree, results[i - 4].degree) << results[i].kernel;
  }
  const auto message = [&](const CheckOptions& options) {
    try {
      static_cast<void>(check_kernels(options, note));
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({kGenerated, "caps"}).find("--family: expected one of basis, "), 0U);
  EXPECT_NE(message({"/none", ""}).find("/none"), std::string::npos);
}

void overwriting(double* const* a) {
  a[1][0] = a[0][0];
  a[1][1] = a[0][1] + a[0][0];
}
void overwriting_too_early(double* const* a) {
  a[1][0] = a[0][1];
  a[1][1] = a[0][0];
}

TEST(FlatCall, PassesAnArrayAsInputAndOutputAtOnce) {
  const Signature signature{{in_array("a", 2), out_array("b", 2), in_array("c", 3), in_matrix("d", 2, 1)}};
  const auto pairs = in_place_pairs(signature);
  ASSERT_EQ(pairs.size(), 1);
  const std::vector<double> in = {1, 2, 0, 0, 0, 0, 0};
  std::vector<double> out(2);
  const auto kind = ArgumentKind::kReadArray;
  BoundKernel kernel{.family = "f", .arguments = {kind, ArgumentKind::kWriteArray, kind, kind}};
  kernel.in_double = overwriting;
  FlatCall<double>(kernel, signature).in_place(pairs[0], in.data(), out.data());
  EXPECT_EQ(out, (std::vector<double>{1, 3}));
  kernel.in_double = overwriting_too_early;
  FlatCall<double>(kernel, signature).in_place(pairs[0], in.data(), out.data());
  EXPECT_EQ(out, (std::vector<double>{2, 2}));  // where out of place would give {2, 1}
}

TEST(FlatCall, RefusesAKernelWithOtherArguments) {
  const Signature signature{{scalar("x"), out_array("b", 2)}};
  const BoundKernel kernel{.family = "f", .arguments = {ArgumentKind::kValue, ArgumentKind::kReadArray}};
  EXPECT_THROW(require_match(kernel, signature), std::logic_error);
}

}  // namespace
}  // namespace sh::numeric
