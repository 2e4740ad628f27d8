// Kernels with a loop over the rows of a table: values, cost, refused kernels, printed code.
#include <gtest/gtest.h>

#include <stdexcept>

#include "codegen/ir/cost.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/ir/ir.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/print/files.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

// out[0] = 3 x[0] + sum over rows of (u x[0] + v x[1]) x[1], out[1] = 3 x[0] for the rows (u, v) = (1, 2), (5, 7).
Kernel probe() {
  Kernel kernel;
  kernel.name = "probe";
  kernel.parameters = {{"x", {2}}};
  kernel.results = {{"out", {2}}};
  kernel.table = {{Surd(1), Surd(2)}, {Surd(5), Surd(7)}};
  Builder build(kernel);
  const NodeId x = build.input(0, "");
  const NodeId y = build.input(1, "");
  const NodeId before = build.mul(build.constant(Surd(3)), x, "before");
  const NodeId u = build.table(0);
  const NodeId v = build.table(1);
  const NodeId ux = build.mul(u, x);
  const NodeId vy = build.mul(v, y);
  const NodeId term = build.mul(build.add(ux, vy), y);
  const NodeId sum = build.row_sum(term, "sum");
  kernel.outputs = {{build.add(before, sum), "first"}, {before, "second"}};
  return kernel;
}

TEST(Loop, AddsUpTheRowsOfTheTable) {
  const Kernel kernel = probe();
  const std::vector<double> input{10, 100};
  EXPECT_EQ(Evaluator<double>(kernel)(input), (std::vector<double>{30 + (10 + 200 + 50 + 700) * 100, 30}));
}

TEST(Loop, CostsItsBodyOnceForEveryRow) {
  const Cost total = cost(probe());
  EXPECT_EQ(total.mul, 1 + 2 * 3);
  EXPECT_EQ(total.add, 2 * 2 + 1);
}

TEST(Loop, PassesKeepItsMeaning) {
  const std::vector<double> input{10, 100};
  const Kernel kernel = passes::schedule(passes::prune(passes::fold(passes::share(probe()))));
  const Kernel unscheduled = probe();
  EXPECT_EQ(Evaluator<double>(kernel)(input), Evaluator<double>(unscheduled)(input));
  EXPECT_EQ(cost(kernel).operations(), cost(probe()).operations());
}

// out = sum over rows of u x[1 + 2 row] for the rows u = 1, 5: an input that moves on.
Kernel striding() {
  Kernel kernel;
  kernel.name = "striding";
  kernel.parameters = {{"x", {4}}};
  kernel.results = {{"out", {1}}};
  kernel.table = {{Surd(1)}, {Surd(5)}};
  Builder build(kernel);
  const NodeId fixed = build.input(1, "");
  const NodeId moving = build.input(1, "", 2);
  const NodeId u = build.table(0);
  kernel.outputs = {{build.row_sum(build.mul(build.mul(u, moving), fixed), "sum"), ""}};
  return kernel;
}

TEST(Loop, InputsWithAStrideMoveOnFromRowToRow) {
  const std::vector<double> input{10, 100, 1000, 10000};
  const Kernel kernel = passes::schedule(passes::prune(passes::fold(passes::share(striding()))));
  const Kernel unrolled = passes::unroll(kernel);
  for (const Kernel* each : {&kernel, &unrolled}) {
    EXPECT_EQ(Evaluator<double>(*each)(input), std::vector<double>{(100.0 + 5 * 10000) * 100});
  }
  const print::Dialect& dialect = print::cpp_dialect();
  EXPECT_EQ(print::make_listing(kernel, dialect).statements.at(3).text,
            "sum = sum + T(table[at+0]) * x[2 * row + 1] * x[1];");
}

TEST(Loop, IsWrittenOutForShadersWhereInputsMoveOn) {
  constexpr print::Scalar kFloat = print::Scalar::kFloat;
  FinishedKernel moving;
  moving.kernel = striding();
  FinishedKernel still;
  still.kernel = probe();
  for (const auto print : {print::glsl_kernel, print::glsl_es_kernel, print::hlsl_kernel}) {
    const std::string text = print(moving, kFloat);
    EXPECT_EQ(text.find("for ("), std::string::npos) << text;
    EXPECT_NE(text.find("result[0] = k * x[1] * x[1] + k_2 * x[3] * x[1];"), std::string::npos) << text;
    EXPECT_NE(print(still, kFloat).find("for (int row"), std::string::npos);
  }
  for (const auto print : {print::cpp_kernel, print::c99_kernel}) {
    EXPECT_NE(print(moving, kFloat).find("for (int row"), std::string::npos);
  }
}

TEST(Loop, RefusesSumsOfNothingAndRowsAfterSums) {
  Kernel constant = probe();
  Builder(constant).row_sum(0);
  EXPECT_THROW(phases(constant), std::logic_error);
  Kernel mixed = probe();
  Builder build(mixed);
  build.mul(build.row_sum(build.table(0)), build.table(1));
  EXPECT_THROW(phases(mixed), std::logic_error);
}

TEST(Loop, IsPrintedWithSumsBeforeItAndStoresAfterIt) {
  std::string text;
  const print::Dialect& dialect = print::cpp_dialect();
  for (const std::string& line : print::statement_lines(print::make_listing(probe(), dialect), dialect)) {
    text += line + "\n";
  }
  EXPECT_EQ(text,
            "  const T before = k * x[0];\n"
            "  T sum = detail::constant<T>(0.0f, 0.0);\n"
            "  for (int row = 0; row < 2; ++row) {\n"
            "    int at = 2 * row;\n"
            "    sum = sum + (T(table[at+0]) * x[0] + T(table[at+1]) * x[1]) * x[1];\n"
            "  }\n"
            "  out[1] = before;        // second\n"
            "  out[0] = before + sum;  // first\n");
}

TEST(Loop, TableStandsInFrontOfTheFunctionInGlsl) {
  const std::string text = print::function(probe(), print::glsl_dialect(print::Scalar::kFloat));
  EXPECT_EQ(text.find("const float probe_table[4] = float[4](\n    1.0, 2.0,\n    5.0, 7.0\n);\n\nvoid probe("), 0U)
      << text;
}

}  // namespace
}  // namespace sh::codegen
