// A family that only this file knows: the value of a function in a direction, times a weight. The test registers it.
// The roles of the family are enough to emit it in every language, mask it, convert it to another convention, check it
// and drive it in batches.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "codegen/choose/mask.hpp"
#include "codegen/convention/in_convention.hpp"
#include "codegen/families/exact.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/output/output_tree.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/parts.hpp"
#include "numeric/kernels/family_check.hpp"
#include "numeric/oracle/basis.hpp"
#include "symbolic/convention/convention.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

constexpr int kDegree = 2;

Kernel dimmed_sum(int degree, int sign) {
  Kernel kernel;
  const int count = coefficient_count(degree);
  kernel.title = "The dimmed value of a function of degree 0 to " + std::to_string(degree);
  kernel.domain = "|d| = 1 for d = (x, y, z)";
  kernel.result = "weight times the sum of c_lm Y_lm(d)";
  kernel.citation = "none";
  kernel.parameters =
      with_direction({array(Role::kEvaluatedCoefficients, "c", degree)}, {parameter(Role::kWeight, "weight")});
  kernel.results = {parameter(Role::kValue, "value")};
  Builder build(kernel);
  const std::vector<NodeId> c = recipes::inputs(build, 0, count, "c");
  const std::vector<NodeId> direction = recipes::inputs(build, count, 3, "d");
  const std::vector<NodeId> basis = recipes::splice(build, recipes::basis_recurrence(degree), direction);
  NodeId sum = build.mul(c[0], basis[0]);
  for (std::size_t i = 1; i < c.size(); ++i) {
    const NodeId term = build.mul(c[i], basis[i]);
    sum = sign > 0 ? build.add(sum, term) : build.sub(sum, term);
  }
  kernel.outputs = {{build.mul(build.input(count + 3, ""), sum), ""}};
  return kernel;
}

Reference dimmed_reference(int degree, int points) {
  const int count = coefficient_count(degree);
  const auto inputs =
      joined(joined(rational_vectors(points, count, 7), rational_directions(points)), rational_vectors(points, 1, 9));
  return reference_at(inputs, [count](const Rationals& input) {
    cln::cl_F sum = precise(0);
    for (int i = 0; i < count; ++i) {
      sum = sum + precise(Surd(input.back() * input[i]) * basis_value(i, std::span(input).subspan(count, 3)));
    }
    return std::vector{sum};
  });
}

// Coefficients of norm 1, a direction, a weight of 1/2.
Inputs dimmed_inputs(int degree) {
  const auto directions = some_test_directions(50);
  const int count = static_cast<int>(directions.size());
  return joined(joined(unit_vectors(count, coefficient_count(degree), 8), directions), Inputs(count, {0.5}));
}

Family dimmed_family(int sign = 1) {
  return {.name = "dimmed",
          .largest_written = kDegree,
          .recipes = {{"sum", [sign](int degree) { return dimmed_sum(degree, sign); }}},
          .reference = dimmed_reference,
          .domain = {.inputs = "coefficient vectors with directions",
                     .unit = "|c| |weight|",
                     .test_inputs = dimmed_inputs,
                     .sizes = {"|c| |weight|"}},
          .batch = BatchDriver{.what = "Dimmed values of functions"}};
}

std::vector<Family> registered() { return {dimmed_family()}; }

FinishedKernel dimmed() { return preferred_kernel(find_family("dimmed", registered()), kDegree, Prefer::kSpeed); }

std::vector<cln::cl_F> exact(const std::vector<double>& values) {
  std::vector<cln::cl_F> result;
  for (const double value : values) result.push_back(cln::cl_float(value, cln::float_format(50)));
  return result;
}

double difference(const cln::cl_F& a, const cln::cl_F& b) { return std::abs(cln::double_approx(a - b)); }

TEST(ToyFamily, IsCheckedAgainstItsExactReferenceAndMeasured) {
  const FinishedKernel finished = dimmed();
  EXPECT_GT(finished.in_float.rounding.eps, 0);
  EXPECT_LT(finished.in_float.rounding.eps, 8);
  const Family wrong = dimmed_family(-1);
  EXPECT_THROW(finish_kernel(wrong, wrong.recipes[0], kDegree), std::runtime_error);
}

TEST(ToyFamily, CompilesInEveryLanguage) {
  for (const Language& language : languages()) test::expect_files_compile_alone(language.name, {dimmed()});
}

TEST(ToyFamily, IsMasked) {
  MaskOptions zonal;
  zonal.left = "zonal";
  const FinishedKernel masked = masked_kernel(dimmed_family(), kDegree, Prefer::kSpeed, zonal);
  EXPECT_LT(masked.cost.operations(), dimmed().cost.operations());
  EXPECT_NE(masked.kernel.domain.find("of c only entries 0, 2, 6"), std::string::npos) << masked.kernel.domain;
}

TEST(ToyFamily, HasTheSameValueInAnotherConvention) {
  const symbolic::Convention ambix = symbolic::find_preset("ambix").convention;
  const FinishedKernel own = dimmed();
  const FinishedKernel theirs = in_convention(own, dimmed_reference(kDegree, kReferencePoints), {"ambix", "x,z,-y"});
  for (const std::vector<double>& input : dimmed_inputs(kDegree)) {
    const std::vector<cln::cl_F> ours = exact(input);
    std::vector<cln::cl_F> stored = ours;
    for (int i = 0; i < coefficient_count(kDegree); ++i) {
      const auto [l, m] = symbolic::degree_order(i);
      const Surd scale = convention_factor(symbolic::Convention{}, l, m) / convention_factor(ambix, l, m);
      stored[storage_position(ambix.order, kDegree, l, m)] = ours[i] * scale.evaluate(50);
    }
    // (x, z, -y) of the caller's direction is ours.
    stored[9] = ours[9];
    stored[10] = -ours[11];
    stored[11] = ours[10];
    const cln::cl_F expected = Evaluator<cln::cl_F>(own.kernel, 50)(ours)[0];
    EXPECT_LT(difference(Evaluator<cln::cl_F>(theirs.kernel, 50)(stored)[0], expected), 1e-40);
  }
}

// The oracle's check uses only the record beside the kernels and exact values: inputs, domain, unit, limit.
TEST(ToyFamily, IsCheckedByTheOracleWithNothingButItsRecord) {
  const RenderedFiles files = render_all([](const std::string& /*kernel*/) {}, registered());
  const numeric::FamiliesRecord record = numeric::parse_record(files.at("families.json"));
  const auto values = [](int degree, const auto* in, auto* out) {
    const int count = coefficient_count(degree);
    const auto basis = numeric::basis(degree, in[count], in[count + 1], in[count + 2]);
    const auto& weight = in[count + 3];
    *out = 0;
    for (const auto& value : basis) *out += weight * *in++ * value;
  };
  const numeric::FamilyCheck check = numeric::make_check(record.families.at(0), {"dimmed", values});
  const double limit = record.limit_factor.total * record.find_kernel("dimmed_l2")->in_double.total;
  const FinishedKernel finished = dimmed();
  Evaluator<double> kernel(finished.kernel);
  for (const numeric::NamedInput& input : check.inputs(kDegree)) {
    const std::vector<long double> given(input.values.begin(), input.values.end());
    std::vector<long double> nearest(given.size());
    check.nearest(kDegree, given.data(), nearest.data());
    long double expected = 0;
    check.oracle(kDegree, nearest.data(), &expected);
    const double size = check.size(kDegree, input.values.data(), 0);
    const auto error = static_cast<double>(std::abs(kernel(input.values)[0] - expected));
    EXPECT_LE(error, limit * size * std::numeric_limits<double>::epsilon()) << input.name;
  }
}

TEST(ToyFamily, IsWrittenWithABatchDriver) {
  const RenderedFiles files = render_all([](const std::string& /*kernel*/) {}, registered());
  for (const char* name : {"cpp/dimmed.hpp", "cpp/dimmed_l0.hpp", "cpp/dimmed_l2.hpp", "glsl/dimmed_l2.glsl"}) {
    EXPECT_EQ(files.count(name), 1U) << name;
  }
  EXPECT_NE(files.at("MANIFEST").find("dimmed_l2 "), std::string::npos);
  EXPECT_NE(files.at("batch/drivers.hpp").find("Records<const float> directions, Records<const float> weight"),
            std::string::npos);
  const test::TemporaryFolder folder;
  make_folder(folder.path() / "generated");
  write_tree(folder.path() / "generated", files);
  const auto compiled = test::run_command("cd " + test::quoted(folder.path()) +
                                          " && g++ -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I. "
                                          "-DSH_BATCH_ISA=baseline generated/batch/dimmed.cpp");
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
}

}  // namespace
}  // namespace sh::codegen
