// Recipes: all real spherical harmonics up to a degree, as products of the factors of the orders with polynomials in z.
// For odd n >= 3, E_n multiplies Y_(m+1,+-m), which already contains the factor z.
//
//   chebyshev  the columns of chebyshev_columns.hpp: small error
//   parity     those of parity_columns.hpp: few operations
#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/basis/chebyshev_columns.hpp"
#include "codegen/recipes/basis/parity_columns.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

// Computes the values from the parts.
class Values {
 public:
  struct Options {
    NodeId r2 = -1;           // off the unit sphere
    NodeId weight = -1;       // multiplies the values of order 0; for other orders `sectoral` includes it
    bool zonal_rows = false;  // m = 0, n >= 5 by the recurrence in l: equally many operations, smaller error
    bool z_last = false;      // Y_(m+1,m) as z (c A_m) instead of (c z) A_m
  };

  Values(Builder& build, NodeId z, int degree, const Options& options)
      : build_(build), z_(z), degree_(degree), options_(options), values_(coefficient_count(degree)) {}

  template <class Columns>
  std::vector<NodeId> make(const Columns& columns, const std::vector<Pair>& sectoral) && {
    for (int m = degree_; m > 0; --m) column(m, columns, sectoral[m]);
    for (int l = 0; l <= degree_; ++l) values_[coefficient_index(l, 0)] = zonal(l, columns);
    return std::move(values_);
  }

 private:
  template <class Columns>
  void column(int m, const Columns& columns, const Pair& sectoral) {
    set(m, m, sectoral);
    for (int l = m + 1; l <= degree_; ++l) {
      const int n = l - m;
      const Pair base = n % 2 == 0 || n == 1 ? sectoral : Pair{value(m + 1, m), value(m + 1, -m)};
      if (n == 1 && options_.z_last) {
        raise(l, m, sectoral);
        continue;
      }
      const NodeId sine = build_.mul(columns.at(m, n), base.sine, indexed("y", l, m) + "s");
      const NodeId cosine = build_.mul(columns.at(m, n), base.cosine, indexed("y", l, m) + "c");
      set(l, m, {cosine, sine});
    }
  }

  // z (c A_m), z (c B_m)
  void raise(int l, int m, const Pair& sectoral) {
    const NodeId c = build_.constant(upper_factor(l, m), indexed("k", l, m));
    const NodeId sine = build_.mul(z_, build_.mul(c, sectoral.sine), indexed("y", l, m) + "s");
    const NodeId cosine = build_.mul(z_, build_.mul(c, sectoral.cosine), indexed("y", l, m) + "c");
    set(l, m, {cosine, sine});
  }

  template <class Columns>
  NodeId zonal(int l, const Columns& columns) {
    if (l >= 5 && options_.zonal_rows) return zonal_row(l);
    if (l >= 3 && l % 2 != 0) return build_.mul(columns.at(0, l), value(1, 0), indexed("y", l, 0));
    const NodeId axial = columns.at(0, l);
    return options_.weight < 0 ? axial : build_.mul(axial, options_.weight, indexed("y", l, 0));
  }

  // Y_l0 = a z Y_(l-1)0 - b Y_(l-2)0
  NodeId zonal_row(int l) {
    const NodeId az = build_.mul(build_.constant(upper_factor(l, 0), indexed("a", l, 0)), z_);
    const NodeId high = build_.mul(az, value(l - 1, 0));
    NodeId b = build_.constant(lower_factor(l, 0), indexed("b", l, 0));
    if (options_.r2 >= 0) b = build_.mul(b, options_.r2);
    return build_.sub(high, build_.mul(b, value(l - 2, 0)), indexed("p", l, 0));
  }

  [[nodiscard]] NodeId value(int l, int m) const { return values_[coefficient_index(l, m)]; }

  void set(int l, int m, const Pair& pair) {
    values_[coefficient_index(l, m)] = pair.cosine;
    values_[coefficient_index(l, -m)] = pair.sine;
  }

  Builder& build_;
  NodeId z_;
  int degree_;
  Options options_;
  std::vector<NodeId> values_;
};

template <class Append>
Kernel by_columns(int degree, const char* source, const Append& append) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.citation = source;
  kernel.factored = true;
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build);
  set_outputs(kernel, append(build, d));
  return kernel;
}

Kernel with_choices(int degree, const ParityChoices& choices) {
  return by_columns(degree, kParitySource,
                    [&](SignedBuilder& build, const Direction& d) { return append_parity(build, d, degree, choices); });
}

}  // namespace

std::vector<NodeId> append_parity(SignedBuilder& build, const Direction& d, int degree, const ParityChoices& choices,
                                  NodeId weight) {
  symbolic::require_basis_index(degree, 0);
  const Squares squares = unit_squares(build, d.z);
  std::vector<Pair> sectoral = append_sectoral(build, d, degree, squares, choices.split_square);
  if (weight >= 0) sectoral = append_weighted_sectoral(build, d, weight, sectoral, squares, choices.split_square);
  const ParityColumns columns(build, d.z, squares, degree, choices);
  return Values(build, d.z, degree, {-1, weight, choices.rows > 0, false}).make(columns, sectoral);
}

std::vector<NodeId> append_chebyshev(SignedBuilder& build, const Direction& d, int degree, NodeId weight) {
  symbolic::require_basis_index(degree, 0);
  const Squares squares = chebyshev_squares(build, d);
  std::vector<Pair> sectoral = append_sectoral(build, d, degree, squares, false);
  if (weight >= 0) sectoral = append_weighted_sectoral(build, d, weight, sectoral, squares, false);
  const ChebyshevColumns columns(build, d.z, squares, degree);
  return Values(build, d.z, degree, {-1, weight, false, false}).make(columns, sectoral);
}

std::vector<NodeId> append_solid(SignedBuilder& build, const Direction& d, int degree) {
  symbolic::require_basis_index(degree, 0);
  const Squares squares = append_squares(build, d);
  const std::vector<Pair> sectoral = append_sectoral(build, d, degree, squares, false);
  const ParityColumns columns(build, d.z, squares, degree, accurate_choices(degree));
  return Values(build, d.z, degree, {squares.r2, -1, true, true}).make(columns, sectoral);
}

Kernel basis_chebyshev(int degree) {
  return by_columns(degree, kChebyshevSource,
                    [&](SignedBuilder& build, const Direction& d) { return append_chebyshev(build, d, degree); });
}

Kernel basis_parity(int degree) { return with_choices(degree, accurate_choices(degree)); }

Kernel basis_parity_least(int degree) { return with_choices(degree, {}); }

}  // namespace sh::codegen::recipes
