#include "codegen/passes/passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "codegen/ir/cost.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/ir/literal.hpp"
#include "codegen/print/describe.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

class Associate : public test::SmallKernel {};
class Costs : public test::SmallKernel {};
class Evaluation : public test::SmallKernel {};
class Factor : public test::SmallKernel {};
class Fold : public test::SmallKernel {};
class Ir : public test::SmallKernel {};
class Prune : public test::SmallKernel {};
class Schedule : public test::SmallKernel {};
class Share : public test::SmallKernel {};

std::vector<double> values(const Kernel& kernel) {
  const std::vector<double> point{0.3125, -1.75, 2.5};
  return Evaluator<double>(kernel)(point);
}

TEST_F(Share, ComputesCommutedProductsAndSumsOnce) {
  const NodeId xy = build.mul(kX, kY);
  const NodeId yx = build.mul(kY, kX);
  output(build.add(xy, kZ));
  output(build.add(kZ, yx));
  const Kernel shared = passes::share(kernel);
  EXPECT_EQ(cost(shared).mul, 1);
  EXPECT_EQ(cost(shared).add, 1);
  EXPECT_EQ(values(shared), values(kernel));
}

TEST_F(Share, KeepsDifferencesOfSwappedOperandsApart) {
  const NodeId xy = build.sub(kX, kY);
  const NodeId yx = build.sub(kY, kX);
  output(xy);
  output(yx);
  EXPECT_EQ(cost(passes::share(kernel)).add, 2);
  EXPECT_EQ(values(passes::share(kernel)), values(kernel));
}

TEST_F(Share, MergesEqualConstantsAndKeepsAName) {
  const NodeId a = build.constant(Surd::square_root(8));
  const NodeId b = build.constant(Surd(2) * Surd::square_root(2), "root");
  const NodeId ax = build.mul(a, kX);
  const NodeId bx = build.mul(b, kX);
  output(build.add(ax, bx));
  const Kernel shared = passes::share(kernel);
  EXPECT_EQ(shared.nodes.size(), 6U);
  EXPECT_EQ(shared.nodes[3].name, "root");
}

TEST_F(Factor, WritesACubicOfARecurrenceAsZTimesALinearFormInZSquared) {
  // P3 = (5/3 z) P2 - 2/3 z with P2 = (3/2 z) z - 1/2, both wanted.
  const auto constant = [&](long p, long q) { return build.constant(Surd(cln::cl_RA(p) / q)); };
  const NodeId k32 = constant(3, 2);
  const NodeId k12 = constant(1, 2);
  const NodeId k53 = constant(5, 3);
  const NodeId k23 = constant(2, 3);
  const NodeId z32 = build.mul(k32, kZ);
  const NodeId p2 = build.sub(build.mul(z32, kZ), k12, "p_2_0");
  const NodeId z53 = build.mul(k53, kZ);
  const NodeId first = build.mul(z53, p2);
  const NodeId second = build.mul(k23, kZ);
  output(p2);
  output(build.sub(first, second, "p_3_0"));
  const Kernel factored = passes::factor(passes::share(kernel));
  EXPECT_EQ(cost(kernel).mul, 5);
  EXPECT_EQ(cost(factored).mul, 4);  // z^2, 3/2 z^2, 5/2 z^2, z (...)
  EXPECT_EQ(cost(factored).add, 2);
  EXPECT_NEAR(values(factored)[1], values(kernel)[1], 1e-14);
}

TEST_F(Factor, FoldsConstantsAndExactDoublings) {
  const NodeId xy = build.mul(kX, kY);
  const NodeId twice = build.add(xy, xy);
  const NodeId k = build.constant(Surd::square_root(3));
  output(build.mul(k, twice));
  const Kernel factored = passes::factor(kernel);
  EXPECT_EQ(cost(factored).mul, 2);
  EXPECT_EQ(cost(factored).add, 0);
  EXPECT_DOUBLE_EQ(values(factored)[0], values(kernel)[0]);
}

TEST_F(Factor, LeavesAloneWhatWouldCostMore) {
  // (a z) x and (a z) y need three products in this form, and four products with one constant each.
  const NodeId a = build.constant(Surd::square_root(3));
  const NodeId az = build.mul(a, kZ);
  output(build.mul(az, kX));
  output(build.mul(az, kY));
  EXPECT_EQ(print::dump(passes::factor(kernel)), print::dump(kernel));
}

TEST_F(Factor, NeverAddsConstantsWhoseRadicalsDiffer) {
  const NodeId a = build.constant(Surd::square_root(2));
  const NodeId b = build.constant(Surd::square_root(3));
  const NodeId az = build.mul(a, kZ);
  const NodeId bz = build.mul(b, kZ);
  output(build.add(az, bz));
  EXPECT_EQ(values(passes::factor(kernel)), values(kernel));
}

// a u + b v, each in a kernel of its own, for all monomials u and v of two inputs up to degree 3.
TEST_F(Factor, ChangesNoValueWhateverTheMonomialsOfASum) {
  const auto monomial = [&](NodeId node, int i, int j) {
    for (int k = 0; k < i; ++k) node = build.mul(node, kY);
    for (int k = 0; k < j; ++k) node = build.mul(node, kZ);
    return node;
  };
  for (int code = 0; code < 256; ++code) {
    const std::array<int, 4> power = {code % 4, code / 4 % 4, code / 16 % 4, code / 64};
    if (power[0] + power[1] > 3 || power[2] + power[3] > 3) continue;
    for (const bool minus : {false, true}) {
      kernel = test::empty_kernel();
      const NodeId u = monomial(build.constant(Surd::square_root(3)), power[0], power[1]);
      const NodeId v = monomial(build.constant(Surd(-2) / Surd(7)), power[2], power[3]);
      output(minus ? build.sub(u, v) : build.add(u, v));
      const double expected = values(kernel)[0];
      EXPECT_NEAR(values(passes::factor(passes::share(kernel)))[0], expected, 1e-14) << print::dump(kernel);
    }
  }
}

TEST_F(Factor, AddsProductsWhoseFactorsStandInAnotherOrder) {
  const NodeId a = build.constant(Surd::square_root(3));
  const NodeId b = build.constant(Surd(2) * Surd::square_root(3));
  output(build.add(build.mul(build.mul(a, kX), kY), build.mul(build.mul(b, kY), kX)));  // 3 sqrt(3) x y
  const Kernel factored = passes::factor(kernel);
  EXPECT_EQ(cost(factored).operations(), 2) << print::dump(factored);
  EXPECT_DOUBLE_EQ(values(factored)[0], values(kernel)[0]);
}

TEST_F(Factor, ChangesNoValueOfThreeFactorsOrOfAFusedProduct) {
  for (const bool fused : {false, true}) {
    kernel = test::empty_kernel();
    const NodeId a = build.constant(Surd::square_root(3));
    const NodeId b = build.constant(Surd::square_root(5));
    const NodeId ax = build.mul(a, kX);
    const NodeId by = build.mul(b, kY);
    output(fused ? build.fma(ax, b, by) : build.mul(build.mul(ax, by), kZ));
    EXPECT_NEAR(values(passes::factor(kernel))[0], values(kernel)[0], 1e-14) << fused;
  }
}

TEST_F(Factor, DropsTermsThatCancel) {
  const NodeId k = build.constant(Surd::square_root(3));
  const NodeId xz = build.mul(kX, kZ);
  output(build.sub(build.add(xz, build.mul(k, kZ)), xz));  // k z
  const Kernel factored = passes::factor(kernel);
  EXPECT_EQ(cost(factored).operations(), 1) << print::dump(factored);
  EXPECT_DOUBLE_EQ(values(factored)[0], values(kernel)[0]);
}

TEST_F(Associate, PutsAConstantFirstInAProductThatIsUsedOnce) {
  const NodeId xy = build.mul(kX, kY);
  output(build.mul(build.constant(Surd::square_root(3)), xy));
  const Kernel regrouped = passes::associate(kernel);
  const Node& outer = regrouped.node(regrouped.outputs[0].node);
  EXPECT_EQ(regrouped.node(regrouped.node(outer.args[0]).args[0]).op, Op::kConstant);
  EXPECT_EQ(regrouped.node(outer.args[1]).op, Op::kInput);
  EXPECT_EQ(cost(regrouped).mul, 2);
  EXPECT_NEAR(values(regrouped)[0], values(kernel)[0], 1e-15);
}

TEST_F(Associate, LeavesAloneAProductThatServesTwice) {
  const NodeId xy = build.mul(kX, kY);
  const NodeId k = build.constant(Surd::square_root(3));
  output(build.mul(k, xy));
  output(xy);
  EXPECT_EQ(cost(passes::associate(kernel)).mul, 2);
  EXPECT_EQ(values(passes::associate(kernel)), values(kernel));
}

// What is no longer the product of x and y no longer has its name.
TEST_F(Associate, TakesTheNameFromTheProductThatItTakesApart) {
  const NodeId xy = build.mul(kX, kY, "xy");
  output(build.mul(build.constant(Surd::square_root(3), "k"), xy, "kxy"));
  const Kernel regrouped = passes::associate(kernel);
  const auto named = [&](const std::string& name) {
    return std::count_if(regrouped.nodes.begin(), regrouped.nodes.end(), [&](const Node& n) { return n.name == name; });
  };
  EXPECT_EQ(named("xy"), 0);
  EXPECT_EQ(named("kxy"), 1);
  EXPECT_EQ(named("k"), 1);
}

// Products of three inputs, and those whose inner product has a constant: for all of them the order is that of the recipe.
TEST_F(Associate, LeavesAloneProductsOfNoConstantOrOfTwo) {
  const NodeId k = build.constant(Surd::square_root(3));
  const NodeId c = build.constant(Surd::square_root(5));
  output(build.mul(kX, build.mul(kY, kZ)));
  output(build.mul(build.mul(kY, kX), kZ));
  output(build.mul(k, build.mul(c, kX)));
  output(build.mul(build.mul(kY, c), k));
  const Kernel same = passes::associate(kernel);
  const auto products = [](const Kernel& of) {
    std::vector<std::array<std::string, 2>> found;  // the operations of their factors, where inputs have names
    for (const Node& node : of.nodes) {
      if (node.op != Op::kMul) continue;
      const auto word = [&](NodeId id) { return op_name(of.node(id).op) + of.node(id).name; };
      found.push_back({word(node.args[0]), word(node.args[1])});
    }
    return found;
  };
  EXPECT_EQ(products(same), products(kernel));
  EXPECT_EQ(values(same), values(kernel));
}

TEST_F(Prune, DropsWhatReachesNoOutput) {
  build.mul(kX, kY);
  build.constant(Surd(5));
  output(build.neg(kZ));
  const Kernel pruned = passes::prune(kernel);
  EXPECT_EQ(pruned.nodes.size(), 2U);
  EXPECT_EQ(cost(pruned).operations(), cost(kernel).operations());
  EXPECT_EQ(values(pruned), values(kernel));
}

TEST_F(Schedule, LowersTheNumberOfLiveValues) {
  // The kernel computes four squares first and uses them one by one later.
  std::vector<NodeId> powers{kX};
  for (int i = 0; i < 6; ++i) powers.push_back(build.mul(powers.back(), kY));
  for (const NodeId power : powers) output(build.add(power, kZ));
  const Kernel scheduled = passes::schedule(kernel);
  EXPECT_LT(cost(scheduled).max_live, cost(kernel).max_live);
  EXPECT_EQ(cost(scheduled).max_live, 4);
  EXPECT_EQ(values(scheduled), values(kernel));
}

TEST_F(Schedule, PutsSlowOperationsFirst) {
  const NodeId sum = build.add(kX, kY);
  output(build.mul(sum, kZ));
  const NodeId square = build.mul(kX, kX);
  output(build.div(kY, build.sqrt(square)));
  const Kernel scheduled = passes::schedule(kernel);
  std::vector<Op> order;
  for (const Node& node : scheduled.nodes) {
    if (argument_count(node.op) > 0) order.push_back(node.op);
  }
  EXPECT_EQ(order, (std::vector<Op>{Op::kMul, Op::kSqrt, Op::kDiv, Op::kAdd, Op::kMul}));
  EXPECT_EQ(values(scheduled), values(kernel));
}

TEST_F(Costs, CountsOperationsThatReachAnOutputOnly) {
  const NodeId dead = build.mul(kX, kX);
  build.add(dead, kY);
  const NodeId product = build.mul(kX, kY);
  const NodeId sum = build.sub(product, kZ);
  output(build.fma(sum, kX, build.neg(product)));
  const Cost c = cost(kernel);
  EXPECT_EQ(c.mul, 1);
  EXPECT_EQ(c.add, 1);
  EXPECT_EQ(c.neg, 1);
  EXPECT_EQ(c.fma, 1);
  EXPECT_EQ(c.depth, 3);
}

/// Whether node v holds a value that the kernel needs at the time of node `now` or later, by the definition.
bool is_live_at(const Kernel& kernel, const std::vector<bool>& reaches_output, NodeId v, NodeId now) {
  const Op op = kernel.node(v).op;
  if (!reaches_output[v] || op == Op::kConstant || op == Op::kTable) return false;
  if (now < v) return op == Op::kInput;
  bool is_live = now == v;
  for (NodeId user = now + 1; user < kernel.size(); ++user) {
    const auto args = arguments(kernel.node(user));
    is_live = is_live || (reaches_output[user] && std::find(args.begin(), args.end(), v) != args.end());
  }
  return is_live;
}

int most_live(const Kernel& kernel) {
  const std::vector<bool> reaches_output = live_nodes(kernel);
  int most = 0;
  for (NodeId now = 0; now < kernel.size(); ++now) {
    int live = 0;
    for (NodeId v = 0; v < kernel.size(); ++v) live += is_live_at(kernel, reaches_output, v, now) ? 1 : 0;
    most = std::max(most, live);
  }
  return most;
}

// Kernels of random operations, many of which reach no output; some have the table of a loop.
TEST_F(Costs, CountsTheMostValuesThatAreLiveAtOnce) {
  std::mt19937 random(5);
  for (int count = 0; count < 300; ++count) {
    Kernel any = test::empty_kernel();
    Builder more(any);
    const auto operand = [&] { return static_cast<NodeId>(random() % any.nodes.size()); };
    for (int i = 0; i < 3 + count % 12; ++i) {
      switch (random() % 5) {
        case 0:
          more.constant(Surd(7));
          break;
        case 1:
          more.neg(operand());
          break;
        case 2:
          if (count % 3 == 0) more.table(0);
          break;
        case 3:
          more.fma(operand(), operand(), operand());
          break;
        default:
          more.mul(operand(), operand());
      }
    }
    for (int i = 0; i < 2; ++i) any.outputs.push_back({operand(), "out"});
    EXPECT_EQ(cost(any).max_live, most_live(any)) << count;
  }
}

TEST_F(Evaluation, FusedMultiplyAddRoundsOnce) {
  output(build.fma(kX, kY, kZ));
  const float e = std::ldexp(1.0F, -20);
  const std::vector<float> point{1 + e, 1 - e, -1};
  EXPECT_EQ(Evaluator<float>(kernel)(point)[0], -e * e);
}

TEST_F(Fold, ResolvesZeroOneAndSigns) {
  const NodeId zero = build.constant(Surd(0));
  const NodeId one = build.constant(Surd(1));
  const NodeId minus_one = build.neg(one);
  const NodeId dropped = build.mul(zero, build.add(kX, kY));
  output(build.add(dropped, build.mul(one, kZ)));           // z
  output(build.sub(kX, build.mul(minus_one, kY)));          // x + y
  output(build.sub(dropped, build.neg(kX)));                // x
  output(build.sub(build.mul(kX, kY), build.mul(kY, kX)));  // 0
  const Kernel shared = passes::fold(kernel);
  EXPECT_EQ(cost(shared).operations(), 1) << print::dump(shared);
  EXPECT_EQ(values(shared), values(kernel));
}

TEST_F(Fold, LeavesNoOperationThatZeroOrOneMakesNeedlessOnEitherSide) {
  const NodeId zero = build.constant(Surd(0));
  const NodeId one = build.constant(Surd(1));
  const NodeId two = build.constant(Surd(2));
  for (const NodeId node : {build.add(kX, zero), build.add(zero, kX), build.sub(kX, zero), build.sub(kX, kX),
                            build.mul(kX, one), build.mul(one, kX), build.mul(kX, zero), build.mul(zero, kX),
                            build.neg(build.neg(kX)), build.neg(two), build.add(two, one), build.sub(two, one),
                            build.mul(two, two), build.mul(build.neg(one), build.neg(kX)), build.add(zero, zero)}) {
    output(node);
  }
  const Kernel folded = passes::fold(kernel);
  EXPECT_EQ(cost(folded).operations(), 0) << print::dump(folded);
  EXPECT_EQ(values(folded), values(kernel));
  output(build.add(kX, build.neg(kY)));
  output(build.add(build.neg(kY), kX));
  EXPECT_EQ(cost(passes::share(passes::fold(kernel))).operations(), 1) << "both are x - y";
  output(build.sub(kX, build.neg(kY)));
  output(build.sub(zero, kX));
  for (const NodeId node : {build.add(two, kX), build.sub(kX, two), build.mul(two, kX)}) output(node);
  const Kernel more = passes::share(passes::fold(kernel));
  EXPECT_EQ(cost(more).operations(), 6) << "x + y, -x and three with 2 beside it: " << print::dump(more);
  EXPECT_EQ(values(more), values(kernel));
}

TEST_F(Evaluation, DividesTakesRootsAndSelects) {
  output(build.div(kX, kZ));
  output(build.sqrt(kZ));
  output(build.select(kY, kX, kZ, kX));
  output(build.select(kX, kX, kZ, kY));
  EXPECT_EQ(values(kernel), (std::vector<double>{0.125, std::sqrt(2.5), 2.5, -1.75}));
  EXPECT_EQ(cost(kernel).operations(), 4);
}

TEST(ExactReal, ComputedConstantsMultiplyAndDivideExactly) {
  const auto root = [](int n) {
    return Computed("zero of " + std::to_string(n) + " cos x", [n](int digits) {
      return cln::pi(cln::float_format(digits + 3)) / cln::cl_float(cln::cl_I(n), cln::float_format(digits + 3));
    });
  };
  const ExactReal a = root(3);
  const ExactReal b = root(5);
  EXPECT_EQ(multiply(a, b), multiply(b, a));
  EXPECT_EQ(multiply(multiply(a, b), reciprocal(b)), a);
  EXPECT_EQ(multiply(a, reciprocal(a)), ExactReal(Surd(1)));
  EXPECT_EQ(to_string(multiply(multiply(Surd(-2), a), reciprocal(multiply(b, b)))),
            "-2 zero of 3 cos x / zero of 5 cos x^2");
  EXPECT_EQ(add(a, multiply(Surd(2), a)), multiply(Surd(3), a));
  EXPECT_EQ(add(a, negate(a)), ExactReal(Surd()));
  EXPECT_EQ(add(a, b), std::nullopt);
  EXPECT_EQ(nearest<double>(multiply(a, reciprocal(b))), 5.0 / 3);
}

// Every pair of surds, computed reals and zero: values to 40 digits, and one order of all of them.
TEST(ExactReal, SumsAndProductsOfAllKindsHaveTheirValues) {
  const auto part_of_pi = [](int n) {
    return ExactReal(Computed("pi/" + std::to_string(n), [n](int digits) {
      return cln::pi(cln::float_format(digits + 3)) / cln::cl_float(cln::cl_I(n), cln::float_format(digits + 3));
    }));
  };
  const ExactReal a = part_of_pi(3);
  const ExactReal b = part_of_pi(5);
  const ExactReal root = Surd::square_root(3);
  const std::vector<ExactReal> all = {Surd(0),
                                      Surd(1),
                                      Surd(-1),
                                      Surd(2),
                                      root,
                                      a,
                                      negate(a),
                                      multiply(Surd(2), a),
                                      b,
                                      multiply(a, b),
                                      reciprocal(multiply(b, b)),
                                      multiply(root, multiply(a, reciprocal(b)))};
  const auto is_near = [](const cln::cl_F& x, const cln::cl_F& y) {
    return cln::abs(x - y) < cln::cl_float(1e-40, cln::float_format(50));
  };
  for (const ExactReal& x : all) {
    for (const ExactReal& y : all) {
      const std::string pair = to_string(x) + " and " + to_string(y);
      EXPECT_EQ(multiply(x, y), multiply(y, x)) << pair;
      EXPECT_TRUE(is_near(evaluate(multiply(x, y), 50), evaluate(x, 50) * evaluate(y, 50))) << pair;
      EXPECT_EQ(add(x, y), add(y, x)) << pair;
      if (const auto sum = add(x, y)) {
        EXPECT_TRUE(is_near(evaluate(*sum, 50), evaluate(x, 50) + evaluate(y, 50))) << pair;
      }
      EXPECT_EQ((x < y ? 1 : 0) + (y < x ? 1 : 0), x == y ? 0 : 1) << pair;
      for (const ExactReal& z : all) EXPECT_TRUE(!(x < y && y < z) || x < z) << pair << " and " << to_string(z);
    }
    EXPECT_EQ(add(x, Surd(0)), x);
    EXPECT_EQ(is_negative(x), cln::minusp(evaluate(x, 50))) << to_string(x);
  }
  EXPECT_EQ(add(root, Surd(1)), std::nullopt);
  EXPECT_EQ(add(a, Surd(1)), std::nullopt);
  EXPECT_EQ(to_string(a), "pi/3");
  EXPECT_EQ(to_string(negate(a)), "-pi/3");
  EXPECT_EQ(to_string(multiply(a, a)), "pi/3^2");
  EXPECT_EQ(to_string(reciprocal(a)), "1 / pi/3");
  EXPECT_EQ(to_string(negate(reciprocal(a))), "-1 / pi/3");
}

// Each factor errs as much as it may; the product of many of them still has all its digits.
TEST(ExactReal, PowersKeepTheirDigitsWhateverTheErrorOfTheirFactors) {
  const auto error = [](int digits) {
    return cln::cl_float(cln::expt(cln::cl_RA(1) / 10, digits), cln::float_format(200));
  };
  const ExactReal one =
      Computed("nearly one", [error](int digits) { return cln::cl_float(1, cln::float_format(200)) + error(digits); });
  ExactReal power = one;
  for (int i = 1; i < 40; ++i) power = multiply(power, one);
  const ExactReal many = multiply(Surd::square_root(3), power);
  for (int digits = 10; digits <= 120; digits += 5) {
    const cln::cl_F exact = cln::sqrt(cln::cl_float(3, cln::float_format(200)));
    for (const ExactReal& value : {many, multiply(Surd(3), reciprocal(many))}) {
      EXPECT_LT(cln::double_approx(cln::abs(evaluate(value, digits) - exact) / (exact * error(digits))), 1.0) << digits;
    }
  }
}

TEST(ExactReal, ComputedConstantsAreEqualByDefinitionAndNeverRounded) {
  const Computed third("root of 3x - 1",
                       [](int digits) { return cln::cl_float(cln::cl_RA(1) / 3, cln::float_format(digits + 3)); });
  const ExactReal value = third;
  EXPECT_EQ(value, ExactReal(third));
  EXPECT_EQ(negate(negate(value)), value);
  EXPECT_TRUE(is_negative(negate(value)));
  EXPECT_EQ(add(value, ExactReal(Surd(0))), value);
  EXPECT_EQ(nearest<float>(value), 1.0F / 3);
}

TEST_F(Ir, RefusesKernelsThatReferForward) {
  output(7);
  EXPECT_THROW(require_well_formed(kernel), std::logic_error);
  Kernel forward = test::empty_kernel();
  Builder(forward).append({Op::kAdd, {0, 5, -1, -1}, -1, {}, ""});
  EXPECT_THROW(require_well_formed(forward), std::logic_error);
}

}  // namespace
}  // namespace sh::codegen
