// Transferred radiance by a prepared light: against the product from the Gaunt tensor, with 100 digits.
#include <gtest/gtest.h>

#include "codegen/families/exact.hpp"
#include "codegen/ir/cost.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/product/product.hpp"

namespace sh::codegen {
namespace {

using Numbers = std::vector<cln::cl_F>;

constexpr int kDigits = kCheckDigits + 20;
constexpr int kLargest = 6;

Numbers precise_numbers(const Rationals& exact) {
  Numbers numbers;
  for (const cln::cl_RA& x : exact) numbers.push_back(Surd(x).evaluate(kDigits));
  return numbers;
}

Numbers evaluated(const Kernel& kernel, const Numbers& inputs) {
  Evaluator<cln::cl_F> evaluator(kernel, kDigits);
  return evaluator(inputs);
}

// Visibility, then the samples of every light.
Numbers with_prepared(int degree, const Numbers& visibility, const Numbers& lights) {
  Numbers inputs = visibility;
  for (auto first = lights.begin(); first != lights.end(); first += coefficient_count(degree)) {
    const Numbers light(first, first + coefficient_count(degree));
    const Numbers samples = evaluated(recipes::transfer_prepare(degree), light);
    inputs.insert(inputs.end(), samples.begin(), samples.end());
  }
  return inputs;
}

// The kernels apply(V, prepare(L)), for one channel or three.
Numbers transferred(int degree, const Numbers& visibility, const Numbers& lights, int channels, bool looped = false) {
  return evaluated(recipes::transfer_apply(degree, channels, looped), with_prepared(degree, visibility, lights));
}

Numbers product(int degree, const Rationals& visibility, const Rationals& light) {
  Numbers result;
  for (const symbolic::BilinearForm& form : symbolic::product_form({2 * degree, degree, degree})) {
    cln::cl_F sum = Surd(0).evaluate(kDigits);
    for (const symbolic::BilinearTerm& term : form.terms) {
      sum = sum + (term.factor * Surd(visibility[term.i] * light[term.j])).evaluate(kDigits);
    }
    result.push_back(sum);
  }
  return result;
}

void expect_equal(const Numbers& actual, const Numbers& expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  const cln::cl_F limit = Surd(cln::recip(cln::expt(cln::cl_RA(10), kCheckDigits))).evaluate(kDigits);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_LT(cln::abs(actual[i] - expected[i]), limit) << what << ", coefficient " << i;
  }
}

TEST(Transfer, IsTheProductOfVisibilityAndLight) {
  for (int degree = 0; degree <= kLargest; ++degree) {
    const auto visibility = rational_vectors(2, coefficient_count(2 * degree), 11)[1];
    const auto light = rational_vectors(2, coefficient_count(degree), 12)[1];
    for (const bool looped : {false, true}) {
      expect_equal(transferred(degree, precise_numbers(visibility), precise_numbers(light), 1, looped),
                   product(degree, visibility, light), "degree " + std::to_string(degree));
    }
  }
}

TEST(Transfer, OfThreeChannelsIsThatOfEach) {
  const int degree = 2;
  const auto visibility = rational_vectors(1, coefficient_count(2 * degree), 13)[0];
  Numbers lights, expected;
  for (const auto& light : rational_vectors(3, coefficient_count(degree), 14)) {
    const Numbers one = precise_numbers(light), alone = product(degree, visibility, light);
    lights.insert(lights.end(), one.begin(), one.end());
    expected.insert(expected.end(), alone.begin(), alone.end());
  }
  expect_equal(transferred(degree, precise_numbers(visibility), lights, 3), expected, "three channels");
}

int operations(const Kernel& kernel) { return cost(passes::fold(passes::share(kernel))).operations(); }

TEST(Transfer, NeedsAtMostSixTenthsOfTheOperationsOfThreeProducts) {
  for (int degree = 2; degree <= 4; ++degree) {
    const int products = 3 * operations(recipes::product_separable({2 * degree, degree, degree}, recipes::Factors::kTwo,
                                                                   recipes::SampleProduct::kDirect, false));
    EXPECT_LE(operations(recipes::transfer_apply(degree, 3, false)), 0.6 * products) << degree;
  }
}

TEST(Transfer, OfAConstantVisibilityIsTheLight) {
  const int degree = 3;
  Rationals whole(coefficient_count(2 * degree), 0);
  whole[0] = 1;
  const auto light = rational_vectors(1, coefficient_count(degree), 15)[0];
  const cln::cl_F y00 = Surd::square_root(cln::cl_RA(1) / 4, -1).evaluate(kDigits);
  Numbers expected = precise_numbers(light);
  for (cln::cl_F& x : expected) x = x * y00;
  expect_equal(transferred(degree, precise_numbers(whole), precise_numbers(light), 1), expected, "constant");
}

TEST(Transfer, GlossyReflectionOfAConstantVisibilityIsTheConvolvedLight) {
  for (int degree = 0; degree <= 4; ++degree) {
    Numbers inputs(coefficient_count(2 * degree), Surd(0).evaluate(kDigits));
    inputs[0] = Surd::square_root(4, 1).evaluate(kDigits);  // the function 1
    const auto light = rational_vectors(1, coefficient_count(degree), 16)[0];
    const auto lobe = rational_vectors(1, degree + 1, 17)[0];
    inputs = with_prepared(degree, inputs, precise_numbers(light));
    for (const cln::cl_F& x : precise_numbers(lobe)) inputs.push_back(x);
    for (const cln::cl_F& x : precise_numbers({0, 0, -1})) inputs.push_back(x);
    cln::cl_F sum = Surd(0).evaluate(kDigits);
    for (int l = 0; l <= degree; ++l) {  // sqrt(4 pi/(2l+1)) Y_l0(-z) = (-1)^l
      sum = sum + Surd((l % 2 == 0 ? 1 : -1) * lobe[l] * light[numeric::coefficient_index(l, 0)]).evaluate(kDigits);
    }
    for (const bool looped : {false, true}) {
      expect_equal(evaluated(recipes::transfer_glossy(degree, 1, looped), inputs), {sum},
                   "degree " + std::to_string(degree));
    }
  }
}

TEST(Transfer, GlossyReflectionNeedsFewerOperationsThanTransferredRadiance) {
  for (int degree = 2; degree <= 6; ++degree) {
    EXPECT_LT(operations(recipes::transfer_glossy(degree, 3, false)),
              0.8 * operations(recipes::transfer_apply(degree, 3, false)))
        << degree;
  }
}

}  // namespace
}  // namespace sh::codegen
