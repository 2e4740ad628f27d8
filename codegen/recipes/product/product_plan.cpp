// Searches for the plan of a separable product: the numbers of angles and rings with the fewest operations.
#include <algorithm>
#include <map>
#include <tuple>

#include "codegen/ir/cost.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/product/product.hpp"

namespace sh::codegen::recipes {
namespace {

SeparablePlan shortest_plan(const ProductShape& shape, Factors factors, SampleProduct sample_product) {
  constexpr int kMostAliases = 4;  // more aliases need more operations than further angles
  const int total = shape.a + shape.b + shape.result;
  // The orders of the product of both factors have to stay below M, and every order of the result below M/2.
  const int most = std::max({shape.a + shape.b, 2 * shape.result, total - kMostAliases});
  const int first = 4 * (most / 4 + 1);
  SeparablePlan best;
  int fewest = -1;
  for (int angles = first; angles == first || angles < total + 5; angles += 4) {
    // A polar ring costs little. Every other degree needs an equator, which costs half a pair.
    const SeparablePlan plan{{total / 4, true, total / 2 % 2 != 0}, angles};
    const int operations =
        cost(passes::fold(passes::share(product_separable(shape, factors, sample_product, plan)))).operations();
    if (fewest >= 0 && operations >= fewest) continue;
    fewest = operations;
    best = plan;
  }
  return best;
}

}  // namespace

SeparablePlan separable_plan(const ProductShape& shape, Factors factors, SampleProduct sample_product) {
  static std::map<std::tuple<int, int, int, Factors, SampleProduct>, SeparablePlan> known;
  const auto [position, added] = known.try_emplace({shape.a, shape.b, shape.result, factors, sample_product});
  if (added) position->second = shortest_plan(shape, factors, sample_product);
  return position->second;
}

}  // namespace sh::codegen::recipes
