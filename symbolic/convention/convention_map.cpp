#include "symbolic/convention/convention_map.hpp"

#include <stdexcept>
#include <string>

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

enum class Slot { kFirst, kSecond, kThird };

int& index_at(IndexTriple& t, Slot slot) { return slot == Slot::kFirst ? t.i : slot == Slot::kSecond ? t.j : t.k; }

// sum over the index in `slot` of matrix(new, old) * tensor, where matrix is C_l or (C_l^-1)^T of the index's band
TripleTensor contract(const ConventionMap& map, const TripleTensor& tensor, Slot slot, bool contravariant) {
  TripleTensor result;
  for (const auto& [triple, value] : tensor) {
    IndexTriple target = triple;
    const DegreeOrder old = degree_order(index_at(target, slot));
    const int l = old.degree;
    const auto band = static_cast<std::size_t>(l);
    for (int m = -l; m <= l; ++m) {
      const RadicalSum& weight =
          contravariant ? map.forward[band](l + m, l + old.order) : map.backward[band](l + old.order, l + m);
      if (weight.is_zero()) continue;
      index_at(target, slot) = coefficient_index(l, m);
      result[target] += weight * value;
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second.is_zero(); });
  return result;
}

void require_product_map(const ConventionMap& map, const TripleTensor& tensor) {
  if (map.folds) {
    throw std::invalid_argument(
        "convention map: products are not mapped with a clamped cosine folded in; they should be formed before");
  }
  for (const auto& [triple, value] : tensor) {
    for (const int index : {triple.i, triple.j, triple.k}) {
      if (degree_order(index).degree > map.degree) {
        throw std::invalid_argument("convention map: a tensor entry of degree " +
                                    std::to_string(degree_order(index).degree) + "; the map should reach it, not " +
                                    std::to_string(map.degree));
      }
    }
  }
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

ConventionMap inverse(const ConventionMap& map) {
  return {map.degree, map.to_order, map.from_order, map.backward, map.forward, map.folds};
}

ConventionMap compose(const ConventionMap& second, const ConventionMap& first) {
  if (second.degree != first.degree || second.from_order != first.to_order) {
    throw std::invalid_argument("convention map: composed maps should have equal degree and meet in one index order");
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

std::vector<RadicalSum> map_coefficients(const ConventionMap& map, const std::vector<RadicalSum>& coefficients) {
  const int expected = storage_size(map.from_order, map.degree);
  if (static_cast<int>(coefficients.size()) != expected) {
    throw std::invalid_argument("convention map: " + std::to_string(coefficients.size()) +
                                " coefficients; there should be " + std::to_string(expected));
  }
  std::vector<RadicalSum> result(storage_size(map.to_order, map.degree));
  for (int l = 0; l <= map.degree; ++l) {
    const RadicalMatrix& c = map.forward[l];
    for (int m = -l; m <= l; ++m) {
      RadicalSum sum;
      for (int n = -l; n <= l; ++n) {
        sum += c(l + m, l + n) * coefficients[storage_position(map.from_order, map.degree, l, n)];
      }
      result[storage_position(map.to_order, map.degree, l, m)] = sum;
    }
  }
  return result;
}

std::vector<RadicalMatrix> map_rotation(const ConventionMap& map, const std::vector<RadicalMatrix>& bands) {
  if (bands.size() != map.forward.size()) {
    throw std::invalid_argument("convention map: " + std::to_string(bands.size()) + " bands; there should be " +
                                std::to_string(map.forward.size()));
  }
  std::vector<RadicalMatrix> result;
  for (std::size_t l = 0; l < bands.size(); ++l) result.push_back(map.forward[l] * bands[l] * map.backward[l]);
  return result;
}

TripleTensor all_orders(const GauntTensor& tensor) {
  TripleTensor result;
  for (const auto& [t, value] : tensor) {
    const RadicalSum number(value);
    for (const IndexTriple& order :
         {IndexTriple{t.i, t.j, t.k}, IndexTriple{t.i, t.k, t.j}, IndexTriple{t.j, t.i, t.k},
          IndexTriple{t.j, t.k, t.i}, IndexTriple{t.k, t.i, t.j}, IndexTriple{t.k, t.j, t.i}}) {
      result.insert_or_assign(order, number);
    }
  }
  return result;
}

TripleTensor map_triple_integral(const ConventionMap& map, const TripleTensor& tensor) {
  require_product_map(map, tensor);
  TripleTensor result = contract(map, tensor, Slot::kFirst, false);
  result = contract(map, result, Slot::kSecond, false);
  return contract(map, result, Slot::kThird, false);
}

TripleTensor map_product_form(const ConventionMap& map, const TripleTensor& tensor) {
  require_product_map(map, tensor);
  TripleTensor result = contract(map, tensor, Slot::kFirst, false);
  result = contract(map, result, Slot::kSecond, false);
  return contract(map, result, Slot::kThird, true);
}

}  // namespace sh::symbolic
