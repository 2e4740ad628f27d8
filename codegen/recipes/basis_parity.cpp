#include "codegen/recipes/basis_parity.hpp"

#include <cln/rational.h>

#include <stdexcept>

#include "codegen/recipes/sectoral.hpp"
#include "symbolic/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using cln::cl_RA;
using symbolic::Surd;
using Powers = std::vector<cl_RA>;

// A computed polynomial in w = z^2: node = scale * sum of powers[i] w^i.
struct Term {
  NodeId node = -1;
  Surd scale;
  Powers powers;
};

cl_RA power_at(const Powers& powers, std::size_t i) { return i < powers.size() ? powers[i] : cl_RA(0); }

// w * p
Powers raised(const Powers& p) {
  Powers result{0};
  result.insert(result.end(), p.begin(), p.end());
  return result;
}

// r, s with target = r u + s v, from the two lowest powers; the caller's relation has to hold for all of them.
std::pair<cl_RA, cl_RA> solve(const Powers& target, const Powers& u, const Powers& v) {
  const auto at = power_at;
  const cl_RA determinant = at(u, 0) * at(v, 1) - at(u, 1) * at(v, 0);
  const cl_RA r = (at(target, 0) * at(v, 1) - at(target, 1) * at(v, 0)) / determinant;
  const cl_RA s = (at(u, 0) * at(target, 1) - at(u, 1) * at(target, 0)) / determinant;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (at(target, i) != r * at(u, i) + s * at(v, i)) throw std::logic_error("parity: columns are not related so");
  }
  return {r, s};
}

class Columns {
 public:
  Columns(Builder& build, const Direction& d, int degree, const ParityChoices& choices)
      : build_(build),
        d_(d),
        degree_(degree),
        choices_(choices),
        values_(static_cast<std::size_t>(basis_count(degree))),
        terms_(static_cast<std::size_t>(degree + 2)) {}

  std::vector<NodeId> values() && {
    values_[0] = build_.constant(sectoral_factor(0), "k_0_0");
    if (degree_ == 0) return std::move(values_);
    z2_ = build_.mul(d_.z, d_.z, "z2");
    across_ = build_.sub(build_.constant(Surd(1), "one"), z2_, "xy2");
    const std::vector<Pair> sectoral = append_sectoral(build_, d_, degree_, across_, choices_.split_square);
    for (int m = degree_; m >= 0; --m) column(m, sectoral[static_cast<std::size_t>(m)]);
    return std::move(values_);
  }

 private:
  void column(int m, const Pair& sectoral) {
    std::vector<Term>& terms = terms_[static_cast<std::size_t>(m)];
    for (int n = 0; m + n <= degree_; ++n) {
      const int l = m + n;
      const AxialForm form = axial_form(l, m);
      if (n == 0) {
        terms.push_back({-1, form.scale, form.powers});
        if (m > 0) set(l, m, sectoral);
        continue;
      }
      if (n == 1) {
        const NodeId t = build_.mul(build_.constant(form.scale * Surd(form.powers[0]), indexed("k", l, m)), d_.z,
                                    indexed("t", l, m));
        terms.push_back({t, form.scale, form.powers});
        if (m > 0) {
          multiply(l, m, t, sectoral);
        } else {
          values_[basis_index(l, 0)] = t;
        }
        continue;
      }
      if (m == 0 && n > 4 && choices_.rows > 0) {
        values_[basis_index(l, 0)] = zonal_row(l);
        continue;
      }
      Term target{-1, form.scale, form.powers};
      if (form.odd) target.scale = form.scale / (terms[1].scale * Surd(terms[1].powers[0]));
      target.node = polynomial(target, m, n);
      terms.push_back(target);
      store(l, m, target.node, form.odd, sectoral);
    }
  }

  // Y_l0 = a z Y_(l-1)0 - b Y_(l-2)0
  NodeId zonal_row(int l) {
    const NodeId az = build_.mul(build_.constant(upper_factor(l, 0), indexed("a", l, 0)), d_.z);
    const NodeId high = build_.mul(az, values_[basis_index(l - 1, 0)]);
    const NodeId b = build_.constant(lower_factor(l, 0), indexed("b", l, 0));
    return build_.sub(high, build_.mul(b, values_[basis_index(l - 2, 0)]), indexed("p", l, 0));
  }

  NodeId polynomial(const Term& target, int m, int n) {
    if (n <= 3) return linear(target, m + n, m);
    if (n == 4) return square(target, term(m + 1, 3), m + n, m);
    const int source = m < choices_.rows ? m : m + 1;
    if (n % 2 != 0) return combine(target, term(source, n - 1), term(source, n - 2), m + n, m);
    if (source > m && m + n < degree_) return combine(target, term(source, n), term(source, n - 2), m + n, m);
    return lifted(target, term(source, n - 1), term(source, n - 2), m + n, m);
  }

  [[nodiscard]] const Term& term(int m, int n) const {
    return terms_[static_cast<std::size_t>(m)][static_cast<std::size_t>(n)];
  }

  // c1 w + c0
  NodeId linear(const Term& target, int l, int m) {
    const cl_RA& slope = target.powers[1];
    const cl_RA& start = target.powers[0];
    const bool across = m < ((l - m) % 2 == 0 ? choices_.even_across : choices_.odd_across);
    const std::string name = indexed("p", l, m);
    if (!across) return affine(build_, target.scale * Surd(slope), z2_, target.scale * Surd(start), name);
    // Near the pole 1-w is small: write the constant first.
    const NodeId product = build_.mul(build_.constant(target.scale * Surd(slope), indexed("a", l, m)), across_);
    return build_.sub(build_.constant(target.scale * Surd(slope + start), indexed("b", l, m)), product, name);
  }

  // alpha e^2 + beta
  NodeId square(const Term& target, const Term& e, int l, int m) {
    const cl_RA ratio = target.powers[2] / (e.powers[1] * e.powers[1]);
    const Surd alpha = Surd(ratio) * target.scale / (e.scale * e.scale);
    const cl_RA rest = target.powers[0] - ratio * e.powers[0] * e.powers[0];
    const NodeId first = build_.mul(build_.constant(alpha, indexed("a", l, m)), e.node);
    const NodeId squared = build_.mul(first, e.node);
    const Surd beta = target.scale * Surd(rest);
    const NodeId b = build_.constant(beta.is_negative() ? -beta : beta, indexed("b", l, m));
    return beta.is_negative() ? build_.sub(squared, b, indexed("p", l, m)) : build_.add(squared, b, indexed("p", l, m));
  }

  // r u + s v
  NodeId combine(const Term& target, const Term& u, const Term& v, int l, int m) {
    const auto [r, s] = solve(target.powers, u.powers, v.powers);
    return combination(build_, Surd(r) * target.scale / u.scale, u.node, Surd(s) * target.scale / v.scale, v.node,
                       indexed("p", l, m));
  }

  // r w u + s v
  NodeId lifted(const Term& target, const Term& u, const Term& v, int l, int m) {
    const auto [r, s] = solve(target.powers, raised(u.powers), v.powers);
    const NodeId w = build_.mul(build_.constant(Surd(r) * target.scale / u.scale, indexed("a", l, m)), z2_);
    const NodeId high = build_.mul(w, u.node);
    const NodeId low = build_.mul(build_.constant(-(Surd(s) * target.scale / v.scale), indexed("b", l, m)), v.node);
    return build_.sub(high, low, indexed("p", l, m));
  }

  void store(int l, int m, NodeId axial, bool odd, const Pair& sectoral) {
    if (m == 0) {
      values_[basis_index(l, 0)] = odd ? build_.mul(axial, values_[basis_index(1, 0)], indexed("y", l, 0)) : axial;
    } else if (odd) {
      multiply(l, m, axial, {values_[basis_index(m + 1, m)], values_[basis_index(m + 1, -m)]});
    } else {
      multiply(l, m, axial, sectoral);
    }
  }

  void multiply(int l, int m, NodeId axial, const Pair& pair) {
    const NodeId sine = build_.mul(axial, pair.sine, indexed("y", l, m) + "s");
    const NodeId cosine = build_.mul(axial, pair.cosine, indexed("y", l, m) + "c");
    set(l, m, {cosine, sine});
  }

  void set(int l, int m, const Pair& pair) {
    values_[basis_index(l, m)] = pair.cosine;
    values_[basis_index(l, -m)] = pair.sine;
  }

  Builder& build_;
  Direction d_;
  int degree_;
  ParityChoices choices_;
  NodeId z2_ = -1;
  NodeId across_ = -1;  // 1 - z^2
  std::vector<NodeId> values_;
  std::vector<std::vector<Term>> terms_;  // by column and n; odd n >= 3 hold E_n
};

Kernel with_choices(int degree, const ParityChoices& choices) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.citation = kParitySource;
  kernel.factored = true;
  Builder build(kernel);
  const Direction d = direction_inputs(build);
  set_basis_outputs(kernel, append_parity(build, d, degree, choices));
  return kernel;
}

}  // namespace

std::vector<NodeId> append_parity(Builder& build, const Direction& d, int degree, const ParityChoices& choices) {
  symbolic::require_basis_index(degree, 0);
  return Columns(build, d, degree, choices).values();
}

ParityChoices accurate_choices(int degree) {
  // The error of A_3 without the split square is too large for degree 3, not for those above.
  if (degree <= 3) return {.split_square = true};
  return {.even_across = 2, .odd_across = 2, .rows = 3};
}

Kernel basis_parity(int degree) { return with_choices(degree, accurate_choices(degree)); }

Kernel basis_parity_least(int degree) { return with_choices(degree, {}); }

}  // namespace sh::codegen::recipes
