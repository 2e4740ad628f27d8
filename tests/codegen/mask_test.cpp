// Masks remove exactly the entries that a symmetry determines. The masked kernel agrees with the full kernel and costs
// less.
#include "codegen/choose/mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::quoted;
using test::run_command;

MaskOptions options(const std::string& left, const std::string& right = "", const std::string& outputs = "",
                    std::vector<int> bands = {}, std::vector<int> orders = {}) {
  return {left, right, outputs, std::move(bands), std::move(orders)};
}

struct Case {
  std::string family;
  int degree;
  MaskOptions mask;
  int bound;  // operations of the masked kernel
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases{{"product", 3, options("zonal"), 111},
                                        {"product", 3, options("zonal", "zonal"), 48},
                                        {"product", 3, options("mirror-y"), 344},
                                        {"product", 3, options("mirror-y", "mirror-y"), 255},
                                        {"product", 3, options("hemisphere", "mirror-z"), 233},
                                        {"product", 3, options("mirror-xy", "mirror-xy"), 352},
                                        {"product", 3, options("mirror-x,mirror-y,mirror-z"), 102},
                                        {"product", 3, options("", "", "zonal"), 122},
                                        {"product", 3, options("", "", "0,2,6"), 105},
                                        {"product", 3, options("", "", "", {}, {-2, 0, 2}), 106},
                                        {"product", 4, options("", "", "", {0, 1, 2, 4}), 691},
                                        {"product", 4, options("zonal"), 262},
                                        {"square", 3, options("hemisphere"), 137},
                                        {"basis", 4, options("", "", "mirror-y"), 45},
                                        {"basis", 4, options("", "", "hemisphere"), 43},
                                        {"basis", 6, options("", "", "", {0, 2, 4, 6}), 101},
                                        {"zonal", 4, options("", "", "", {0, 1, 2, 4}), 51},
                                        {"zonal", 6, options("", "", "mirror-y"), 112},
                                        {"add_cap", 4, options("", "", "hemisphere"), 77},
                                        {"add_cap_rgb", 3, options("", "", "", {}, {0}), 43},
                                        {"irradiance", 4, options("zonal"), 4},
                                        {"irradiance_evaluate", 4, options("zonal"), 17},
                                        {"irradiance_evaluate", 2, options("mirror-y"), 21},
                                        {"irradiance_matrix", 2, options("mirror-x,mirror-y"), 7},
                                        {"window_hann", 4, options("hemisphere"), 24},
                                        {"lightmap", 1, options("", "", "0,2"), 2}};
  return kCases;
}

std::string name_of(const Case& c) { return c.family + " " + std::to_string(c.degree) + c.mask.arguments(); }

// The masked kernel agrees with the full one, and does not read the entries that it must not read.
void expect_same_values(const Case& c, const Kernel& full, const Kernel& masked) {
  const Mask mask = make_mask(full, c.mask);
  Evaluator<double> all(full);
  Evaluator<double> some(masked);
  for (const std::vector<double>& any : find_family(c.family).domain.test_inputs(c.degree)) {
    const std::vector<double> inputs = masked_inputs(any, mask);
    const std::vector<double> expected = all(inputs);
    const std::vector<double> values = some(inputs);
    std::vector<double> spoilt = inputs;
    for (std::size_t i = 0; i < spoilt.size(); ++i) {
      if (mask.inputs[i].kind != KnownInput::Kind::kFree) spoilt[i] = std::nan("");
    }
    EXPECT_EQ(some(spoilt), values) << name_of(c);
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_NEAR(values[i], expected[masked.element(i)], 2e-14) << name_of(c) << " " << masked.outputs[i].label;
    }
  }
}

TEST(Masks, LeaveKernelsThatCostLessAndComputeWhatTheFullOnesDo) {
  for (const Case& c : cases()) {
    const Family& family = find_family(c.family);
    for (const Recipe& recipe : recipes_for(family, c.degree)) {
      const Kernel full = kernel_stages(family, recipe, c.degree).back().kernel;
      const Kernel masked = masked_stages(family, recipe, c.degree, c.mask).back().kernel;
      EXPECT_LT(cost(masked).operations(), cost(full).operations()) << name_of(c) << " " << recipe.name;
      expect_same_values(c, full, masked);
    }
    const FinishedKernel masked = masked_kernel(family, c.degree, Prefer::kSpeed, c.mask);
    EXPECT_LE(masked.cost.operations(), c.bound) << name_of(c);
  }
}

TEST(Masks, SpeakOfEntriesByDegreeAndOrderOnly) {
  // The array has as many entries as coefficients have, but they belong to monomials.
  const Family& prepared = find_family("evaluate_prepared");
  const Family& prepare = find_family("evaluate_prepare");
  EXPECT_THROW(masked_kernel(prepared, 2, Prefer::kSpeed, options("zonal")), std::invalid_argument);
  EXPECT_THROW(masked_kernel(prepare, 2, Prefer::kSpeed, options("", "", "zonal")), std::invalid_argument);
  EXPECT_NO_THROW(masked_kernel(prepare, 2, Prefer::kSpeed, options("zonal", "", "0,2")));
}

TEST(Masks, OfZonalOperandsLeaveZonalProducts) {
  const Family& product = find_family("product");
  const Kernel kernel = masked_stages(product, recipes_for(product, 2)[0], 2, options("zonal", "zonal")).back().kernel;
  for (std::size_t i = 0; i < kernel.outputs.size(); ++i) {
    const Node& node = kernel.node(kernel.outputs[i].node);
    const bool zero = node.op == Op::kConstant && is_zero(node.constant);
    EXPECT_EQ(zero, i != 0 && i != 2 && i != 6) << i;
  }
}

// sum c_lm Y_lm(d), 40 digits
cln::cl_F value_at(const std::vector<cln::cl_RA>& c, const std::vector<cln::cl_RA>& d) {
  cln::cl_F sum = cln::cl_float(0, cln::float_format(40));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const int l = static_cast<int>(std::sqrt(static_cast<double>(i)));
    const symbolic::BasisFunction f = symbolic::basis_function(l, static_cast<int>(i) - l * (l + 1));
    sum = sum + (symbolic::Surd(c[i] * f.homogeneous.evaluate(d)) * f.factor).evaluate(40);
  }
  return sum;
}

// The image of the direction under the symmetry.
std::vector<cln::cl_RA> mapped(const std::string& symmetry, const std::array<cln::cl_RA, 3>& d) {
  if (symmetry == "mirror-x") return {-d[0], d[1], d[2]};
  if (symmetry == "mirror-y") return {d[0], -d[1], d[2]};
  if (symmetry == "mirror-z" || symmetry == "hemisphere") return {d[0], d[1], -d[2]};
  if (symmetry == "mirror-xy") return {d[1], d[0], d[2]};
  // zonal: about z by an angle with cosine 3/5 and sine 4/5, no fraction of a turn
  const cln::cl_RA c = cln::cl_RA(3) / 5;
  const cln::cl_RA s = cln::cl_RA(4) / 5;
  return {c * d[0] - s * d[1], s * d[0] + c * d[1], d[2]};
}

TEST(Masks, SymmetriesDescribeExactlyTheFunctionsThatHaveThem) {
  constexpr int kDegree = 6;
  const Kernel kernel = recipe_kernel(find_family("irradiance"), find_family("irradiance").recipes[0], kDegree);
  for (const std::string symmetry : {"zonal", "mirror-x", "mirror-y", "mirror-z", "hemisphere", "mirror-xy"}) {
    const Mask mask = make_mask(kernel, options(symmetry));
    const auto free = std::count_if(mask.inputs.begin(), mask.inputs.end(),
                                    [](const KnownInput& known) { return known.kind == KnownInput::Kind::kFree; });
    // A mirror halves every band except for one function. Each band has one zonal function.
    EXPECT_EQ(free, symmetry == "zonal" ? kDegree + 1 : (kDegree + 1) * (kDegree + 2) / 2) << symmetry;
    for (const auto& any : rational_vectors(3, numeric::coefficient_count(kDegree), 12)) {
      const std::vector<cln::cl_RA> c = masked_inputs(any, mask);
      for (const auto& d : rational_directions(3)) {
        const cln::cl_F difference = value_at(c, {d[0], d[1], d[2]}) - value_at(c, mapped(symmetry, d));
        EXPECT_LT(cln::double_approx(cln::abs(difference)), 1e-30) << symmetry;
      }
    }
  }
}

TEST(Masks, SeveralSymmetriesHoldTogether) {
  const Kernel kernel = recipe_kernel(find_family("irradiance"), find_family("irradiance").recipes[0], 5);
  const Mask mask = make_mask(kernel, options("mirror-xy,mirror-y"));
  for (const auto& any : rational_vectors(2, 36, 13)) {
    const std::vector<cln::cl_RA> c = masked_inputs(any, mask);
    for (const auto& d : rational_directions(2)) {
      for (const std::string symmetry : {"mirror-x", "mirror-y", "mirror-xy"}) {  // x follows from the two
        const cln::cl_F difference = value_at(c, {d[0], d[1], d[2]}) - value_at(c, mapped(symmetry, d));
        EXPECT_LT(cln::double_approx(cln::abs(difference)), 1e-30) << symmetry;
      }
    }
  }
}

TEST(Masks, MergeEntriesOfAllChannels) {
  const Kernel kernel = recipe_kernel(find_family("add_cap_rgb"), find_family("add_cap_rgb").recipes[0], 1);
  const Mask mask = make_mask(kernel, options("mirror-xy"));
  const std::size_t sum = 7;  // x, y, z, one_minus_cos, r, g, b
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const KnownInput& known = mask.inputs[sum + 4 * channel + 1];
    EXPECT_EQ(known.kind, KnownInput::Kind::kSame);
    EXPECT_EQ(known.of, static_cast<int>(sum + 4 * channel + 3));
  }
}

std::string shgen(const std::string& arguments) {
  const auto result = test::shgen(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

TEST(EmittedMasks, AreReproducedByTheLineInTheirHead) {
  for (const std::string arguments :
       {"irradiance_evaluate --degree 3 --left mirror-y --lang c99", "basis --degree 3 --outputs 0,2,6,12 --lang glsl",
        "zonal --degree 4 --keep-bands 0,4 --keep-orders=-4,0,1 --prefer accuracy --lang cpp",
        "product --degree 2 --left zonal --outputs mirror-y --convention directxmath --lang hlsl"}) {
    const std::string text = shgen(std::string("emit ") + arguments);
    const std::string label = "shgen ";
    const std::size_t start = text.find(label) + label.size();
    EXPECT_EQ(shgen(text.substr(start, text.find('\n', start) - start)), text) << arguments;
  }
}

TEST(EmittedMasks, NeverWriteWhatIsDroppedAndNeverReadWhatIsKnown) {
  const test::TemporaryFolder folder;
  test::write_file(folder.path() / "kernel.hpp", shgen("emit add_cap --degree 2 --outputs zonal --lang cpp"));
  test::write_file(folder.path() / "form.hpp", shgen("emit irradiance_evaluate --degree 2 --left zonal --lang cpp"));
  test::write_file(folder.path() / "main.cpp", R"(
#include "kernel.hpp"
#include "form.hpp"
#include <cmath>
int main() {
  float sum[9];
  for (float& s : sum) s = NAN;
  sum[0] = sum[2] = sum[6] = 1;
  sh::add_cap_outputs_zonal_l2(0.48f, 0.6f, 0.64f, 0.5f, 1.0f, sum);
  for (int i = 0; i < 9; ++i)
    if (std::isnan(sum[i]) != (i != 0 && i != 2 && i != 6)) return 1;
  return std::isnan(sh::irradiance_evaluate_left_zonal_l2(sum, 0.48f, 0.6f, 0.64f)) ? 2 : 0;
}
)");
  const std::string binary = quoted(folder.path() / "main");
  const auto compiled = run_command("g++ -std=c++17 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -o " +
                                    binary + " " + quoted(folder.path() / "main.cpp"));
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_EQ(run_command(binary).exit_code, 0);
}

TEST(EmittedMasks, BadArgumentsAreOneLineAndExitTwo) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"basis --degree 3 --left zonal", "basis has 0 coefficient arrays"},
      {"irradiance --degree 3 --right zonal", "irradiance has 1 coefficient arrays"},
      {"irradiance --degree 3 --left round", "unknown symmetry 'round': expected one of: zonal, mirror-x"},
      {"irradiance --degree 3 --keep-bands 0,4", "--keep-bands: expected 0 to 3, got 4"},
      {"irradiance --degree 3 --keep-orders=-4", "--keep-orders: expected -3 to 3, got -4"},
      {"irradiance --degree 3 --outputs 16", "expected a number from 0 to 15 or a symmetry such as zonal, got '16'"},
      {"irradiance --degree 3 --outputs 1,,2", "got ''"},
      {"irradiance --degree 3 --outputs round", "unknown symmetry 'round'"},
      {"irradiance --degree 3 --left zonal --outputs 1", "leaves no result"},
      {"irradiance_evaluate --degree 3 --outputs zonal", "returns one number"},
      {"irradiance_matrix --degree 2 --outputs zonal", "holds no coefficients"},
      {"irradiance --degree 3 --keep-bands two", "two"}};
  for (const auto& [arguments, part] : bad) {
    EXPECT_EQ(test::expect_refused("emit --lang cpp " + arguments, part).out, "") << arguments;
  }
}

}  // namespace
}  // namespace sh::codegen
