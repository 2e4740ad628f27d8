#include "codegen/recipes/basis/parity_columns.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// k_3 / (k_1 k_2)
Surd third_ratio() { return sectoral_factor(3) / (sectoral_factor(1) * sectoral_factor(2)); }

class Sectoral {
 public:
  Sectoral(Builder& build, const Direction& d, const Squares& squares, bool split_square)
      : build_(build), d_(d), squares_(squares), split_square_(split_square) {}

  std::vector<Pair> pairs(int degree) && {
    pairs_.resize(degree + 1);
    for (int m = 1; m <= degree; ++m) pairs_[m] = named(m, pair(m));
    return std::move(pairs_);
  }

  // All of them times a weight.
  std::vector<Pair> weighted(const std::vector<Pair>& plain, NodeId weight) && {
    pairs_.resize(plain.size());
    for (int m = 1; m < static_cast<int>(plain.size()); ++m) pairs_[m] = named(m, weighted(m, plain, weight));
    return std::move(pairs_);
  }

 private:
  Pair pair(int m) {
    if (m == 1) return first();
    if (m == 2) return second();
    if (m == 3) return third(pairs_[1], pairs_[2].cosine);
    return m % 2 == 0 ? doubled(m) : stepped(m);
  }

  Pair weighted(int m, const std::vector<Pair>& plain, NodeId weight) {
    if (m == 1) {
      const NodeId k = scaled(sectoral_factor(1), weight, "k_1_1");
      const NodeId cosine = build_.mul(k, d_.x);
      return {cosine, build_.mul(k, d_.y)};
    }
    if (m == 3) return third(pairs_[1], plain[2].cosine);
    if (m % 2 != 0) return stepped(m);
    const NodeId cosine = build_.mul(weight, plain[m].cosine);
    return {cosine, build_.mul(weight, plain[m].sine)};
  }

  NodeId scaled(const Surd& factor, NodeId a, const std::string& constant) {
    return build_.mul(build_.constant(factor, constant), a);
  }

  Pair named(int m, const Pair& pair) {
    build_.name(pair.cosine, indexed("y", m, m) + "c");
    build_.name(pair.sine, indexed("y", m, m) + "s");
    return pair;
  }

  Pair first() {
    const NodeId cosine = scaled(sectoral_factor(1), d_.x, "k_1_1");
    const NodeId sine = scaled(sectoral_factor(1), d_.y, "k_1_1");
    return {cosine, sine};
  }

  Pair second() {
    const Surd k = sectoral_factor(2);
    const NodeId p = scaled(Surd(2) * k, d_.x, "k_2_2s");
    const NodeId sine = build_.mul(p, d_.y);
    if (has_square_difference()) return {scaled(k, square_difference(), "k_2_2c"), sine};
    const NodeId across = scaled(k, squares_.across, "k_2_2c");
    return {build_.sub(build_.mul(p, d_.x), across), sine};
  }

  [[nodiscard]] bool has_square_difference() const { return split_square_ || squares_.x2 >= 0; }

  // x^2 - y^2
  NodeId square_difference() {
    if (squares_.x2 >= 0) return build_.sub(squares_.x2, squares_.y2);
    const NodeId difference = build_.sub(d_.x, d_.y);
    return build_.mul(difference, build_.add(d_.x, d_.y));
  }

  // From (a multiple of) order 1 and A_2.
  Pair third(const Pair& one, NodeId two) {
    const NodeId across = scaled(third_ratio() * sectoral_factor(2), squares_.across, "b_3_3");
    const Surd twice = Surd(2) * third_ratio();
    const NodeId h = has_square_difference() ? scaled(twice * sectoral_factor(2), square_difference(), "a_3_3")
                                             : scaled(twice, two, "a_3_3");
    const NodeId cosine = build_.mul(one.cosine, build_.sub(h, across));
    return {cosine, build_.mul(one.sine, build_.add(h, across))};
  }

  Pair doubled(int m) {
    const Pair& half = pairs_[m / 2];
    const Surd ratio = sectoral_factor(m) / (sectoral_factor(m / 2) * sectoral_factor(m / 2));
    const NodeId sine = build_.mul(scaled(Surd(2) * ratio, half.cosine, indexed("k", m, m) + "s"), half.sine);
    const NodeId difference = scaled(ratio, build_.sub(half.cosine, half.sine), indexed("k", m, m) + "c");
    return {build_.mul(difference, build_.add(half.cosine, half.sine)), sine};
  }

  // From order m-1.
  Pair stepped(int m) {
    const Surd ratio = sectoral_factor(m) / sectoral_factor(m - 1);
    const Pair& last = pairs_[m - 1];
    const NodeId x = scaled(ratio, d_.x, indexed("k", m, m));
    const NodeId y = scaled(ratio, d_.y, indexed("k", m, m));
    const NodeId xc = build_.mul(x, last.cosine);
    const NodeId ys = build_.mul(y, last.sine);
    const NodeId xs = build_.mul(x, last.sine);
    const NodeId yc = build_.mul(y, last.cosine);
    const NodeId cosine = build_.sub(xc, ys);
    return {cosine, build_.add(xs, yc)};
  }

  Builder& build_;
  Direction d_;
  Squares squares_;
  bool split_square_;
  std::vector<Pair> pairs_;
};

}  // namespace

std::vector<Pair> append_sectoral(Builder& build, const Direction& d, int degree, const Squares& squares,
                                  bool split_square) {
  return Sectoral(build, d, squares, split_square).pairs(degree);
}

std::vector<Pair> append_weighted_sectoral(Builder& build, const Direction& d, NodeId weight,
                                           const std::vector<Pair>& plain, const Squares& squares, bool split_square) {
  return Sectoral(build, d, squares, split_square).weighted(plain, weight);
}

}  // namespace sh::codegen::recipes
