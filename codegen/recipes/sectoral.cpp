#include "codegen/recipes/sectoral.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

class Sectoral {
 public:
  Sectoral(Builder& build, const Direction& d, NodeId across, bool split_square)
      : build_(build), d_(d), across_(across), split_square_(split_square) {}

  std::vector<Pair> pairs(int degree) && {
    pairs_.resize(static_cast<std::size_t>(degree + 1));
    for (int m = 1; m <= degree; ++m) pairs_[static_cast<std::size_t>(m)] = pair(m);
    return std::move(pairs_);
  }

 private:
  Pair pair(int m) {
    if (m == 1) return first();
    if (m == 2) return second();
    if (m == 3) return third();
    return m % 2 == 0 ? doubled(m) : stepped(m);
  }

  [[nodiscard]] const Pair& at(int m) const { return pairs_[static_cast<std::size_t>(m)]; }

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
    return named(1, {cosine, sine});
  }

  Pair second() {
    const Surd k = sectoral_factor(2);
    const NodeId p = scaled(Surd(2) * k, d_.x, "k_2_2s");
    const NodeId sine = build_.mul(p, d_.y);
    if (split_square_) {
      const NodeId difference = scaled(k, build_.sub(d_.x, d_.y), "k_2_2c");
      return named(2, {build_.mul(difference, build_.add(d_.x, d_.y)), sine});
    }
    const NodeId across = scaled(k, across_, "k_2_2c");
    return named(2, {build_.sub(build_.mul(p, d_.x), across), sine});
  }

  Pair third() {
    const Surd ratio = sectoral_factor(3) / (sectoral_factor(1) * sectoral_factor(2));
    const NodeId across = scaled(ratio * sectoral_factor(2), across_, "b_3_3");
    const NodeId h = scaled(Surd(2) * ratio, at(2).cosine, "a_3_3");
    const NodeId cosine = build_.mul(at(1).cosine, build_.sub(h, across));
    const NodeId sine = build_.mul(at(1).sine, build_.add(h, across));
    return named(3, {cosine, sine});
  }

  Pair doubled(int m) {
    const Pair& half = at(m / 2);
    const Surd ratio = sectoral_factor(m) / (sectoral_factor(m / 2) * sectoral_factor(m / 2));
    const NodeId sine = build_.mul(scaled(Surd(2) * ratio, half.cosine, indexed("k", m, m) + "s"), half.sine);
    const NodeId difference = scaled(ratio, build_.sub(half.cosine, half.sine), indexed("k", m, m) + "c");
    return named(m, {build_.mul(difference, build_.add(half.cosine, half.sine)), sine});
  }

  Pair stepped(int m) {
    const Surd ratio = sectoral_factor(m) / sectoral_factor(m - 1);
    const Pair& last = at(m - 1);
    const NodeId x = scaled(ratio, d_.x, indexed("k", m, m));
    const NodeId y = scaled(ratio, d_.y, indexed("k", m, m));
    const NodeId xc = build_.mul(x, last.cosine);
    const NodeId ys = build_.mul(y, last.sine);
    const NodeId xs = build_.mul(x, last.sine);
    const NodeId yc = build_.mul(y, last.cosine);
    const NodeId cosine = build_.sub(xc, ys);
    const NodeId sine = build_.add(xs, yc);
    return named(m, {cosine, sine});
  }

  Builder& build_;
  Direction d_;
  NodeId across_;
  bool split_square_;
  std::vector<Pair> pairs_;
};

}  // namespace

std::vector<Pair> append_sectoral(Builder& build, const Direction& d, int degree, NodeId across, bool split_square) {
  return Sectoral(build, d, across, split_square).pairs(degree);
}

}  // namespace sh::codegen::recipes
