// Parts that the exact references of the families share.
#pragma once

#include "codegen/families/family.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {

using numeric::coefficient_count;
using symbolic::Surd;
using Rationals = std::vector<cln::cl_RA>;
using Inputs = std::vector<std::vector<double>>;

/// Each point with the exact outputs there: outputs(point) -> std::vector<cln::cl_F>.
template <class Points, class Outputs>
Reference reference_at(const Points& points, const Outputs& outputs) {
  Reference reference;
  for (const auto& point : points) {
    const Rationals inputs(point.begin(), point.end());
    reference.push_back({inputs, outputs(inputs)});
  }
  return reference;
}

/// The value with some more digits than a check compares, because sums lose digits.
inline cln::cl_F precise(const Surd& exact) { return exact.evaluate(kCheckDigits + 10); }
inline cln::cl_F precise(const cln::cl_RA& exact) { return precise(Surd(exact)); }

/// exact(i) for i = 0 .. count - 1.
template <class Exact>
std::vector<cln::cl_F> precise_values(int count, const Exact& exact) {
  std::vector<cln::cl_F> values;
  for (int i = 0; i < count; ++i) values.push_back(precise(exact(i)));
  return values;
}

/// Function i of the basis, by degree and order.
inline const symbolic::BasisFunction& basis_function(int i) {
  const auto [l, m] = symbolic::degree_order(i);
  return symbolic::basis_function(l, m);
}

/// r^l Y_lm at the point, by the homogeneous form; i = l(l+1)+m.
inline Surd basis_value(int i, std::span<const cln::cl_RA> point) {
  const symbolic::BasisFunction& f = basis_function(i);
  return Surd(f.homogeneous.evaluate(point)) * f.factor;
}

}  // namespace sh::codegen
