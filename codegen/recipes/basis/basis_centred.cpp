// Recipe: all real spherical harmonics up to a degree with small rounding error. It avoids recurrences that amplify
// errors.
//
// A recurrence in l loses most digits in the columns m <= 2. Up to l - m = 7, these columns are polynomials in the
// centered variable t = 2z^2-1. Each polynomial is split into its even and its odd part in t, and Horner's rule in s =
// 2t^2-1 evaluates both parts. In t the values at both ends of -1 .. 1 are similar, so no large terms cancel. For m = 0
// the slope is steep at the poles. Therefore t is 1 - 2(1-z)(1+z) for odd l and z^2 - (x^2+y^2) for even l >= 8; both
// are accurate at the poles. The columns m > 2 are small near the poles. They follow the recurrence in l from T_2,
// which is linear in t. Sectoral functions use doubling (parity_columns.hpp), so their errors grow
// slowly.
#include <utility>

#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/basis/parity_columns.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using cln::cl_RA;
using symbolic::Surd;
using Powers = std::vector<cl_RA>;

constexpr int kLastPolynomialOrder = 2;
constexpr int kLastPolynomial = 7;  // l - m for m > 0; above it the recurrence is more accurate
constexpr int kFirstSplit = 8;      // the first even l for which the slope at the poles matters

class Centred {
 public:
  Centred(SignedBuilder& build, const Direction& d, int degree)
      : build_(build), d_(d), degree_(degree), values_(coefficient_count(degree)) {}

  std::vector<NodeId> values() && {
    values_[0] = build_.constant(sectoral_factor(0), "k_0_0");
    if (degree_ == 0) return std::move(values_);
    make_variables();
    const NodeId across = build_.sub(one_, z2_, "xy2");
    const std::vector<Pair> sectoral = append_sectoral(build_, d_, degree_, {.across = across}, true);
    for (int l = 1; l <= degree_; ++l) values_[coefficient_index(l, 0)] = with_z(axial_form(l, 0), l, 0);
    for (int m = 1; m <= degree_; ++m) column(m, sectoral[m]);
    return std::move(values_);
  }

 private:
  struct Variable {
    NodeId t = -1;  // 2z^2 - 1
    NodeId s = -1;  // 2t^2 - 1
  };

  void make_variables() {
    one_ = build_.constant(Surd(1), "one");
    z2_ = build_.mul(d_.z, d_.z, "z2");
    const NodeId t = build_.sub(build_.add(z2_, z2_), one_, "t");
    general_ = {t, doubled(t)};
    const NodeId below = build_.sub(one_, d_.z);
    const NodeId above = build_.add(one_, d_.z);
    const NodeId across = build_.mul(below, above);
    const NodeId polar_t = build_.sub(one_, build_.add(across, across), "u");
    polar_ = {polar_t, doubled(polar_t)};
    if (degree_ >= kFirstSplit) {
      const NodeId y2 = build_.mul(d_.y, d_.y), x2 = build_.mul(d_.x, d_.x);
      const NodeId radius2 = build_.add(x2, y2, "r2");
      const NodeId split_t = build_.sub(z2_, radius2, "v");
      split_ = {split_t, doubled(split_t)};
    }
  }

  NodeId doubled(NodeId t) {
    const NodeId square = build_.mul(t, t);
    return build_.sub(build_.add(square, square), one_);
  }

  // scale * p(u) by Horner's rule
  NodeId horner(const Powers& p, const Surd& scale, NodeId u, const std::string& name) {
    Value sum{build_.constant(scale * Surd(p.back()))};
    for (std::size_t i = p.size() - 1; i-- > 0;) {
      const NodeId product = build_.mul(sum.node, u);
      sum = build_.plus({product}, build_.fixed(scale * Surd(p[i])));
    }
    return p.size() > 1 ? build_.named(sum, name).node : sum.node;
  }

  // The polynomial without its factor z.
  NodeId polynomial(const AxialForm& form, const Variable& variable, const std::string& name) {
    Powers parts[2];
    const Powers in_t = centred(form.powers);
    for (std::size_t i = 0; i < in_t.size(); ++i) parts[i % 2].push_back(in_t[i]);
    const NodeId even = horner(centred(parts[0]), form.scale, variable.s, name);
    if (parts[1].empty()) return even;
    const NodeId odd = build_.mul(horner(centred(parts[1]), form.scale, variable.s, name), variable.t);
    return build_.add(odd, even, name);
  }

  NodeId with_z(const AxialForm& form, int l, int m) {
    const Variable& variable = m > 0 ? general_ : form.odd ? polar_ : l < kFirstSplit ? general_ : split_;
    const NodeId p = polynomial(form, variable, indexed("q", l, m));
    return form.odd ? build_.mul(p, d_.z, indexed("p", l, m)) : p;
  }

  void column(int m, const Pair& sectoral) {
    std::vector<NodeId> t{-1};
    set(m, m, sectoral);
    for (int l = m + 1; l <= degree_; ++l) {
      const auto n = l - m;
      t.push_back((m > kLastPolynomialOrder && n > 2) || n > kLastPolynomial ? row(l, m, t[n - 1], t[n - 2])
                                                                             : with_z(axial_form(l, m), l, m));
      const NodeId sine = build_.mul(t[n], sectoral.sine, indexed("y", l, m) + "s");
      const NodeId cosine = build_.mul(t[n], sectoral.cosine, indexed("y", l, m) + "c");
      set(l, m, {cosine, sine});
    }
  }

  // T_n = a z T_(n-1) - b T_(n-2)
  NodeId row(int l, int m, NodeId last, NodeId before) {
    const NodeId az = build_.mul(build_.constant(upper_factor(l, m), indexed("a", l, m)), d_.z);
    const NodeId high = build_.mul(az, last);
    const NodeId low = build_.mul(build_.constant(lower_factor(l, m), indexed("b", l, m)), before);
    return build_.sub(high, low, indexed("p", l, m));
  }

  void set(int l, int m, const Pair& pair) {
    values_[coefficient_index(l, m)] = pair.cosine;
    values_[coefficient_index(l, -m)] = pair.sine;
  }

  SignedBuilder& build_;
  Direction d_;
  int degree_;
  NodeId one_ = -1;
  NodeId z2_ = -1;
  Variable general_;
  Variable polar_;  // the same numbers in a form that is accurate near the poles
  Variable split_;  // z^2 - (x^2 + y^2), which splits the error between poles and equator
  std::vector<NodeId> values_;
};

}  // namespace

std::vector<NodeId> append_centred(SignedBuilder& build, const Direction& d, int degree) {
  symbolic::require_basis_index(degree, 0);
  return Centred(build, d, degree).values();
}

Kernel basis_centred(int degree) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.citation = kCentredSource;
  kernel.factored = true;
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build);
  set_outputs(kernel, append_centred(build, d, degree));
  return kernel;
}

}  // namespace sh::codegen::recipes
