#include "symbolic/proofs/gaunt_proofs.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/proofs/basis_proofs.hpp"

namespace sh::symbolic {
namespace {

std::string show(int i, int j, int k) {
  std::string text = "(";
  text += std::to_string(i);
  text += ", " + std::to_string(j);
  text += ", " + std::to_string(k);
  return text += ")";
}

int count(int degree) { return (degree + 1) * (degree + 1); }

// Homogeneous polynomials of the basis, raised in degree by powers of x^2+y^2+z^2 as they are asked for.
class RaisedBasis {
 public:
  explicit RaisedBasis(int degree) : basis_(derive_basis(degree)), raised_(basis_.size()) {
    r2_ = Polynomial::variable(0).power(2) + Polynomial::variable(1).power(2) + Polynomial::variable(2).power(2);
  }
  const BasisFunction& operator[](int index) const { return basis_[index]; }
  [[nodiscard]] std::size_t size() const { return basis_.size(); }
  /// The homogeneous polynomial times (x^2+y^2+z^2)^power.
  const Polynomial& raised(int index, int power) {
    std::vector<Polynomial>& list = raised_[index];
    if (list.empty()) list.push_back((*this)[index].homogeneous);
    while (static_cast<int>(list.size()) <= power) list.push_back(list.back() * r2_);
    return list[power];
  }

 private:
  Basis basis_;
  std::vector<std::vector<Polynomial>> raised_;
  Polynomial r2_;
};

// (i, j) -> its expansion, a list of (k, factor).
using Expansions = std::map<std::pair<int, int>, std::vector<std::pair<int, Surd>>>;

Expansions expansions_of(const std::vector<BilinearForm>& forms) {
  Expansions expansions;
  for (const BilinearForm& form : forms) {
    for (const BilinearTerm& term : form.terms) expansions[{term.i, term.j}].emplace_back(form.output, term.factor);
  }
  return expansions;
}

// scale Y_i Y_j = sum of factor Y_k? Divided by the factors of Y_i and Y_j every coefficient is rational.
ProofResult prove_pair(RaisedBasis& basis, int i, int j, int scale, const Expansions& expansions) {
  const BasisFunction& a = basis[i];
  const BasisFunction& b = basis[j];
  const Polynomial product = cln::cl_RA(scale) * (a.homogeneous * b.homogeneous);
  const auto expansion = expansions.find({i, j});
  if (expansion == expansions.end()) return refuted("nothing for the product of functions " + show(i, j, 0));
  Polynomial sum;
  for (const auto& [k, factor] : expansion->second) {
    if (k < 0 || static_cast<std::size_t>(k) >= basis.size()) return refuted("no function " + std::to_string(k));
    const int missing = a.degree + b.degree - basis[k].degree;
    const Surd ratio = factor * basis[k].factor / (a.factor * b.factor);
    if (missing < 0 || missing % 2 != 0 || !(ratio == Surd(ratio.rational()))) {
      return refuted("the entry " + show(i, j, k) + " cannot be part of the product");
    }
    sum += ratio.rational() * basis.raised(k, missing / 2);
  }
  return sum == product ? proved("")
                        : refuted("the product of functions " + std::to_string(i) + " and " + std::to_string(j) +
                                  " differs from its expansion");
}

// Every pair (i, j) of functions up to `degree` whose scale is not 0.
template <class Scale>
ProofResult prove_pairs(const Expansions& expansions, int degree, const Scale& scale) {
  RaisedBasis basis(2 * degree);
  int pairs = 0;
  for (int i = 0; i < count(degree); ++i) {
    for (int j = 0; j < count(degree); ++j) {
      if (scale(i, j) == 0) continue;
      ProofResult pair = prove_pair(basis, i, j, scale(i, j), expansions);
      if (!pair.proved) return pair;
      ++pairs;
    }
  }
  return proved(std::to_string(pairs) + " products");
}

}  // namespace

ProofResult prove_gaunt_tensor(const GauntTensor& claimed, int degree) {
  const GauntTensor expected = gaunt_by_wigner(degree);
  for (const auto& [triple, value] : expected) {
    const auto found = claimed.find(triple);
    if (found == claimed.end()) return refuted("missing entry " + show(triple.i, triple.j, triple.k));
    if (!(found->second == value)) {
      return refuted("entry " + show(triple.i, triple.j, triple.k) + " is " + value.to_string() + ", not " +
                     found->second.to_string());
    }
  }
  for (const auto& [triple, value] : claimed) {
    if (!expected.contains(triple)) return refuted("entry " + show(triple.i, triple.j, triple.k) + " should be zero");
  }
  return proved(std::to_string(expected.size()) + " entries");
}

ProofResult prove_gaunt_symmetry(const std::vector<BilinearForm>& forms) {
  std::map<IndexTriple, Surd> entries;
  for (const BilinearForm& form : forms) {
    for (const BilinearTerm& term : form.terms) entries[{term.i, term.j, form.output}] = term.factor;
  }
  for (const auto& [t, value] : entries) {
    for (const IndexTriple other :
         {IndexTriple{t.j, t.i, t.k}, IndexTriple{t.i, t.k, t.j}, IndexTriple{t.k, t.j, t.i}}) {
      const auto found = entries.find(other);
      if (found == entries.end() || !(found->second == value)) {
        return refuted("entries " + show(t.i, t.j, t.k) + " and " + show(other.i, other.j, other.k) + " differ");
      }
    }
  }
  return proved(std::to_string(entries.size()) + " ordered entries");
}

ProofResult prove_gaunt_selection_rules(const GauntTensor& tensor) {
  for (const auto& [t, value] : tensor) {
    if (!gaunt_may_differ_from_zero(t.i, t.j, t.k)) return refuted("entry " + show(t.i, t.j, t.k) + " breaks a rule");
    if (value.is_zero()) return refuted("entry " + show(t.i, t.j, t.k) + " is stored but zero");
    if (sorted(t) != t) return refuted("entry " + show(t.i, t.j, t.k) + " is not in the order i <= j <= k");
  }
  return proved(std::to_string(tensor.size()) + " entries");
}

ProofResult prove_product_identity(const std::vector<BilinearForm>& forms, int degree) {
  return prove_pairs(expansions_of(forms), degree, [](int, int) { return 1; });
}

ProofResult prove_square_identity(const std::vector<BilinearForm>& forms, int degree) {
  return prove_pairs(expansions_of(forms), degree, [](int i, int j) { return j < i ? 0 : i == j ? 1 : 2; });
}

ProofResult prove_zonal_product_identity(const std::vector<BilinearForm>& forms, int degree) {
  Expansions expansions;
  for (auto& [pair, expansion] : expansions_of(forms)) {
    expansions[{pair.first, coefficient_index(pair.second, 0)}] = expansion;
  }
  return prove_pairs(expansions, degree, [](int, int j) { return degree_order(j).order == 0 ? 1 : 0; });
}

ProofResult prove_transfer_matrix(const std::vector<std::vector<RadicalSum>>& matrix, const std::vector<Surd>& known,
                                  const ProductShape& shape) {
  const Basis basis = derive_basis(std::max({shape.a, shape.b, shape.result}));
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  if (matrix.size() != static_cast<std::size_t>(count(shape.result))) return refuted("the number of rows");
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    if (matrix[row].size() != static_cast<std::size_t>(count(shape.a))) return refuted("the number of columns");
    for (std::size_t column = 0; column < matrix[row].size(); ++column) {
      const Polynomial product = basis[row].homogeneous * basis[column].homogeneous;
      const Surd factor = sphere_area * basis[row].factor * basis[column].factor;
      RadicalSum integral;
      for (std::size_t k = 0; k < known.size(); ++k) {
        if (known[k].is_zero()) continue;
        const cln::cl_RA mean = sphere_mean(product * basis[k].homogeneous);
        if (!cln::zerop(mean)) integral += RadicalSum(factor * basis[k].factor * known[k] * Surd(mean));
      }
      if (!(matrix[row][column] == integral)) {
        return refuted("entry in row " + std::to_string(row) + ", column " + std::to_string(column));
      }
    }
  }
  return proved(std::to_string(count(shape.result) * count(shape.a)) + " entries");
}

namespace {

// A function with every coefficient different: 1, 1/2, 1/3, ...
std::vector<Surd> harmonic_coefficients(int degree) {
  std::vector<Surd> known;
  known.reserve(count(degree));
  for (int k = 0; k < count(degree); ++k) known.emplace_back(cln::cl_RA(1) / (k + 1));
  return known;
}

}  // namespace

std::vector<Proof> gaunt_proofs() {
  const std::string slow = "products of polynomials of higher degree are slow to integrate";
  const std::string fifth_power = "the tensor grows with the fifth power";
  const std::string expansion = "each product is multiplied out and expanded on up to 2 degree + 1 bands";
  return {
      {"gaunt-tensor", "GiNaC's definition G_ijk = integral Y_i Y_j Y_k = Wigner 3j symbols",
       "two derivations compared entry by entry", kMaxGauntDegree, kMaxGauntDegree, fifth_power,
       [](int degree) { return prove_gaunt_tensor(gaunt_tensor(degree), degree); }},
      {"gaunt-symmetry", "G_ijk does not change when its indices are permuted", "every order derived by itself", 9, 10,
       slow,
       [](int degree) {
         return prove_gaunt_symmetry(product_form({degree, degree, degree}));
       }},
      {"gaunt-selection-rules", "G_ijk = 0 unless parity, triangle, signs and orders match",
       "the tensor by integration, which does not use the rules", 9, kMaxGauntDegree, slow,
       [](int degree) { return prove_gaunt_selection_rules(gaunt_tensor(degree)); }},
      {"product-identity", "Y_i Y_j = sum_k G_ijk Y_k on the sphere, k up to 2 degree + 1 bands",
       "polynomials modulo x^2+y^2+z^2 = 1", 9, 10, expansion,
       [](int degree) {
         return prove_product_identity(product_form({degree, degree, 2 * degree}), degree);
       }},
      {"square-identity", "(sum_i a_i Y_i)^2 = sum_k c_k Y_k on the sphere, c = square_form(a)",
       "polynomials modulo x^2+y^2+z^2 = 1", 6, 10, expansion,
       [](int degree) { return prove_square_identity(square_form(degree, 2 * degree), degree); }},
      {"zonal-product-identity", "Y_i Y_l0 = sum_k G Y_k on the sphere", "polynomials modulo x^2+y^2+z^2 = 1", 9, 10,
       expansion,
       [](int degree) {
         return prove_zonal_product_identity(zonal_product_form({degree, degree, 2 * degree}), degree);
       }},
      {"transfer-matrix", "M_ij = integral b Y_i Y_j for a known function b",
       "sum of Gaunt entries against integration of monomials", 3, 6, slow,
       [](int degree) {
         const ProductShape shape{degree, degree, degree};
         const std::vector<Surd> known = harmonic_coefficients(degree);
         return prove_transfer_matrix(transfer_matrix(known, shape), known, shape);
       }},
  };
}

}  // namespace sh::symbolic
