// Recipe: the product of two functions by pairs of coefficients.
//
// The Gaunt tensor is symmetric, so a triple i < j < k stands for six terms. All triples that hold a chosen pair (i, j)
// share its products:
//     P = a_i b_j + a_j b_i,   A = sum over k of G_ijk a_k,   B = sum over k of G_ijk b_k,
//     c_k += G_ijk P,   c_i += A b_j + B a_j,   c_j += A b_i + B a_i,
// Pairs (i, i) need half as many products [Snyder06]. One linear map of a gives the sums A, the same map of b gives the
// sums B, and its transpose adds P to c. One short circuit serves all three.
#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "codegen/recipes/linear_circuit.hpp"
#include "codegen/recipes/product/product.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::GauntTensor;
using symbolic::IndexTriple;
using symbolic::Surd;

// The entries that the shape needs: in some order, one index belongs to a, one to b and one to the result.
GauntTensor needed_entries(const ProductShape& shape) {
  GauntTensor entries;
  std::array<int, 3> sizes{coefficient_count(shape.a), coefficient_count(shape.b), coefficient_count(shape.result)};
  std::sort(sizes.begin(), sizes.end());
  for (int i = 0; i < sizes[0]; ++i) {
    for (int j = i; j < sizes[1]; ++j) {
      for (int k = j; k < sizes[2]; ++k) {
        if (!symbolic::gaunt_may_differ_from_zero(i, j, k)) continue;
        const Surd value = symbolic::gaunt(i, j, k);
        if (!value.is_zero()) entries.emplace(IndexTriple{i, j, k}, value);
      }
    }
  }
  return entries;
}

bool all_differ(const IndexTriple& t) { return t.i != t.j && t.j != t.k; }

// The third index of a triple that holds a pair, or nothing.
std::optional<int> third(const IndexTriple& t, const std::pair<int, int>& pair) {
  if (pair == std::pair(t.i, t.j)) return t.k;
  if (pair == std::pair(t.i, t.k)) return t.j;
  if (pair == std::pair(t.j, t.k)) return t.i;
  return std::nullopt;
}

class Pairs {
 public:
  Pairs(Kernel& kernel, const ProductShape& shape, Factors factors)
      : kernel_(kernel),
        build_(kernel),
        same_(factors == Factors::kSame),
        count_(coefficient_count(std::max({shape.a, shape.b, shape.result}))) {
    a_ = padded(build_.inputs(0, coefficient_count(shape.a)));
    b_ = same_ ? a_ : padded(build_.inputs(coefficient_count(shape.a), coefficient_count(shape.b)));
    sums_.resize(count_);
  }

  void add_pair(const std::pair<int, int>& pair, const std::map<int, ExactReal>& thirds) {
    pairs_.push_back(pair);
    const std::map<int, ExactReal> twice = doubled(thirds);
    forwards_.push_back(same_ ? twice : thirds);
    backwards_.push_back(same_ && pair.first != pair.second ? twice : thirds);
  }
  // c_i += G a_i b_i
  void add_cube(int i, const ExactReal& entry) { cubes_.emplace_back(i, entry); }

  void run() {
    for (const auto& [i, entry] : cubes_) {
      backwards_.push_back({{i, entry}});
      if (!same_) forwards_.push_back({{i, entry}});  // unused, but with it one circuit serves both directions
    }
    const LinearCircuit circuit = short_circuit(forwards_, count_, attempts());
    const std::vector<Value> of_a = run_forwards(build_, circuit, a_);
    const std::vector<Value> of_b = same_ ? of_a : run_forwards(build_, circuit, b_);
    std::vector<Value> products;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      products.push_back(product(pairs_[p]));
      spread(pairs_[p], of_a[p], of_b[p]);
    }
    for (const auto& [i, entry] : cubes_) products.push_back(product({i, i}));
    const std::vector<Value> thirds =
        run_transposed(build_, same_ ? short_circuit(backwards_, count_, attempts()) : circuit, products);
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k].push_back(thirds[k]);
    for (std::size_t k = 0; k < kernel_.outputs.size(); ++k) {
      kernel_.outputs[k].node = build_.node(build_.sum(sums_[k]));
    }
  }

 private:
  // A longer search improves the many sums of a large product only a little.
  [[nodiscard]] int attempts() const { return count_ <= 16 ? 100 : 1; }

  static std::map<int, ExactReal> doubled(std::map<int, ExactReal> entries) {
    for (auto& [column, entry] : entries) entry = multiply(Surd(2), entry);
    return entries;
  }

  [[nodiscard]] std::vector<Value> padded(std::vector<Value> values) const {
    values.resize(count_);
    return values;
  }

  // a_i b_j + a_j b_i, or a_i b_i; half of it in a square.
  Value product(const std::pair<int, int>& pair) {
    const auto i = pair.first;
    const auto j = pair.second;
    const Value ij = build_.times(a_[i], b_[j]);
    const std::string name = "p_" + std::to_string(i) + "_" + std::to_string(j);
    if (same_ || i == j) return build_.named(ij, name);
    return build_.named(build_.plus(ij, build_.times(a_[j], b_[i])), name);
  }

  // c_i += A b_j + B a_j, c_j += A b_i + B a_i; in a square A is twice as large
  void spread(const std::pair<int, int>& pair, Value of_a, Value of_b) {
    const auto i = pair.first;
    const auto j = pair.second;
    for (const auto& [to, from] : {std::pair(i, j), std::pair(j, i)}) {
      sums_[to].push_back(build_.times(of_a, b_[from]));
      if (!same_) sums_[to].push_back(build_.times(of_b, a_[from]));
      if (i == j) return;
    }
  }

  Kernel& kernel_;
  SignedBuilder build_;
  bool same_;
  int count_;
  std::vector<Value> a_;
  std::vector<Value> b_;
  std::vector<std::pair<int, int>> pairs_;
  LinearMap forwards_;   // sums A and B by pair; twice as large in a square
  LinearMap backwards_;  // transposed map from products by pair to the result
  std::vector<std::pair<int, ExactReal>> cubes_;
  std::vector<std::vector<Value>> sums_;
};

}  // namespace

PairCover greedy_cover(const ProductShape& shape) {
  std::vector<IndexTriple> open;
  for (const auto& [triple, entry] : needed_entries(shape)) {
    if (all_differ(triple)) open.push_back(triple);
  }
  PairCover cover;
  while (!open.empty()) {
    std::map<std::pair<int, int>, int> held;
    for (const IndexTriple& t : open) {
      for (const auto& pair : {std::pair(t.i, t.j), std::pair(t.i, t.k), std::pair(t.j, t.k)}) ++held[pair];
    }
    const auto best =
        std::max_element(held.begin(), held.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
    cover.push_back({best->first.first, best->first.second, {}});
    std::vector<IndexTriple> left;
    for (const IndexTriple& t : open) {
      if (const auto k = third(t, best->first)) {
        cover.back().thirds.push_back(*k);
      } else {
        left.push_back(t);
      }
    }
    open = std::move(left);
  }
  return cover;
}

PairCover best_cover(const ProductShape& shape) {
  // Simulated annealing over the choice of the pair of every triple found this cover; it minimized the operations.
  static const PairCover kDegree3{{1, 4, {3, 13}},      {1, 5, {2, 12}}, {1, 11, {6, 8}},      {3, 7, {2, 12}},
                                  {3, 13, {6, 8}},      {4, 9, {3, 13}}, {4, 10, {2, 12}},     {4, 11, {3, 13}},
                                  {4, 15, {1, 11}},     {5, 7, {4}},     {5, 10, {3, 13, 15}}, {5, 11, {2, 12}},
                                  {5, 14, {1, 9, 11}},  {6, 12, {2}},    {7, 10, {1, 9, 11}},  {7, 13, {2, 12}},
                                  {7, 14, {3, 13, 15}}, {8, 9, {1, 11}}, {8, 14, {2, 12}},     {8, 15, {3, 13}}};
  return shape.a == 3 && shape.b == 3 && shape.result == 3 ? kDegree3 : greedy_cover(shape);
}

Kernel product_pairs(const ProductShape& shape, Factors factors, const PairCover& cover) {
  Kernel kernel = product_frame(shape, factors);
  kernel.citation =
      "J. Snyder, \"Code Generation and Factoring for Fast Evaluation of Low-order Spherical Harmonic "
      "Products and Squares\", Microsoft Research, 2006; pairs and sums found by search";
  Pairs pairs(kernel, shape, factors);
  std::map<std::pair<int, int>, std::map<int, ExactReal>> thirds;
  for (const auto& [triple, entry] : needed_entries(shape)) {
    if (triple.i == triple.k) {
      pairs.add_cube(triple.i, entry);
    } else if (triple.i == triple.j) {
      thirds[{triple.i, triple.i}].emplace(triple.k, entry);
    } else if (triple.j == triple.k) {
      thirds[{triple.j, triple.j}].emplace(triple.i, entry);
    } else {
      const IndexTriple t = triple;
      const auto pair = std::find_if(cover.begin(), cover.end(), [&t](const PairWithThirds& p) {
        const auto k = third(t, {p.i, p.j});
        return k && std::find(p.thirds.begin(), p.thirds.end(), *k) != p.thirds.end();
      });
      if (pair == cover.end()) throw std::logic_error("product by pairs: the cover leaves a triple out");
      thirds[{pair->i, pair->j}].emplace(*third(t, {pair->i, pair->j}), entry);
    }
  }
  for (const auto& [pair, entries] : thirds) pairs.add_pair(pair, entries);
  pairs.run();
  return kernel;
}

Kernel product_pairs(const ProductShape& shape, Factors factors) {
  return product_pairs(shape, factors, best_cover(shape));
}

}  // namespace sh::codegen::recipes
