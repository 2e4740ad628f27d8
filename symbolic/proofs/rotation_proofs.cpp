// Proofs about the quaternion form of a rotation.
#include <algorithm>
#include <map>
#include <utility>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/rotation_compare.hpp"

namespace sh::symbolic {
namespace {

// Monomials with polynomials in place of their variables, each made from one with a power less.
class SubstitutedMonomials {
 public:
  explicit SubstitutedMonomials(std::vector<Polynomial> values) : values_(std::move(values)) {
    known_.emplace(Monomial(), Polynomial(1));
  }
  const Polynomial& operator()(const Monomial& monomial) {
    const auto position = known_.find(monomial);
    if (position != known_.end()) return position->second;
    std::vector<int> exponents;
    for (std::size_t i = 0; i < values_.size(); ++i) exponents.push_back(monomial.exponent(static_cast<int>(i)));
    const auto first = std::find_if(exponents.begin(), exponents.end(), [](int exponent) { return exponent > 0; });
    --*first;
    const auto variable = static_cast<std::size_t>(first - exponents.begin());
    return known_.emplace(monomial, values_.at(variable) * (*this)(Monomial(exponents))).first->second;
  }
  Polynomial in(const Polynomial& p) {
    Polynomial sum;
    for (const auto& [monomial, coefficient] : p.terms()) sum += coefficient * (*this)(monomial);
    return sum;
  }
  void forget_below(int degree) {
    std::erase_if(known_, [degree](const auto& entry) { return entry.first.degree() < degree; });
  }

 private:
  std::vector<Polynomial> values_;
  std::map<Monomial, Polynomial> known_;
};

// M(q) v. Variables 0..3 are q, 4..6 are v.
std::vector<Polynomial> turned_point(const Matrix<Polynomial>& m) {
  std::vector<Polynomial> turned(3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) turned[i] += m(i, j) * Polynomial::variable(4 + j);
  }
  return turned;
}

// q.q in variables first .. first+3
Polynomial squared_norm(int first) {
  Polynomial sum;
  for (int i = 0; i < 4; ++i) sum += Polynomial::variable(first + i).power(2);
  return sum;
}

}  // namespace

std::vector<QuaternionRotation> derive_quaternion_rotations(int degree) {
  std::vector<QuaternionRotation> bands;
  for (int l = 0; l <= degree; ++l) bands.push_back(quaternion_rotation(l));
  return bands;
}

int prove_equivariance(const std::vector<QuaternionRotation>& bands, const Basis& basis,
                       const Matrix<Polynomial>& matrix) {
  SubstitutedMonomials turned(turned_point(matrix));
  for (const QuaternionRotation& band : bands) {
    const int l = band.degree;
    std::vector<Polynomial> right;  // S_ln(v)
    for (int n = 0; n <= 2 * l; ++n) right.push_back(moved(basis.at(l * l + n).homogeneous, 4));
    for (int m = 0; m <= 2 * l; ++m) {
      Polynomial difference = turned.in(basis.at(l * l + m).homogeneous);
      for (int n = 0; n <= 2 * l; ++n) difference -= band.entries(m, n) * right[n];
      if (!difference.is_zero()) throw Refuted("l=" + std::to_string(l) + " m=" + std::to_string(m - l));
    }
    turned.forget_below(l);
  }
  return static_cast<int>(bands.size());
}

int prove_quaternion_matrix(const Matrix<Polynomial>& matrix, const QuaternionProduct& product) {
  const auto quaternion = [](int first) {
    return Quaternion<Polynomial>{Polynomial::variable(first), Polynomial::variable(first + 1),
                                  Polynomial::variable(first + 2), Polynomial::variable(first + 3)};
  };
  const Quaternion<Polynomial> a = quaternion(0);
  const Quaternion<Polynomial> b = quaternion(4);
  const Quaternion<Polynomial> ab = product(a, b);
  const Polynomial none;
  const Quaternion<Polynomial> conjugate{a[0], none - a[1], none - a[2], none - a[3]};
  const Quaternion<Polynomial> turned = product(product(a, {none, b[1], b[2], b[3]}), conjugate);
  for (int i = 0; i < 3; ++i) {
    Polynomial row = turned[i + 1];
    for (int j = 0; j < 3; ++j) row -= matrix(i, j) * b[j + 1];
    if (!row.is_zero()) throw Refuted("row " + std::to_string(i) + " of M(q) v is not that of q v q*");
  }
  const auto at = [&](const Quaternion<Polynomial>& q) {
    return matrix.mapped([&](const Polynomial& entry) { return substitute(entry, q); });
  };
  if (!(at(a) * at(b) == at(ab))) throw Refuted("M(a) M(b) differs from M(ab)");
  Polynomial norm;
  for (const Polynomial& component : ab) norm += component * component;
  if (!(norm == squared_norm(0) * squared_norm(4))) throw Refuted("|ab| differs from |a| |b|");
  return 3;
}

int prove_orthogonality(const std::vector<QuaternionRotation>& bands) {
  for (const QuaternionRotation& band : bands) {
    require_orthogonal(band.degree, band.entries, squared_norm(0).power(2 * band.degree));
  }
  return static_cast<int>(bands.size());
}

int prove_composition(const std::vector<QuaternionRotation>& bands) {
  Quaternion<Polynomial> a;
  Quaternion<Polynomial> b;
  for (int i = 0; i < 4; ++i) {
    a[i] = Polynomial::variable(i);
    b[i] = Polynomial::variable(i + 4);
  }
  const Quaternion<Polynomial> ab = quaternion_product(a, b);
  SubstitutedMonomials in_b({b.begin(), b.end()});
  SubstitutedMonomials in_ab({ab.begin(), ab.end()});
  int count = 0;
  for (const QuaternionRotation& band : bands) {
    const Matrix<Polynomial> t_b = band.entries.mapped([&](const Polynomial& p) { return in_b.in(p); });
    const Matrix<Polynomial> t_ab = band.entries.mapped([&](const Polynomial& p) { return in_ab.in(p); });
    count += require_same(band.degree, band.entries * t_b, t_ab, "T(a) T(b) differs from T(ab)");
  }
  return count;
}

}  // namespace sh::symbolic
