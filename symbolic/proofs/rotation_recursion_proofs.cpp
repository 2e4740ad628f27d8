// Proofs about the recursion over the bands: its tables, its agreement with the quaternion form, rational rotations.
#include <cstdlib>
#include <random>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/rotation_compare.hpp"

namespace sh::symbolic {
namespace {

using RationalMatrix = Matrix<cln::cl_RA>;

// A random rotation with exact rational entries.
class RationalRotations {
 public:
  RationalMatrix next() {
    std::array<cln::cl_RA, 4> q;
    cln::cl_RA norm = 0;
    do {
      norm = 0;
      for (cln::cl_RA& component : q) {
        component = static_cast<int>(random_() % 19999U) - 9999;
        norm = norm + component * component;
      }
    } while (cln::zerop(norm));
    return matrix_from_quaternion<cln::cl_RA>(q).mapped(
        [&](const cln::cl_RA& entry) -> cln::cl_RA { return entry / norm; });
  }

 private:
  std::mt19937 random_{20040301};
};

const Polynomial& solid(const Basis& basis, int degree, int order) {
  return basis.at(coefficient_index(degree, order)).homogeneous;
}

// k_l1^2 / k_l2^2
cln::cl_RA squared_ratio(int degree, int order, int degree_below, int order_below) {
  return squared_factor(degree, order) / squared_factor(degree_below, order_below);
}

// x_i S_(l-1)b without its part in band l-2, which is r^2 dS_(l-1)b/dx_i / (2l-1).
Polynomial harmonic_part(const Basis& basis, int l, int axis, int below) {
  const Polynomial& s = solid(basis, l - 1, below);
  return Polynomial::variable(axis) * s - cln::cl_RA(1) / (2 * l - 1) * (dot_product(0, 0) * s.derivative(axis));
}

// The harmonic part is sum_a g_a S_la; a coupling has weight g_a k_(l-1)b^2 / k_la^2.
void require_couplings(const Basis& basis, const std::vector<std::vector<Coupling>>& couplings, int l, int below) {
  for (int axis = 0; axis < 3; ++axis) {
    Polynomial difference = harmonic_part(basis, l, axis, below);
    for (int above = -l; above <= l; ++above) {
      for (const Coupling& c : couplings.at(l + above)) {
        if (c.axis != axis || c.below != below) continue;
        difference -= c.weight * squared_ratio(l, above, l - 1, below) * solid(basis, l, above);
      }
    }
    if (!difference.is_zero()) {
      throw Refuted("l=" + std::to_string(l) + ": the couplings to order " + std::to_string(below) + " along axis " +
                    std::to_string(axis));
    }
  }
}

// The scale is k_ln^2 / (k_(l-1)^2 g), where S_ln has the part g in z S_(l-1)n, or in x S_+-(l-1) -+ y S_-+(l-1).
void require_column_scales(const Basis& basis, const RecursionTables& tables, int l) {
  for (int n = -l; n <= l; ++n) {
    const int below = std::abs(n) < l ? n : n > 0 ? l - 1 : 1 - l;
    const cln::cl_RA inverse_g = tables.scale(l, n) / squared_ratio(l, n, l - 1, below);
    Polynomial part;
    if (std::abs(n) < l) {
      part = harmonic_part(basis, l, 2, below);
    } else {
      const Polynomial y = Polynomial::variable(1) * solid(basis, l - 1, -below);
      part = Polynomial::variable(0) * solid(basis, l - 1, below) + cln::cl_RA(n > 0 ? -1 : 1) * y;
    }
    if (!(solid(basis, l, n) == inverse_g * part)) {
      throw Refuted("l=" + std::to_string(l) + ": the scale of column " + std::to_string(n));
    }
  }
}

void prove_tables_of_band(const Basis& basis, const RecursionTables& tables, int l) {
  const auto couplings = tables.couplings(l);
  for (int below = 1 - l; below < l; ++below) require_couplings(basis, couplings, l, below);
  if (l > 1) require_column_scales(basis, tables, l);  // the recursion begins with band 2
}

}  // namespace

int prove_recursion_tables(const Basis& basis, const RecursionTables& tables) {
  const int degree = basis.back().degree;
  for (int l = 1; l <= degree; ++l) prove_tables_of_band(basis, tables, l);
  return degree;
}

int prove_recursion_agrees(const std::vector<QuaternionRotation>& bands,
                           const std::vector<Matrix<Polynomial>>& recursion) {
  int count = 0;
  for (const QuaternionRotation& band : bands) {
    count += require_same(band.degree, band.entries, recursion.at(band.degree), "quaternion form and recursion differ");
  }
  return count;
}

int prove_orthogonality_at_points(const BandsAt& bands_at, int points) {
  RationalRotations rotations;
  for (int point = 0; point < points; ++point) {
    int degree = 0;
    for (const RationalMatrix& band : bands_at(rotations.next())) require_orthogonal(degree++, band, cln::cl_RA(1));
  }
  return points;
}

int prove_composition_at_points(const BandsAt& bands_at, int points) {
  RationalRotations rotations;
  for (int point = 0; point < points; ++point) {
    const RationalMatrix a = rotations.next();
    const RationalMatrix b = rotations.next();
    const auto bands_a = bands_at(a);
    const auto bands_b = bands_at(b);
    const auto bands_ab = bands_at(a * b);
    for (int l = 0; l < static_cast<int>(bands_a.size()); ++l) {
      require_same(l, bands_a[l] * bands_b[l], bands_ab[l], "D(a) D(b) differs from D(ab)");
    }
  }
  return points;
}

}  // namespace sh::symbolic
