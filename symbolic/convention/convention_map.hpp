// Exact maps between two conventions.
//
// A map holds one matrix C_l per band: c'_l = C_l c_l, where both arrays describe the same function of direction. Maps
// compose exactly. All other objects follow:
//   coefficients       c' = C c, read and written in the arrays' own index order
//   basis functions    Y' = C^-T Y                           (the opposite way: larger functions have smaller coefficients)
//   rotation matrix    c' = D c becomes D' = C D C^-1        R given in our axes; in the other's it is axes R axes^-1
//   triple integral    G_ijk = integral Y_i Y_j Y_k          becomes G'_abc = sum C^-T_ai C^-T_bj C^-T_ck G_ijk
//   product form       (fg)_k = sum P_ijk f_i g_j            becomes P'_abc = sum C^-T_ai C^-T_bj C_ck P_ijk
// In an orthonormal real basis both tensors are the Gaunt tensor; in any other they differ.
#pragma once

#include <map>
#include <vector>

#include "symbolic/convention/convention.hpp"
#include "symbolic/number/matrix.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic {

struct ConventionMap {
  int degree = 0;  ///< bands 0..degree
  IndexOrder from_order = IndexOrder::kAcn;
  IndexOrder to_order = IndexOrder::kAcn;
  std::vector<Matrix<RadicalSum>> forward;   ///< C_l, rows and columns -l .. l
  std::vector<Matrix<RadicalSum>> backward;  ///< C_l^-1
  bool folds = false;  ///< a clamped cosine is folded in or out: products of functions are not mapped

  friend bool operator==(const ConventionMap&, const ConventionMap&) = default;
};

/// Throws std::invalid_argument as require_convention does for either side.
ConventionMap convention_map(const Convention& from, const Convention& to, int degree);
/// First `first`, then `second`. Throws std::invalid_argument unless degree and index order meet.
ConventionMap compose(const ConventionMap& second, const ConventionMap& first);
/// C_l = 1 in every band, same order on both sides.
bool is_identity(const ConventionMap& map);

/// All non-zero entries, every order of the indices; an index is l(l+1)+m in every array order.
using TripleTensor = std::map<IndexTriple, RadicalSum>;
/// The entries of a symmetric tensor in all orders.
TripleTensor all_orders(const GauntTensor& tensor);
/// Both throw std::invalid_argument when the map folds a cosine or an index exceeds its degree.
TripleTensor map_triple_integral(const ConventionMap& map, const TripleTensor& tensor);
TripleTensor map_product_form(const ConventionMap& map, const TripleTensor& tensor);

}  // namespace sh::symbolic
