#include "symbolic/convention/convention_map.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sh::symbolic {
namespace {

using RadicalMatrix = Matrix<RadicalSum>;

RadicalMatrix scaled(const RadicalMatrix& m, const RadicalSum& factor) {
  return m.mapped([&](const RadicalSum& entry) { return factor * entry; });
}

// C of ours -> convention, A^-T with the folded factor, and its inverse.
struct BandMap {
  RadicalMatrix forward;
  RadicalMatrix backward;
};
BandMap from_ours(const Convention& convention, int degree) {
  const RadicalSum factor(folded_factor(convention.folded, degree));
  return {scaled(basis_change_inverse(convention, degree).transposed(), factor),
          scaled(basis_change(convention, degree).transposed(), factor.inverse())};
}

// sum over one index of matrix(new, old) * tensor, where matrix is C_l or (C_l^-1)^T of the index's band
TripleTensor contract(const ConventionMap& map, const TripleTensor& tensor, int IndexTriple::*index,
                      bool contravariant) {
  TripleTensor result;
  for (const auto& [triple, value] : tensor) {
    IndexTriple target = triple;
    const DegreeOrder old = degree_order(target.*index);
    const int l = old.degree;
    for (int m = -l; m <= l; ++m) {
      const RadicalSum& weight =
          contravariant ? map.forward[l](l + m, l + old.order) : map.backward[l](l + old.order, l + m);
      if (weight.is_zero()) continue;
      target.*index = coefficient_index(l, m);
      result[target] += weight * value;
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second.is_zero(); });
  return result;
}

void require_product_map(const ConventionMap& map, const TripleTensor& tensor) {
  if (map.folds) {
    throw std::invalid_argument(
        "convention map: products: expected coefficients of radiance, got some that include a clamped cosine");
  }
  for (const auto& [triple, value] : tensor) {
    for (const int index : {triple.i, triple.j, triple.k}) {
      if (degree_order(index).degree > map.degree) {
        throw std::invalid_argument("convention map: expected entries to degree " + std::to_string(map.degree) +
                                    ", got one of degree " + std::to_string(degree_order(index).degree));
      }
    }
  }
}

// contravariant: the third index belongs to coefficients, not to functions
TripleTensor mapped(const ConventionMap& map, const TripleTensor& tensor, bool contravariant) {
  require_product_map(map, tensor);
  TripleTensor result = contract(map, tensor, &IndexTriple::i, false);
  result = contract(map, result, &IndexTriple::j, false);
  return contract(map, result, &IndexTriple::k, contravariant);
}

}  // namespace

ConventionMap convention_map(const Convention& from, const Convention& to, int degree) {
  require_convention(from, degree);
  require_convention(to, degree);
  ConventionMap map{degree, from.order, to.order, {}, {}, from.folded != to.folded || from.folded != Folded::kNothing};
  for (int l = 0; l <= degree; ++l) {
    const BandMap source = from_ours(from, l);
    const BandMap target = from_ours(to, l);
    map.forward.push_back(target.forward * source.backward);
    map.backward.push_back(source.forward * target.backward);
  }
  return map;
}

ConventionMap compose(const ConventionMap& second, const ConventionMap& first) {
  if (second.degree != first.degree || second.from_order != first.to_order) {
    throw std::invalid_argument(
        "convention map: expected two maps that meet in one degree and index order, got others");
  }
  ConventionMap map{first.degree, first.from_order, second.to_order, {}, {}, first.folds || second.folds};
  for (std::size_t l = 0; l < first.forward.size(); ++l) {
    map.forward.push_back(second.forward[l] * first.forward[l]);
    map.backward.push_back(first.backward[l] * second.backward[l]);
  }
  return map;
}

bool is_identity(const ConventionMap& map) {
  if (map.from_order != map.to_order) return false;
  for (std::size_t l = 0; l < map.forward.size(); ++l) {
    const auto one = RadicalMatrix::identity(map.forward[l].rows(), RadicalSum(cln::cl_RA(1)));
    if (!(map.forward[l] == one) || !(map.backward[l] == one)) return false;
  }
  return true;
}

TripleTensor all_orders(const GauntTensor& tensor) {
  TripleTensor result;
  for (const auto& [t, value] : tensor) {
    const RadicalSum number(value);
    std::array<int, 3> order{t.i, t.j, t.k};  // sorted: the first permutation
    do {
      result.emplace(IndexTriple{order[0], order[1], order[2]}, number);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return result;
}

TripleTensor map_triple_integral(const ConventionMap& map, const TripleTensor& tensor) {
  return mapped(map, tensor, false);
}

TripleTensor map_product_form(const ConventionMap& map, const TripleTensor& tensor) {
  return mapped(map, tensor, true);
}

}  // namespace sh::symbolic
