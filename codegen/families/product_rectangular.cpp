// Products of functions of different degrees, and complete products: degree N times degree N gives degree 2 N.
//
// Input: a shape. Output: a family with recipes for this shape only. Few terms allow products by pairs and term by
// term. All other shapes use quadrature, with a loop if code without a loop would be too long.
#include <algorithm>
#include <stdexcept>

#include "codegen/families/families.hpp"
#include "codegen/families/product_reference.hpp"
#include "codegen/ir/cost.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/product/product.hpp"

namespace sh::codegen {
namespace {

using recipes::Factors;
using recipes::SampleProduct;
using symbolic::ProductShape;

constexpr std::size_t kMostByTerms = 800;  // terms G a_i b_j; with more terms, one product for each is too long
constexpr std::size_t kMostByPairs = 2500;
constexpr int kLeastByQuadrature = 4;  // sum of the three degrees; below it, poles and equator are the only rings
constexpr int kMostUnrolled = 20;      // sum of the three degrees; above it, a loop runs over the rings

int operations(const Recipe& recipe, int degree) {
  return cost(passes::fold(passes::share(recipe.make(degree)))).operations();
}

std::size_t term_count(const ProductShape& shape) {
  std::size_t count = 0;
  for (const symbolic::BilinearForm& form : symbolic::product_form(shape)) count += form.terms.size();
  return count;
}

// The ways to compute one shape, the one with the fewest operations first.
std::vector<Recipe> recipes_of(const ProductShape& shape) {
  const int degree = shape.result;
  std::vector<Recipe> recipes;
  const auto add = [&](const char* name, const std::function<Kernel()>& make) {
    recipes.push_back({name, [make](int /*degree*/) { return make(); }, degree, degree});
  };
  const int total = shape.a + shape.b + shape.result;
  const std::size_t terms = term_count(shape);
  if (total >= kLeastByQuadrature && total <= kMostUnrolled) {
    add("separable", [shape] { return recipes::product_separable(shape, Factors::kTwo, SampleProduct::kDirect); });
    add("separable-halves",
        [shape] { return recipes::product_separable(shape, Factors::kTwo, SampleProduct::kHalves); });
  }
  if (total > kMostUnrolled) {
    add("looped", [shape] { return recipes::product_looped(shape, Factors::kTwo, SampleProduct::kDirect); });
  }
  if (terms <= kMostByPairs) {
    add("pairs", [shape] { return recipes::product_pairs(shape, Factors::kTwo, recipes::greedy_cover(shape)); });
  }
  if (terms <= kMostByTerms) add("tensor", [shape] { return recipes::product_tensor(shape, Factors::kTwo); });
  std::stable_sort(recipes.begin(), recipes.end(), [degree](const Recipe& x, const Recipe& y) {
    return operations(x, degree) < operations(y, degree);
  });
  return recipes;
}

FactorSizes fixed_factors(const ProductShape& shape) {
  return [shape](int /*degree*/) {
    return std::vector<int>{recipes::coefficient_count(shape.a), recipes::coefficient_count(shape.b)};
  };
}

ProductShape complete(int degree) { return {degree, degree, 2 * degree}; }

}  // namespace

Family rectangular_product_family(int left_degree, int right_degree, int degree) {
  const ProductShape shape{left_degree, right_degree, degree};
  const auto require = [](const std::string& factor, int value, int largest, const std::string& limit) {
    if (value >= 0 && value <= largest) return;
    throw std::invalid_argument("product: expected degree 0 to " + std::to_string(largest) + " of " + factor +
                                ", got " + std::to_string(value) + " (" + limit + ")");
  };
  constexpr const char* kTensor = "the Gaunt tensor is derived to this degree only";
  constexpr const char* kComplete = "all further bands of the product are zero";
  require("the left factor", left_degree, symbolic::kMaxProductDegree, kTensor);
  require("the right factor", right_degree, symbolic::kMaxProductDegree, kTensor);
  require("the result", degree, left_degree + right_degree, kComplete);
  const std::string left = std::to_string(left_degree);
  const std::string right = std::to_string(right_degree);
  return {.name = "product_" + left + "x" + right,
          .largest_written = 0,
          .largest_emitted = left_degree + right_degree,
          .limit = kComplete,
          .recipes = recipes_of(shape),
          .reference = [shape](int /*degree*/, int count) { return product_reference(shape, count); },
          .domain = factor_domain(fixed_factors(shape), "|a| |b|"),
          .arguments = "product --degree-left " + left + " --degree-right " + right};
}

Family product_full_family() {
  constexpr int kLargest = 4;
  const auto pairs = [](int degree) {
    return recipes::product_pairs(complete(degree), Factors::kTwo, recipes::greedy_cover(complete(degree)));
  };
  const auto separable = [](SampleProduct way) {
    return [way](int degree) { return recipes::product_separable(complete(degree), Factors::kTwo, way); };
  };
  return {.name = "product_full",
          .largest_written = kLargest,
          .largest_emitted = kLargest,
          .limit = "`shgen emit product --degree-left N --degree-right N` serves higher degrees",
          .recipes = {{"pairs", pairs, 0, kLargest},
                      {"separable", separable(SampleProduct::kDirect), 1, kLargest},
                      {"separable-halves", separable(SampleProduct::kHalves), 1, kLargest},
                      {"tensor", [](int degree) { return recipes::product_tensor(complete(degree), Factors::kTwo); }, 0,
                       3}},
          .reference = [](int degree, int count) { return product_reference(complete(degree), count); },
          .domain = factor_domain([](int degree) { return std::vector<int>(2, recipes::coefficient_count(degree)); },
                                  "|a| |b|")};
}

}  // namespace sh::codegen
