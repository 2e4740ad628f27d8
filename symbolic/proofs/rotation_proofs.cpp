#include <map>
#include <random>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

using RationalMatrix = Matrix<cln::cl_RA>;

std::string entry_name(int degree, int row, int column) {
  return "l=" + std::to_string(degree) + " entry (" + std::to_string(row - degree) + ", " +
         std::to_string(column - degree) + ")";
}

// x^a y^b z^c at M(q) v, each made from one with a power less. Variables 0..3 are q, 4..6 are v.
class TurnedMonomials {
 public:
  TurnedMonomials() {
    const Matrix<Polynomial> m = quaternion_matrix();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) turned_[i] += m(i, j) * Polynomial::variable(4 + j);
    }
    known_.emplace(Monomial(), Polynomial(1));
  }
  const Polynomial& operator()(const Monomial& monomial) {
    const auto position = known_.find(monomial);
    if (position != known_.end()) return position->second;
    std::array<int, 3> exponents{monomial.exponent(0), monomial.exponent(1), monomial.exponent(2)};
    const int axis = exponents[0] > 0 ? 0 : exponents[1] > 0 ? 1 : 2;
    --exponents[axis];
    return known_.emplace(monomial, turned_[axis] * (*this)(Monomial(exponents))).first->second;
  }
  void forget_below(int degree) {
    std::erase_if(known_, [degree](const auto& entry) { return entry.first.degree() < degree; });
  }

 private:
  std::array<Polynomial, 3> turned_;
  std::map<Monomial, Polynomial> known_;
};

// q.q in variables first .. first+3
Polynomial squared_norm(int first) {
  Polynomial sum;
  for (int i = 0; i < 4; ++i) sum += Polynomial::variable(first + i).power(2);
  return sum;
}

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

// T K^-2 T^T = scale K^-2; K^-2 up to a common factor.
template <class T>
void require_orthogonal(int degree, const Matrix<T>& t, const T& scale) {
  const int size = 2 * degree + 1;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j) {
      T sum = T();
      for (int k = 0; k < size; ++k) sum = sum + cln::recip(squared_factor(degree, k - degree)) * (t(i, k) * t(j, k));
      const T expected = i == j ? T(cln::recip(squared_factor(degree, i - degree)) * scale) : T();
      if (!(sum == expected)) throw Refuted(entry_name(degree, i, j) + " of D D^T is wrong");
    }
  }
}

// Both matrices of a band are the same. Returns the number of bands, which is 1.
template <class T>
int require_same(int degree, const Matrix<T>& first, const Matrix<T>& second, const std::string& otherwise) {
  for (int i = 0; i < first.rows(); ++i) {
    for (int j = 0; j < first.columns(); ++j) {
      if (!(first(i, j) == second(i, j))) throw Refuted(entry_name(degree, i, j) + ": " + otherwise);
    }
  }
  return 1;
}

// A polynomial in cos, sin of an angle as a homogeneous one of degree 2l in those of the half angle (variables 0, 1).
Polynomial at_half_angle(const Polynomial& p, int degree) {
  const Polynomial c = Polynomial::variable(0);
  const Polynomial s = Polynomial::variable(1);
  const std::array<Polynomial, 2> doubled{c * c - s * s, cln::cl_RA(2) * (c * s)};
  std::map<int, Polynomial> by_degree;
  for (const auto& [monomial, coefficient] : p.terms()) by_degree[monomial.degree()].add_term(monomial, coefficient);
  Polynomial result;
  for (const auto& [part_degree, part] : by_degree) {
    result += (c * c + s * s).power(degree - part_degree) * substitute(part, doubled);
  }
  return result;
}

Matrix<Polynomial> about_axis(const QuaternionRotation& band, int axis) {
  std::array<Polynomial, 4> q{Polynomial::variable(0), Polynomial(), Polynomial(), Polynomial()};
  q[axis + 1] = Polynomial::variable(1);
  return band.entries.mapped([&](const Polynomial& p) { return substitute(p, q); });
}

}  // namespace

std::vector<QuaternionRotation> derive_quaternion_rotations(int degree) {
  std::vector<QuaternionRotation> bands;
  for (int l = 0; l <= degree; ++l) bands.push_back(quaternion_rotation(l));
  return bands;
}

int prove_equivariance(const std::vector<QuaternionRotation>& bands, const Basis& basis) {
  TurnedMonomials turned;
  for (const QuaternionRotation& band : bands) {
    const int l = band.degree;
    std::vector<Polynomial> right;  // S_ln(v)
    for (int n = 0; n <= 2 * l; ++n) right.push_back(moved(basis.at(l * l + n).homogeneous, 4));
    for (int m = 0; m <= 2 * l; ++m) {
      Polynomial difference;
      for (const auto& [monomial, coefficient] : basis.at(l * l + m).homogeneous.terms()) {
        difference += coefficient * turned(monomial);
      }
      for (int n = 0; n <= 2 * l; ++n) difference -= band.entries(m, n) * right[n];
      if (!difference.is_zero()) throw Refuted("l=" + std::to_string(l) + " m=" + std::to_string(m - l));
    }
    turned.forget_below(l);
  }
  return static_cast<int>(bands.size());
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
  int count = 0;
  for (const QuaternionRotation& band : bands) {
    const Matrix<Polynomial> t_b = band.entries.mapped([&](const Polynomial& p) { return substitute(p, b); });
    const Matrix<Polynomial> t_ab = band.entries.mapped([&](const Polynomial& p) { return substitute(p, ab); });
    count += require_same(band.degree, band.entries * t_b, t_ab, "T(a) T(b) differs from T(ab)");
  }
  return count;
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

int prove_about_z(const QuaternionRotation& band, const Matrix<Polynomial>& z) {
  const auto half = z.mapped([&](const Polynomial& p) { return at_half_angle(p, band.degree); });
  return require_same(band.degree, about_axis(band, 2), half,
                      "the closed form about z differs from the quaternion form");
}

int prove_about_y(const QuaternionRotation& band, const Matrix<Polynomial>& y) {
  return require_same(band.degree, about_axis(band, 1), y, "the turn about y differs from the quaternion form");
}

int prove_wigner_form(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& by_wigner) {
  return require_same(degree, y, by_wigner, "Wigner's formula differs from the definition");
}

int prove_x90(const QuaternionRotation& band, const RationalMatrix& plus, const RationalMatrix& minus) {
  const cln::cl_RA norm = cln::expt(cln::cl_RA(2), band.degree);
  const RationalMatrix scaled =
      evaluate(band, {1, 1, 0, 0}).mapped([&](const cln::cl_RA& entry) -> cln::cl_RA { return entry / norm; });
  const auto one = RationalMatrix::identity(plus.rows(), 1);
  require_same(band.degree, plus, scaled, "differs from the quaternion form at (1,1,0,0)");
  require_same(band.degree, plus * minus, one, "+90 and -90 degrees are not inverse");
  return require_same(band.degree, plus * plus * plus * plus, one, "four quarter turns are not the identity");
}

int prove_z_x90_z(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& z, const RationalMatrix& plus,
                  const RationalMatrix& minus) {
  const auto constant = [](const cln::cl_RA& entry) { return Polynomial(entry); };
  const auto middle = z.mapped([&](const Polynomial& p) { return at_half_angle(p, degree); });
  return require_same(degree, y, minus.mapped(constant) * middle * plus.mapped(constant),
                      "Ry(beta) differs from Rx(-90) Rz(beta) Rx(90)");
}

}  // namespace sh::symbolic
