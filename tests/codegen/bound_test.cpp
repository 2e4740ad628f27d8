// Bounds of rounding errors: they hold for what kernels compute, with and without contraction, and are not far above it.
#include "codegen/bound/bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "codegen/bound/bilinear.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/half.hpp"
#include "codegen/measure/search.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using bound::Bound;
using bound::Interval;
using test::CommandResult;
using test::expect_refused;
using test::run_command;
using test::shgen;
using test::SmallKernel;

Kernel written(const std::string& family, int degree, const std::string& recipe = "") {
  const Family& of = find_family(family);
  const Recipe& chosen = recipe.empty() ? fastest_recipe(of, degree) : find_recipe(of, degree, recipe);
  return kernel_stages(of, chosen, degree).back().kernel;
}

Bound bound_of(const Kernel& kernel, const std::string& scalar) {
  return bound::bound(kernel, find_family(kernel.family).domain, bound::find_format(scalar));
}

template <class T>
double seen_eps(const Kernel& kernel, const Bound& proved) {
  const Domain& domain = find_family(kernel.family).domain;
  return largest_seen<T>(kernel, domain, {proved.worst}, search_evaluations(kernel)).rounding.eps;
}

// In eps, at these inputs and the tested ones.
template <class T>
double error_at(const Kernel& kernel, const Domain& domain, const std::vector<std::vector<double>>& inputs) {
  MeasuredError error = measure<T>(kernel, domain);
  measure_more<T>(error, kernel, domain, inputs);
  return error.rounding.eps;
}

// --- the bound against the largest error that a search finds

struct Tightness {
  const char* family;
  int least_degree = 0;
  int largest_degree = 6;
  double factor = 5;  // the bound is at most this times the largest error seen
  const char* recipe = "";
};

class BoundOf : public testing::TestWithParam<Tightness> {};

TEST_P(BoundOf, IsAtLeastTheLargestErrorSeenAndNotFarAboveIt) {
  const Tightness& of = GetParam();
  for (int degree = of.least_degree; degree <= of.largest_degree; ++degree) {
    if (recipes_for(find_family(of.family), degree).empty()) continue;
    const Kernel kernel = written(of.family, degree, of.recipe);
    for (const std::string scalar : {"half", "float", "double"}) {
      if (degree != 3 && scalar == "half") continue;
      if (degree % 3 != 1 && scalar == "double") continue;
      SCOPED_TRACE(kernel.name + " " + scalar);
      const Bound proved = bound_of(kernel, scalar);
      ASSERT_EQ(proved.missing, "");
      const double seen = scalar == "half"    ? seen_eps<Half>(kernel, proved)
                          : scalar == "float" ? seen_eps<float>(kernel, proved)
                                              : seen_eps<double>(kernel, proved);
      EXPECT_LE(seen, proved.eps);
      EXPECT_LE(proved.eps, of.factor * seen);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, BoundOf,
                         testing::Values(Tightness{"basis", 0, 6, 3}, Tightness{"basis_normalised", 0, 6, 3},
                                         Tightness{"basis_gradient", 0, 6, 3}, Tightness{"evaluate"},
                                         Tightness{"evaluate_rgb", 3}, Tightness{"project", 0, 6, 3},
                                         Tightness{"zonal", 0, 6, 3}, Tightness{"cap", 0, 6, 3},
                                         Tightness{"irradiance", 0, 6, 2}, Tightness{"irradiance_evaluate", 0, 6, 3},
                                         Tightness{"window_hann"}, Tightness{"window_gaussian"},
                                         Tightness{"window_laplacian"}, Tightness{"window_lanczos"},
                                         Tightness{"product"}, Tightness{"product_full", 0, 4, 5.1},
                                         Tightness{"product_zonal", 0, 6, 3}, Tightness{"square"},
                                         Tightness{"rotate_z"}, Tightness{"rotate_quaternion", 2, 3, 5, "polynomial"}),
                         [](const auto& family) { return std::string(family.param.family); });

// Half precision has few inputs, and the largest errors of these kernels are rare among them.
TEST(Bound, OfLargeKernelsInHalfPrecisionIsNotFarAboveTheLargestErrorSeen) {
  const std::pair<const char*, int> kernels[] = {{"product", 6}, {"product_full", 4}, {"rotate_z", 6}};
  for (const auto& [family, degree] : kernels) {
    const Kernel kernel = written(family, degree);
    SCOPED_TRACE(kernel.name);
    const Bound proved = bound_of(kernel, "half");
    ASSERT_EQ(proved.missing, "");
    const double seen = seen_eps<Half>(kernel, proved);
    EXPECT_LE(seen, proved.eps);
    EXPECT_LE(proved.eps, 5 * seen);
  }
}

// Windows have one number as parameter: each of the 30,721 numbers of binary16 from -1 to 1 is looked at.
TEST(Bound, OfWindowsInHalfPrecisionIsThatOfTheWorstOfAllNumbers) {
  for (const char* family : {"window_hann", "window_gaussian"}) {
    for (const int degree : {1, 6}) {
      const Kernel kernel = written(family, degree);
      SCOPED_TRACE(kernel.name);
      const Bound proved = bound_of(kernel, "half");
      ASSERT_EQ(proved.missing, "");
      EXPECT_TRUE(proved.every_number);
      EXPECT_EQ(proved.worst_box[0].width(), 0);
      const double seen = seen_eps<Half>(kernel, proved);
      EXPECT_LE(seen, proved.eps);
      EXPECT_LE(proved.eps, 3 * seen);
    }
    EXPECT_FALSE(bound_of(written(family, 6), "float").every_number);
  }
  EXPECT_EQ(bound_of(written("window_hann", 6), "half").boxes, 2 * 15360 + 1);
}

TEST(Bound, OfBasisOfDegree4IsAtMostFourTimesTheLargestErrorSeen) {
  for (const char* scalar : {"float", "double"}) {
    const CommandResult result = shgen(std::string("bound basis --degree 4 --scalar ") + scalar);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::size_t at = result.out.find("bound / seen");
    ASSERT_NE(at, std::string::npos) << result.out;
    const double ratio = std::stod(result.out.substr(at + 12));
    EXPECT_GE(ratio, 1);
    EXPECT_LE(ratio, 4);
  }
}

// --- spoiled kernels

// The kernel in float with one literal changed by a factor, against its own exact formula.
double error_with_spoiled_constant(const Kernel& kernel, const ExactReal& spoiled, double factor) {
  Evaluator<float> rounded(kernel, [&](const ExactReal& constant) {
    const auto literal = nearest<float>(constant);
    return constant == spoiled ? static_cast<float>(static_cast<double>(literal) * factor) : literal;
  });
  Evaluator<double> formula(kernel);
  const Domain& domain = find_family(kernel.family).domain;
  const Size size = size_of(kernel, domain);
  double most = 0;
  for (const auto& input : domain.test_inputs(kernel.degree)) {
    const std::vector<float> in(input.begin(), input.end());
    const std::vector<float> computed = rounded(in);
    const std::vector<double> exact = formula(std::vector<double>(in.begin(), in.end()));
    for (std::size_t i = 0; i < computed.size(); ++i) {
      most = std::max(most, std::abs(static_cast<double>(computed[i]) - exact[i]) / (size(input, i) * 0x1p-23));
    }
  }
  return most;
}

TEST(Bound, IsExceededIfOneConstantIsSpoiled) {
  constexpr double kSpoiled = 1 + 0x1p-13;  // the last 10 of 24 bits
  for (const char* family : {"basis", "evaluate"}) {
    const Kernel kernel = written(family, 4);
    const Bound proved = bound_of(kernel, "float");
    int constants = 0;
    for (const Node& node : kernel.nodes) {
      if (node.op != Op::kConstant) continue;
      ++constants;
      EXPECT_GT(error_with_spoiled_constant(kernel, node.constant, kSpoiled), proved.eps) << to_string(node.constant);
      EXPECT_LE(error_with_spoiled_constant(kernel, node.constant, 1), proved.eps) << to_string(node.constant);
    }
    EXPECT_GT(constants, 10);
  }
}

// --- contraction

// The kernel as a compiler may contract it: some sums of products are fused, whatever else uses the products.
Kernel contracted(const Kernel& kernel, std::mt19937& random) {
  Kernel result = kernel;
  result.nodes.clear();
  std::vector<NodeId> place;
  const auto is_product = [&](NodeId id) { return kernel.node(id).op == Op::kMul; };
  for (const Node& node : kernel.nodes) {
    Builder build(result);
    const auto at = [&](NodeId id) { return place[id]; };
    const int first = random() % 2 == 0 ? 0 : 1;
    const NodeId product = (node.op == Op::kAdd || node.op == Op::kSub) ? node.args[first] : -1;
    if (product < 0 || !is_product(product) || random() % 4 == 0) {
      place.push_back(build.append(moved(node, place)));
      continue;
    }
    NodeId a = at(kernel.node(product).args[0]);
    const NodeId b = at(kernel.node(product).args[1]);
    NodeId c = at(node.args[1 - first]);
    if (node.op == Op::kSub && first == 1) a = build.neg(a);
    if (node.op == Op::kSub && first == 0) c = build.neg(c);
    place.push_back(build.fma(a, b, c));
  }
  for (Output& output : result.outputs) output.node = place[output.node];
  return result;
}

TEST(Bound, HoldsForEveryWayToContract) {
  std::mt19937 random(1);
  for (const auto& [family, degree] : {std::pair("basis", 3),
                                       {"evaluate", 3},
                                       {"project", 3},
                                       {"zonal", 3},
                                       {"window_hann", 3},
                                       {"product", 3},
                                       {"product", 4},
                                       {"square", 4}}) {
    const Kernel kernel = written(family, degree);
    const Bound proved = bound_of(kernel, "float");
    const Domain& domain = find_family(family).domain;
    const auto worst = search_inputs<float>(kernel, domain, {proved.worst}, 500);
    for (int repeat = 0; repeat < 10; ++repeat) {
      const Kernel fused = contracted(kernel, random);
      EXPECT_LE(error_at<float>(fused, domain, worst), proved.eps) << family;
    }
  }
}

TEST(Bound, AtEveryNumberHoldsForEveryWayToContract) {
  std::mt19937 random(1);
  for (const int degree : {3, 6}) {
    const Kernel kernel = written("window_hann", degree);
    const Bound proved = bound_of(kernel, "half");
    ASSERT_TRUE(proved.every_number);
    std::vector<std::vector<double>> inputs{proved.worst};
    for (int k = -1024; k <= 1024; ++k) {
      inputs.emplace_back(proved.worst.size(), 1.0);  // cosine, then coefficients
      inputs.back()[0] = k / 1024.0;
    }
    double most = 0;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const Kernel fused = contracted(kernel, random);
      most = std::max(most, error_at<Half>(fused, find_family("window_hann").domain, inputs));
    }
    EXPECT_LE(most, proved.eps);
  }
}

TEST(Bound, AtEveryNumberCountsProductsThatAreContractedOnEitherSide) {
  for (const bool first : {true, false}) {
    // x x - (x x + 0), times a coefficient: 0 for rounded products; the rounding of x x where one side takes it unrounded.
    Kernel kernel = written("window_hann", 1);
    Builder build(kernel);
    const auto append = [&](Op op, NodeId a, NodeId b) {  // as it stands, not simplified
      Node node;
      node.op = op;
      node.args = {a, b};
      return build.append(node);
    };
    NodeId x = 0;
    while (kernel.node(x).op != Op::kInput || kernel.node(x).input != 0) ++x;
    const NodeId product = build.mul(x, x);
    const NodeId rounded = append(Op::kAdd, product, build.constant(symbolic::Surd(0)));
    const NodeId factor = first ? append(Op::kSub, product, rounded) : append(Op::kSub, rounded, product);
    for (Output& output : kernel.outputs) {
      if (kernel.node(output.node).op != Op::kMul) continue;
      const auto args = kernel.node(output.node).args;
      output.node = build.mul(factor, kernel.node(args[0]).op == Op::kInput ? args[0] : args[1]);
    }
    const Bound proved = bound_of(kernel, "half");
    ASSERT_TRUE(proved.every_number) << proved.missing;
    EXPECT_GT(proved.eps, 0.2) << first;
    EXPECT_LT(proved.eps, 0.3) << first;
  }
}

// --- bounds that are known

class BoundOfSmallKernel : public SmallKernel {
 protected:
  Bound proved() {
    kernel.family = "basis";
    return bound::bound(kernel, find_family("basis").domain, bound::find_format("float"));
  }
};

TEST_F(BoundOfSmallKernel, IsTheErrorOfOneRounding) {
  // |x y| is at most 1/2 and a little more, where half a unit in the last place is 2^-25.
  output(build.mul(kX, kY));
  EXPECT_NEAR(proved().absolute, 0x1p-25, 1e-15);
}

TEST_F(BoundOfSmallKernel, IsZeroForExactOperations) {
  output(build.add(kX, kX));
  output(build.neg(kY));
  output(build.mul(build.constant(symbolic::Surd(4)), kZ));
  EXPECT_LT(proved().absolute, 1e-40);
}

TEST_F(BoundOfSmallKernel, CountsARoundedConstant) {
  output(build.constant(symbolic::Surd(cln::cl_RA(1) / 3)));
  EXPECT_NEAR(proved().absolute, std::abs(static_cast<double>(1.0F / 3) - 1.0 / 3), 1e-16);
}

TEST_F(BoundOfSmallKernel, CountsTwiceAContractedProductThatIsAlsoUsedElsewhere) {
  // x y - x y is 0 without contraction, but fma(x, y, -(x y)) is the rounding error of x y.
  const NodeId product = build.mul(kX, kY);
  output(build.sub(product, product));
  EXPECT_GE(proved().absolute, 0x1p-27);
}

TEST(Bound, SaysWhyThereIsNone) {
  EXPECT_NE(bound_of(written("triple", 2), "float").missing, "");
  EXPECT_NE(bound_of(written("rotate", 2), "float").missing, "");
  EXPECT_NE(shgen("bound triple --degree 2").out.find("no bound is proved"), std::string::npos);
}

TEST(Bound, RefusesWhatDoesNotExist) {
  expect_refused("bound basis --degree 4 --scalar quad", "expected one of: half, float, double");
  expect_refused("bound basis --degree 99", "expected degree 0 to 20");
  expect_refused("bound nothing --degree 2", "expected one of:");
  expect_refused("bound evaluate --degree 2 --gappa", "got one with coefficients");
}

// --- parts

TEST(Intervals, HoldTheResultsOfTheirNumbers) {
  std::mt19937_64 random(3);
  const auto number = [&] { return std::ldexp(static_cast<double>(random()), -64) * 4 - 2; };
  for (int i = 0; i < 10000; ++i) {
    const double x = number(), y = number(), u = number(), v = number();
    const Interval a{std::min(x, y), std::max(x, y)}, b{std::min(u, v), std::max(u, v)};
    const long double p = x, q = u;
    const auto expect_in = [](long double value, Interval interval) {
      EXPECT_LE(interval.low, value);
      EXPECT_GE(interval.high, value);
    };
    expect_in(p + q, a + b);
    expect_in(p - q, a - b);
    expect_in(p * q, a * b);
    expect_in(p * p, square(a));
    if (b.mignitude() > 0) expect_in(p / q, a / b);
    if (a.low >= 0) expect_in(std::sqrt(p), sqrt(a));
  }
}

// The quadratic form of sums and differences of two numbers: the signs of coefficients count.
TEST(LargestEigenvalue, IsThatOfTheMatrix) {
  constexpr double kNear = 1.002;
  const auto expect = [&](const std::vector<double>& matrix, int size, double eigenvalue) {
    const double found = bound::largest_eigenvalue(matrix, size).at_most;
    EXPECT_GE(found, eigenvalue);
    EXPECT_LE(found, eigenvalue * kNear);
  };
  expect({2, -1, -1, 2}, 2, 3);
  expect({1, 0, 0, 0, 5, 0, 0, 0, 5}, 3, 5);
  expect({1, 1, 1, 1}, 2, 2);
  expect({0, 0, 0, 0}, 2, 0);
  const std::vector<double> vector = bound::largest_eigenvalue({2, -1, -1, 2}, 2).vector;
  EXPECT_NEAR(vector[0] * vector[1], -0.5, 1e-9);
}

TEST(HalfPrecision, RoundsToElevenBits) {
  EXPECT_EQ(static_cast<double>(Half(1 + 0x1p-11)), 1);  // a tie, to even
  EXPECT_EQ(static_cast<double>(Half(1 + 0x1.8p-10)), 1 + 0x1p-9);
  EXPECT_EQ(static_cast<double>(Half(0x1p-25)), 0);
  EXPECT_EQ(static_cast<double>(Half(0x1.8p-24)), 0x1p-23);
  EXPECT_TRUE(std::isinf(static_cast<double>(Half(70000))));
  EXPECT_EQ(static_cast<double>(Half(3) / Half(7)), static_cast<double>(Half(3.0 / 7)));
}

// --- the second opinion

TEST(Gappa, AgreesToDegree4) {
  if (run_command("gappa --version").exit_code != 0) GTEST_SKIP() << "gappa is not installed";
  const sh::test::TemporaryFolder folder;
  for (int degree = 0; degree <= 4; ++degree) {
    const CommandResult script = shgen("bound basis --degree " + std::to_string(degree) + " --gappa");
    ASSERT_EQ(script.exit_code, 0) << script.err;
    const std::string file = folder.file("basis.g");
    std::ofstream(file) << script.out;
    const CommandResult checked = run_command("gappa < " + file);
    EXPECT_EQ(checked.exit_code, 0) << degree << '\n' << checked.err << script.out;
  }
}

}  // namespace
}  // namespace sh::codegen
