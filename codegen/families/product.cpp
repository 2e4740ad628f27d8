#include "codegen/recipes/product/product.hpp"

#include "codegen/families/families.hpp"
#include "codegen/families/product_reference.hpp"

namespace sh::codegen {
namespace {

using recipes::Factors;
using recipes::SampleProduct;
using symbolic::ProductShape;

constexpr int kLargestUnrolled = 6;  // longer code does not fit into the instruction cache
constexpr int kLargestEmitted = symbolic::kMaxProductDegree;
constexpr const char* kLimit = "the Gaunt tensor is derived to this degree only";
constexpr int kLargestByTerms = 3;  // at higher degrees one product for each term is too long to be useful

FactorSizes equal_factors(std::size_t count) {
  return [count](int degree) { return std::vector<int>(count, recipes::coefficient_count(degree)); };
}

ProductShape equal(int degree) { return {degree, degree, degree}; }

Kernel pairs(int degree) { return recipes::product_pairs(equal(degree), Factors::kTwo); }
Kernel greedy_pairs(int degree) {
  return recipes::product_pairs(equal(degree), Factors::kTwo, recipes::greedy_cover(equal(degree)));
}
Kernel separable(int degree) {
  return recipes::product_separable(equal(degree), Factors::kTwo, SampleProduct::kDirect);
}
Kernel halves(int degree) { return recipes::product_separable(equal(degree), Factors::kTwo, SampleProduct::kHalves); }
Kernel looped(int degree) { return recipes::product_looped(equal(degree), Factors::kTwo, SampleProduct::kDirect); }
Kernel looped_halves(int degree) {
  return recipes::product_looped(equal(degree), Factors::kTwo, SampleProduct::kHalves);
}
Kernel tensor(int degree) { return recipes::product_tensor(equal(degree), Factors::kTwo); }

std::function<Kernel(int)> integrated(Kernel (*product)(int)) {
  return [product](int degree) { return recipes::triple(product(degree), degree); };
}

}  // namespace

Family product_family() {
  return {.name = "product",
          .largest_emitted = kLargestEmitted,
          .limit = kLimit,
          // Pairs are faster up to degree 3, quadrature from degree 4 on.
          .recipes = {{"pairs", pairs, 0, 3},
                      {"separable", separable, 2, kLargestUnrolled},
                      {"separable-halves", halves, 2, kLargestUnrolled},
                      {"looped", looped, kLargestUnrolled, kLargestEmitted},
                      {"looped-halves", looped_halves, kLargestUnrolled + 1, kLargestEmitted},
                      {"greedy-pairs", greedy_pairs, 2, 6},
                      {"tensor", tensor, 0, kLargestByTerms}},
          .reference = [](int degree, int count) { return product_reference(equal(degree), count); },
          .domain = factor_domain(equal_factors(2), "|a| |b|"),
          .of_degrees = rectangular_product_family,
          .batch = BatchDriver{.what = "Products of two functions, projected on the same bands", .largest = 6}};
}

Family triple_family() {
  return {.name = "triple",
          .largest_emitted = kLargestEmitted,
          .limit = kLimit,
          .recipes = {{"pairs", integrated(pairs), 0, 3},
                      {"separable", integrated(separable), 2, kLargestUnrolled},
                      {"separable-halves", integrated(halves), 2, kLargestUnrolled},
                      {"looped", integrated(looped), kLargestUnrolled, kLargestEmitted}},
          .reference = triple_reference,
          .domain = factor_domain(equal_factors(3), "|a| |b| |c|")};
}

Family square_family() {
  return {.name = "square",
          .largest_emitted = kLargestEmitted,
          .limit = kLimit,
          .recipes = {{"pairs", [](int degree) { return recipes::product_pairs(equal(degree), Factors::kSame); }, 0, 3},
                      {"separable",
                       [](int degree) {
                         return recipes::product_separable(equal(degree), Factors::kSame, SampleProduct::kDirect);
                       },
                       2, kLargestUnrolled},
                      {"looped",
                       [](int degree) {
                         return recipes::product_looped(equal(degree), Factors::kSame, SampleProduct::kDirect);
                       },
                       kLargestUnrolled, kLargestEmitted},
                      {"greedy-pairs",
                       [](int degree) {
                         return recipes::product_pairs(equal(degree), Factors::kSame,
                                                       recipes::greedy_cover(equal(degree)));
                       },
                       4, kLargestUnrolled},
                      {"tensor", [](int degree) { return recipes::product_tensor(equal(degree), Factors::kSame); }, 0,
                       kLargestByTerms}},
          .reference = square_reference,
          .domain = factor_domain(equal_factors(1), "|a| |a|")};
}

Family product_zonal_family() {
  return {
      .name = "product_zonal",
      .largest_emitted = kLargestEmitted,
      .limit = kLimit,
      .recipes = {{"matrices", recipes::product_zonal}, {"tensor", recipes::product_zonal_tensor, 0, kLargestUnrolled}},
      .reference = product_zonal_reference,
      .domain = factor_domain(
          [](int degree) {
            return std::vector<int>{recipes::coefficient_count(degree), degree + 1};
          },
          "|a| |zonal|")};
}

}  // namespace sh::codegen
