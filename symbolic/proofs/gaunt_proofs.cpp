#include <algorithm>
#include <map>
#include <utility>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

std::string show(int i, int j, int k) {
  return "(" + std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) + ")";
}
std::string show(const IndexTriple& t) { return show(t.i, t.j, t.k); }

// Homogeneous polynomials of the basis, and their products with powers of x^2+y^2+z^2, each made once.
class RaisedBasis {
 public:
  explicit RaisedBasis(int degree) : basis_(derive_basis(degree)), raised_(basis_.size()) {
    r2_ = Polynomial::variable(0).power(2) + Polynomial::variable(1).power(2) + Polynomial::variable(2).power(2);
  }
  const BasisFunction& operator[](int index) const { return basis_[index]; }
  [[nodiscard]] int size() const { return static_cast<int>(basis_.size()); }
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

// scale Y_i Y_j = sum of factor Y_k. Divided by the factors of Y_i and Y_j every coefficient is rational.
void require_product(RaisedBasis& basis, int i, int j, int scale, const Expansions& expansions) {
  const BasisFunction& a = basis[i];
  const BasisFunction& b = basis[j];
  const std::string pair = "functions " + std::to_string(i) + " and " + std::to_string(j);
  const auto expansion = expansions.find({i, j});
  if (expansion == expansions.end()) throw Refuted("nothing for the product of " + pair);
  Polynomial sum;
  for (const auto& [k, factor] : expansion->second) {
    if (k < 0 || k >= basis.size()) throw Refuted("no function " + std::to_string(k));
    const int missing = a.degree + b.degree - basis[k].degree;
    const Surd ratio = factor * basis[k].factor / (a.factor * b.factor);
    if (missing < 0 || missing % 2 != 0 || !ratio.is_rational()) {
      throw Refuted("the entry " + show(i, j, k) + " cannot be part of the product");
    }
    sum += ratio.rational() * basis.raised(k, missing / 2);
  }
  if (sum == cln::cl_RA(scale) * (a.homogeneous * b.homogeneous)) return;
  throw Refuted("the product of " + pair + " differs from its expansion");
}

// Every pair (i, j) of functions up to `degree` whose scale is not 0. Y_i Y_j and Y_j Y_i have one expansion.
template <class Scale>
int prove_pairs(const Expansions& expansions, int degree, const Scale& scale) {
  RaisedBasis basis(2 * degree);
  int pairs = 0;
  for (int i = 0; i < coefficient_count(degree); ++i) {
    for (int j = 0; j < coefficient_count(degree); ++j) {
      if (scale(i, j) == 0) continue;
      ++pairs;
      const auto other = expansions.find({j, i});
      const bool known = j < i && scale(j, i) == scale(i, j) && other != expansions.end();
      if (known && expansions.contains({i, j}) && expansions.at({i, j}) == other->second) continue;
      require_product(basis, i, j, scale(i, j), expansions);
    }
  }
  return pairs;
}

}  // namespace

int prove_gaunt_tensor(const GauntTensor& claimed, int degree) {
  const GauntTensor expected = gaunt_by_wigner(degree);
  for (const auto& [triple, value] : expected) {
    const auto found = claimed.find(triple);
    if (found == claimed.end()) throw Refuted("missing entry " + show(triple));
    if (found->second == value) continue;
    throw Refuted("entry " + show(triple) + " is " + value.to_string() + ", not " + found->second.to_string());
  }
  for (const auto& [triple, value] : claimed) {
    if (!expected.contains(triple)) throw Refuted("entry " + show(triple) + " should be zero");
  }
  return static_cast<int>(expected.size());
}

int prove_gaunt_symmetry(const std::vector<BilinearForm>& forms) {
  std::map<IndexTriple, Surd> entries;
  for (const BilinearForm& form : forms) {
    for (const BilinearTerm& term : form.terms) entries[{term.i, term.j, form.output}] = term.factor;
  }
  for (const auto& [t, value] : entries) {
    for (const IndexTriple other : {IndexTriple{t.j, t.i, t.k}, {t.i, t.k, t.j}, {t.k, t.j, t.i}}) {
      const auto found = entries.find(other);
      if (found != entries.end() && found->second == value) continue;
      throw Refuted("entries " + show(t) + " and " + show(other) + " differ");
    }
  }
  return static_cast<int>(entries.size());
}

int prove_gaunt_selection_rules(const GauntTensor& tensor, const SelectionRule& rule) {
  for (const auto& [t, value] : tensor) {
    if (!rule(t.i, t.j, t.k)) throw Refuted("entry " + show(t) + " breaks a rule");
    if (value.is_zero()) throw Refuted("entry " + show(t) + " is stored but zero");
    if (sorted(t) != t) throw Refuted("entry " + show(t) + " is not in the order i <= j <= k");
  }
  return static_cast<int>(tensor.size());
}

int prove_product_identity(const std::vector<BilinearForm>& forms, int degree) {
  return prove_pairs(expansions_of(forms), degree, [](int, int) { return 1; });
}

int prove_square_identity(const std::vector<BilinearForm>& forms, int degree) {
  return prove_pairs(expansions_of(forms), degree, [](int i, int j) { return j < i ? 0 : i == j ? 1 : 2; });
}

int prove_zonal_product_identity(const std::vector<BilinearForm>& forms, int degree) {
  Expansions expansions;
  for (auto& [pair, expansion] : expansions_of(forms)) {
    expansions[{pair.first, coefficient_index(pair.second, 0)}] = expansion;
  }
  return prove_pairs(expansions, degree, [](int, int j) { return degree_order(j).order == 0 ? 1 : 0; });
}

int prove_transfer_matrix(const Matrix<RadicalSum>& matrix, const std::vector<Surd>& known, const ProductShape& shape) {
  const Basis basis = derive_basis(std::max({shape.a, shape.b, shape.result}));
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  if (matrix.rows() != coefficient_count(shape.result)) throw Refuted("the number of rows");
  if (matrix.columns() != coefficient_count(shape.a)) throw Refuted("the number of columns");
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.columns(); ++column) {
      const Polynomial product = basis[row].homogeneous * basis[column].homogeneous;
      const Surd factor = sphere_area * basis[row].factor * basis[column].factor;
      RadicalSum integral;
      for (std::size_t k = 0; k < known.size(); ++k) {
        if (known[k].is_zero()) continue;
        const cln::cl_RA mean = sphere_mean(product * basis[k].homogeneous);
        integral += RadicalSum(factor * basis[k].factor * known[k] * Surd(mean));
      }
      if (matrix(row, column) == integral) continue;
      throw Refuted("entry in row " + std::to_string(row) + ", column " + std::to_string(column));
    }
  }
  return matrix.rows() * matrix.columns();
}

}  // namespace sh::symbolic
