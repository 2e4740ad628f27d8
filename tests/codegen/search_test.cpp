// The search for the inputs with the largest rounding errors: its parts against exact arithmetic, and what it finds.
#include "codegen/measure/search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "codegen/measure/first_order.hpp"
#include "codegen/measure/half.hpp"
#include "codegen/measure/lanes.hpp"
#include "codegen/passes/passes.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::SmallKernel;

Kernel written(const std::string& family, int degree) {
  const Family& of = find_family(family);
  return kernel_stages(of, fastest_recipe(of, degree), degree).back().kernel;
}

// The domain with one input.
Domain only(const Domain& domain, const std::vector<double>& input) {
  Domain one = domain;
  one.test_inputs = [input](int /*degree*/) { return std::vector<std::vector<double>>{input}; };
  return one;
}

// The first test inputs of a family, of which half precision holds all numbers.
template <class T>
std::vector<std::vector<double>> some_inputs(const Domain& domain, int degree) {
  std::vector<std::vector<double>> inputs = domain.test_inputs(degree);
  inputs.resize(std::min<std::size_t>(inputs.size(), kLanes));
  for (auto& input : inputs) {
    for (double& value : input) value = static_cast<double>(static_cast<T>(value));
  }
  return inputs;
}

// All operations but fused multiply-adds: products, quotients, roots and selections.
constexpr std::pair<const char*, int> kKernels[] = {{"basis", 5}, {"basis_normalised", 3}, {"product", 4}, {"cap", 3},
                                                    {"zonal", 4}, {"rotate", 3},           {"evaluate", 4}};

template <class T>
class ErrorsIn : public testing::Test {};
using Types = testing::Types<float, double, Half>;
TYPED_TEST_SUITE(ErrorsIn, Types);

TYPED_TEST(ErrorsIn, LanesAreThoseOfExactArithmetic) {
  const std::string name = std::is_same_v<TypeParam, Half>    ? "half"
                           : std::is_same_v<TypeParam, float> ? "float"
                                                              : "double";
  const bound::Format& format = bound::find_format(name);
  for (const auto& [family, degree] : kKernels) {
    SCOPED_TRACE(std::string(family) + " " + name);
    // Half precision cannot hold the smallest caps, the longest vectors and the smallest turns.
    const std::set<std::string> unsuited{"cap", "basis_normalised", "rotate"};
    if (name == "half" && unsuited.contains(family)) continue;
    const Domain& domain = find_family(family).domain;
    const Kernel kernel = written(family, degree);
    const Kernel nodes = passes::unroll(kernel);
    ErrorLanes<TypeParam> lanes(nodes, format);
    const auto inputs = some_inputs<TypeParam>(domain, degree);
    std::vector<Lanes> in(inputs[0].size());
    for (std::size_t lane = 0; lane < inputs.size(); ++lane) {
      for (std::size_t i = 0; i < in.size(); ++i) in[i][lane] = inputs[lane][i];
    }
    lanes(in);
    for (std::size_t lane = 0; lane < inputs.size(); ++lane) {
      const double exact = measure<TypeParam>(kernel, only(domain, inputs[lane])).rounding.absolute;
      double most = 0;
      for (std::size_t i = 0; i < nodes.outputs.size(); ++i)
        most = std::max(most, lanes.error(i, static_cast<int>(lane)));
      EXPECT_NEAR(most, exact, exact * 1e-4 + format.epsilon() * 1e-7) << lane;
    }
  }
}

// The largest sum of roundings is no less than the errors seen, but for terms of second order.
TEST(FirstOrderError, IsAtLeastTheErrorAtTheSameInput) {
  const bound::Format& format = bound::find_format("float");
  for (const auto& [family, degree] : kKernels) {
    const Domain& domain = find_family(family).domain;
    const Kernel kernel = written(family, degree);
    const Kernel nodes = passes::unroll(kernel);
    const Size size = size_of(kernel, domain);
    FirstOrder first_order(nodes, format);
    for (const auto& input : some_inputs<float>(domain, degree)) {
      first_order.move_to(input);
      double most = 0;
      for (std::size_t i = 0; i < nodes.outputs.size(); ++i) {
        const double unit =
            size(input, static_cast<std::size_t>(nodes.element(static_cast<int>(i)))) * format.epsilon();
        if (unit > 0) most = std::max(most, first_order.error(i) / unit);
      }
      EXPECT_LE(measure<float>(kernel, only(domain, input)).rounding.eps, most * 1.001) << kernel.name;
    }
  }
}

class FirstOrderOfSmallKernel : public SmallKernel {};

TEST_F(FirstOrderOfSmallKernel, AddsUpRoundingsAndConstants) {
  // x / 3 + y: a constant, a product and a sum.
  output(build.add(build.mul(build.constant(symbolic::Surd(cln::cl_RA(1) / 3)), kX), kY));
  FirstOrder first_order(kernel, bound::find_format("float"));
  first_order.move_to(std::vector<double>{0.75, -0.5, 0});
  const double constant = std::abs(static_cast<double>(1.0F / 3) - 1.0 / 3) * 0.75;
  EXPECT_NEAR(first_order.error(0), 0x1p-24 * (0.25 + 0.25) + constant, 1e-15);
}

TEST(Search, FindsSeveralTimesTheErrorOfTestedInputsOfProducts) {
  const Domain& domain = find_family("product").domain;
  for (const int degree : {4, 5}) {
    const Kernel kernel = written("product", degree);
    const MeasuredError seen = largest_seen<float>(kernel, domain, {}, 4000);
    EXPECT_GT(seen.rounding.eps, 2 * measure<float>(kernel, domain).rounding.eps);
    EXPECT_EQ(seen.worst, largest_seen<float>(kernel, domain, {}, 4000).worst);
  }
}

// A bound is largest in a corner of a box, which need not be a direction. Vectors longer than 1 have larger errors, so that
// the search would end with them.
TEST(Search, BringsStartsToTheDomain) {
  const Kernel kernel = written("evaluate", 3);
  for (const double length : {1.03, 3.0}) {
    std::vector<double> start(16, 0.25);
    start.insert(start.end(), {0.87 * length, 0.48 * length, 0.11 * length});
    for (const auto& found : search_inputs<double>(kernel, find_family("evaluate").domain, {start}, 200)) {
      EXPECT_NEAR(std::hypot(found[16], found[17], found[18]), 1, 1e-15) << length;
    }
  }
}

// The domain of bounds has vectors that are off length 1 by at most 2 epsilon (bound/region.hpp). Half precision has few
// others, and its worst roundings are among them.
TEST(Search, LooksAtAllUnitVectorsOfHalfPrecision) {
  const Kernel kernel = written("rotate_z", 6);
  double most = 0;
  for (const auto& found : search_inputs<Half>(kernel, find_family("rotate_z").domain, {}, 4096)) {
    most = std::max(most, std::abs(std::hypot(found[0], found[1]) - 1));
  }
  EXPECT_GT(most, 0x1p-11);  // the nearest ones are off by less
  EXPECT_LE(most, 0x1p-9);
}

// Inputs are rounded, so that the direction that they stand for is off by an epsilon: the total error exceeds the
// rounding error by a small multiple of the degree.
TEST(Search, StatesTotalErrorsNotFarAboveRoundingErrors) {
  const nlohmann::json record = nlohmann::json::parse(std::ifstream(SHFORGE_SOURCE_DIR "/generated/families.json"));
  int compared = 0;
  for (const auto& family : record.at("families")) {
    for (const auto& kernel : family.at("kernels")) {
      for (const char* scalar : {"float", "double"}) {
        const double rounding = kernel.at(scalar).at("rounding_eps"), total = kernel.at(scalar).at("total_eps");
        const double degree = kernel.at("degree");
        EXPECT_LE(total, rounding + (degree + 1) * (degree + 1)) << kernel.at("name") << " " << scalar;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 800);
}

}  // namespace
}  // namespace sh::codegen
