// Products of two functions, squares, zonal products and integrals of three functions, on equal or different bands.
//
// Few terms allow products by pairs and term by term. All other shapes use quadrature, with a loop if code without a
// loop would be too long.
#include "codegen/recipes/product/product.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

#include "codegen/families/exact.hpp"
#include "codegen/ir/cost.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen {
namespace {

using recipes::Factors;
using recipes::SampleProduct;
using symbolic::BilinearForm;
using symbolic::ProductShape;

constexpr int kLargestUnrolled = 6;  // longer code does not fit into the instruction cache
constexpr int kLargestProductUnrolled =
    5;  // at degree 6 the loop is a fifth of the code and takes a tenth longer at most
constexpr int kLargestEmitted = symbolic::kMaxProductDegree;
constexpr const char* kLimit = "the Gaunt tensor is derived to this degree only";
constexpr int kLargestByTerms = 3;  // at higher degrees one product for each term is too long to be useful
constexpr int kLargestComplete = 4;

// Limits of products of different degrees.
constexpr int kMostByTerms = 800;  // terms G a_i b_j; with more terms, one product for each is too long
constexpr int kMostByPairs = 2500;
constexpr int kLeastByQuadrature = 4;  // sum of the three degrees; below it, poles and equator are the only rings
constexpr int kMostUnrolled = 20;      // sum of the three degrees; above it, a loop runs over the rings

// --- references: symbolic::product_form and its variants at vectors of small rationals

constexpr unsigned long kSeed = 20060501;

// The sum of factor_i * a_i * b_j. Surds are grouped by their radical, so that nearly all operations are rational.
cln::cl_F value(const BilinearForm& form, std::span<const cln::cl_RA> a, std::span<const cln::cl_RA> b) {
  std::map<Surd, cln::cl_RA> sums;
  for (const symbolic::BilinearTerm& term : form.terms) {
    const Surd radical = Surd(cln::recip(term.factor.rational())) * term.factor;
    cln::cl_RA& sum = sums.try_emplace(radical, 0).first->second;
    sum = sum + term.factor.rational() * a[term.i] * b[term.j];
  }
  cln::cl_F total = precise(0);
  for (const auto& [radical, sum] : sums) total = total + precise(radical * Surd(sum));
  return total;
}

const std::vector<BilinearForm>& forms_of(const ProductShape& shape) {
  static std::map<std::tuple<int, int, int>, std::vector<BilinearForm>> known;
  const auto [position, added] = known.try_emplace({shape.a, shape.b, shape.result});
  if (added) position->second = symbolic::product_form(shape);
  return position->second;
}

std::vector<cln::cl_F> values(const std::vector<BilinearForm>& forms, std::span<const cln::cl_RA> a,
                              std::span<const cln::cl_RA> b) {
  std::vector<cln::cl_F> result;
  for (const BilinearForm& form : forms) result.push_back(value(form, a, b));
  return result;
}

// Products of the first `left` numbers of a point and the others.
Reference bilinear_reference(const std::vector<BilinearForm>& forms, int left, int right, int points) {
  return reference_at(rational_vectors(points, left + right, kSeed), [&](const Rationals& point) {
    return values(forms, std::span(point).first(left), std::span(point).last(right));
  });
}

Reference product_reference(const ProductShape& shape, int points) {
  return bilinear_reference(forms_of(shape), coefficient_count(shape.a), coefficient_count(shape.b), points);
}

Reference square_reference(int degree, int points) {
  return reference_at(rational_vectors(points, coefficient_count(degree), kSeed), [degree](const Rationals& a) {
    return values(forms_of({degree, degree, degree}), a, a);
  });
}

Reference product_zonal_reference(int degree, int points) {
  return bilinear_reference(symbolic::zonal_product_form({degree, degree, degree}), coefficient_count(degree),
                            degree + 1, points);
}

Reference triple_reference(int degree, int points) {
  const int count = coefficient_count(degree);
  return reference_at(rational_vectors(points, 3 * count, kSeed), [=](const Rationals& point) {
    const std::span all(point);
    const auto ab = values(forms_of({degree, degree, degree}), all.first(count), all.subspan(count, count));
    cln::cl_F integral = precise(0);
    for (int i = 0; i < count; ++i) integral = integral + ab[i] * precise(point[2 * count + i]);
    return std::vector{integral};
  });
}

// --- domains: vectors of unit length

// Unit vectors, one after the other: random vectors, single coefficients, and equal random vectors.
Inputs unit_factors(const std::vector<int>& sizes) {
  constexpr int kRandom = 80;
  constexpr int kSingle = 20;
  constexpr int kEqual = 20;
  Inputs inputs(kRandom + kSingle + kEqual);
  std::mt19937_64 random(kSeed);
  for (std::size_t f = 0; f < sizes.size(); ++f) {
    Inputs factors = unit_vectors(kRandom, sizes[f], kSeed + f);
    for (int i = 0; i < kSingle; ++i) factors.emplace_back(sizes[f], 0.0)[random() % sizes[f]] = 1;
    const Inputs equal = unit_vectors(kEqual, sizes[f], kSeed + sizes.size());
    factors.insert(factors.end(), equal.begin(), equal.end());
    inputs = joined(std::move(inputs), factors);
  }
  return inputs;
}

// sizes: the number of coefficients of each factor, for a degree.
Domain factor_domain(const std::string& unit, const std::function<std::vector<int>(int degree)>& sizes) {
  return {.inputs = "sets of unit vectors of coefficients (random, single coefficients, equal)",
          .unit = unit,
          .test_inputs = [sizes](int degree) { return unit_factors(sizes(degree)); },
          .sizes = {unit}};
}

// Factors of the family's degree.
Domain factor_domain(const std::string& unit, int factors) {
  return factor_domain(unit, [factors](int degree) { return std::vector<int>(factors, coefficient_count(degree)); });
}

// --- recipes

// The ways to compute a product of any shape.
using Make = Kernel (*)(const ProductShape&, Factors);

template <SampleProduct Way, bool Looped>
Kernel separable(const ProductShape& shape, Factors factors) {
  return recipes::product_separable(shape, factors, Way, Looped);
}
Kernel greedy_pairs(const ProductShape& shape, Factors factors) {
  return recipes::product_pairs(shape, factors, recipes::greedy_cover(shape));
}
constexpr Make kPairs = recipes::product_pairs;
constexpr Make kDirect = separable<SampleProduct::kDirect, false>;
constexpr Make kHalves = separable<SampleProduct::kHalves, false>;
constexpr Make kLooped = separable<SampleProduct::kDirect, true>;
constexpr Make kLoopedHalves = separable<SampleProduct::kHalves, true>;

ProductShape equal(int degree) { return {degree, degree, degree}; }
ProductShape complete(int degree) { return {degree, degree, 2 * degree}; }

std::function<Kernel(int)> projected(Make make, Factors factors = Factors::kTwo) {
  return [=](int degree) { return make(equal(degree), factors); };
}
std::function<Kernel(int)> squared(Make make) { return projected(make, Factors::kSame); }
std::function<Kernel(int)> completed(Make make) {
  return [make](int degree) { return make(complete(degree), Factors::kTwo); };
}
std::function<Kernel(int)> integrated(Make make) {
  return [make](int degree) { return recipes::triple(make(equal(degree), Factors::kTwo), degree); };
}

// --- products of different degrees

int operations(const Recipe& recipe, int degree) {
  return cost(passes::fold(passes::share(recipe.make(degree)))).operations();
}

int term_count(const ProductShape& shape) {
  int count = 0;
  for (const BilinearForm& form : symbolic::product_form(shape)) count += static_cast<int>(form.terms.size());
  return count;
}

// The ways to compute one shape, the one with the fewest operations first.
std::vector<Recipe> recipes_of(const ProductShape& shape) {
  const int degree = shape.result;
  std::vector<Recipe> recipes;
  const auto add = [&](const char* name, Make make) {
    recipes.push_back({name, [=](int /*degree*/) { return make(shape, Factors::kTwo); }, degree, degree});
  };
  const int total = shape.a + shape.b + shape.result;
  const int terms = term_count(shape);
  if (total >= kLeastByQuadrature && total <= kMostUnrolled) {
    add("separable", kDirect);
    add("separable-halves", kHalves);
  }
  if (total > kMostUnrolled) add("looped", kLooped);
  if (terms <= kMostByPairs) add("pairs", greedy_pairs);
  if (terms <= kMostByTerms) add("tensor", recipes::product_tensor);
  std::stable_sort(recipes.begin(), recipes.end(), [degree](const Recipe& x, const Recipe& y) {
    return operations(x, degree) < operations(y, degree);
  });
  return recipes;
}

void require_degree(const std::string& of, int degree, int largest, const std::string& limit) {
  if (degree >= 0 && degree <= largest) return;
  throw std::invalid_argument("product: expected degree 0 to " + std::to_string(largest) + " of " + of + ", got " +
                              std::to_string(degree) + " (" + limit + ")");
}

}  // namespace

Family rectangular_product_family(int left_degree, int right_degree, int degree) {
  constexpr const char* kComplete = "all further bands of the product are zero";
  require_degree("the left factor", left_degree, kLargestEmitted, kLimit);
  require_degree("the right factor", right_degree, kLargestEmitted, kLimit);
  require_degree("the result", degree, left_degree + right_degree, kComplete);
  const ProductShape shape{left_degree, right_degree, degree};
  const std::string left = std::to_string(left_degree);
  const std::string right = std::to_string(right_degree);
  const std::vector<int> sizes{coefficient_count(left_degree), coefficient_count(right_degree)};
  return {.name = "product_" + left + "x" + right,
          .largest_written = 0,
          .largest_emitted = left_degree + right_degree,
          .limit = kComplete,
          .recipes = recipes_of(shape),
          .reference = [shape](int /*degree*/, int points) { return product_reference(shape, points); },
          .domain = factor_domain("|a| |b|", [sizes](int /*degree*/) { return std::vector<int>(sizes); }),
          .arguments = "product --degree-left " + left + " --degree-right " + right};
}

std::vector<Family> product_families() {
  const BatchDriver batch{.what = "Products of two functions, projected on the same bands",
                          .single = {10, 10, 10, 7, 4, 3},
                          .grouped = 3,
                          .largest = 6};
  return {{.name = "product",
           .largest_emitted = kLargestEmitted,
           .limit = kLimit,
           // Pairs are faster up to degree 3, quadrature from degree 4 on.
           .recipes = {{"pairs", projected(kPairs), 0, 3},
                       {"separable", projected(kDirect), 2, kLargestProductUnrolled},
                       {"separable-halves", projected(kHalves), 2, kLargestProductUnrolled},
                       {"looped", projected(kLooped), kLargestUnrolled, kLargestEmitted},
                       {"looped-halves", projected(kLoopedHalves), kLargestUnrolled + 1, kLargestEmitted},
                       {"greedy-pairs", projected(greedy_pairs), 2, kLargestUnrolled},
                       {"tensor", projected(recipes::product_tensor), 0, kLargestByTerms}},
           .reference = [](int degree, int points) { return product_reference(equal(degree), points); },
           .domain = factor_domain("|a| |b|", 2),
           .of_degrees = rectangular_product_family,
           .batch = batch},
          {.name = "product_full",
           .largest_written = kLargestComplete,
           .largest_emitted = kLargestComplete,
           .limit = "`shgen emit product --degree-left N --degree-right N` serves higher degrees",
           .recipes = {{"pairs", completed(kPairs), 0, kLargestComplete},
                       {"separable", completed(kDirect), 1, kLargestComplete},
                       {"separable-halves", completed(kHalves), 1, kLargestComplete},
                       {"tensor", completed(recipes::product_tensor), 0, kLargestByTerms}},
           .reference = [](int degree, int points) { return product_reference(complete(degree), points); },
           .domain = factor_domain("|a| |b|", 2)},
          {.name = "square",
           .largest_emitted = kLargestEmitted,
           .limit = kLimit,
           .recipes = {{"pairs", squared(kPairs), 0, 3},
                       {"separable", squared(kDirect), 2, kLargestUnrolled},
                       {"looped", squared(kLooped), kLargestUnrolled, kLargestEmitted},
                       {"greedy-pairs", squared(greedy_pairs), 4, kLargestUnrolled},
                       {"tensor", squared(recipes::product_tensor), 0, kLargestByTerms}},
           .reference = square_reference,
           .domain = factor_domain("|a| |a|", 1)},
          {.name = "product_zonal",
           .largest_emitted = kLargestEmitted,
           .limit = kLimit,
           .recipes = {{"matrices", recipes::product_zonal},
                       {"tensor", recipes::product_zonal_tensor, 0, kLargestUnrolled}},
           .reference = product_zonal_reference,
           .domain = factor_domain("|a| |zonal|",
                                   [](int degree) {
                                     return std::vector<int>{coefficient_count(degree), degree + 1};
                                   })},
          {.name = "triple",
           .largest_emitted = kLargestEmitted,
           .limit = kLimit,
           .recipes = {{"pairs", integrated(kPairs), 0, 3},
                       {"separable", integrated(kDirect), 2, kLargestUnrolled},
                       {"separable-halves", integrated(kHalves), 2, kLargestUnrolled},
                       {"looped", integrated(kLooped), kLargestUnrolled, kLargestEmitted}},
           .reference = triple_reference,
           .domain = factor_domain("|a| |b| |c|", 3)}};
}

}  // namespace sh::codegen
