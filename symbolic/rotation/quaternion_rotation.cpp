#include "symbolic/rotation/quaternion_rotation.hpp"

#include <cln/integer.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "symbolic/basis/normalisation.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic {
namespace {

struct ComplexPolynomial {
  Polynomial re;
  Polynomial im;
};

ComplexPolynomial operator*(const ComplexPolynomial& a, const ComplexPolynomial& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

ComplexPolynomial conjugate(const ComplexPolynomial& a) { return {a.re, cln::cl_RA(-1) * a.im}; }

// u^i conj(u)^j for i + j <= 2l.
class MixedPowers {
 public:
  MixedPowers(const ComplexPolynomial& base, int highest) {
    const ComplexPolynomial conjugated = conjugate(base);
    powers_.resize(static_cast<std::size_t>(highest) + 1);
    ComplexPolynomial plain{Polynomial(1), Polynomial()};
    for (int i = 0; i <= highest; ++i) {
      auto& row = powers_[static_cast<std::size_t>(i)];
      row.push_back(plain);
      for (int j = 1; i + j <= highest; ++j) row.push_back(row.back() * conjugated);
      plain = plain * base;
    }
  }
  const ComplexPolynomial& operator()(int i, int j) const {
    return powers_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }

 private:
  std::vector<std::vector<ComplexPolynomial>> powers_;
};

cln::cl_I binomial(int n, int k) { return cln::binomial(static_cast<unsigned>(n), static_cast<unsigned>(k)); }

// Z_m(M v) = sum_n U_mn Z_n(v) for the complex solid harmonics Z_m, Z_-m = Re +- i Im of the same function:
// U_mn = e_n (l+|m|)! / (e_m (l+|n|)!) [s1^(l-m) s2^(l+m)] (conj(a) s1 + b s2)^(l-n) (-conj(b) s1 + a s2)^(l+n),
// where e_m = (-1)^m for m > 0, else 1.
ComplexPolynomial complex_entry(int l, int m, int n, const MixedPowers& a, const MixedPowers& b) {
  ComplexPolynomial sum;
  for (int k = std::max(0, m - n); k <= std::min(l - n, l + m); ++k) {
    const int conjugate_power = n - m + k;
    const ComplexPolynomial term = a(l + m - k, l - n - k) * b(k, conjugate_power);
    const cln::cl_RA weight = binomial(l - n, k) * binomial(l + n, l + m - k) * (conjugate_power % 2 == 0 ? 1 : -1);
    sum.re += weight * term.re;
    sum.im += weight * term.im;
  }
  const int sign = ((m > 0 ? m : 0) + (n > 0 ? n : 0)) % 2 == 0 ? 1 : -1;
  const cln::cl_RA scale = sign * cln::factorial(static_cast<unsigned>(l + std::abs(m))) /
                           cln::cl_RA(cln::factorial(static_cast<unsigned>(l + std::abs(n))));
  return {scale * sum.re, scale * sum.im};
}

// Rows m and -m of T from row m >= 0 of U, by Z_n = S_n + i S_-n.
void fill_rows(int l, int m, const MixedPowers& a, const MixedPowers& b, Matrix<Polynomial>& t) {
  const ComplexPolynomial middle = complex_entry(l, m, 0, a, b);
  t(l + m, l) = middle.re;
  if (m > 0) t(l - m, l) = middle.im;
  for (int n = 1; n <= l; ++n) {
    const ComplexPolynomial plus = complex_entry(l, m, n, a, b);
    const ComplexPolynomial minus = complex_entry(l, m, -n, a, b);
    t(l + m, l + n) = plus.re + minus.re;
    t(l + m, l - n) = minus.im - plus.im;
    if (m == 0) continue;
    t(l - m, l + n) = plus.im + minus.im;
    t(l - m, l - n) = plus.re - minus.re;
  }
}

}  // namespace

QuaternionRotation quaternion_rotation(int degree) {
  if (degree < 0 || degree > kMaxQuaternionDegree) {
    throw std::invalid_argument("quaternion rotation: degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(kMaxQuaternionDegree) +
                                " (beyond, the expanded polynomials outgrow their use; the recursion goes on)");
  }
  const Polynomial w = Polynomial::variable(0);
  const Polynomial x = Polynomial::variable(1);
  const Polynomial y = Polynomial::variable(2);
  const Polynomial z = Polynomial::variable(3);
  const MixedPowers a({w, z}, 2 * degree);
  const MixedPowers b({cln::cl_RA(-1) * y, x}, 2 * degree);
  QuaternionRotation result{degree, Matrix<Polynomial>(2 * degree + 1, 2 * degree + 1)};
  for (int m = 0; m <= degree; ++m) fill_rows(degree, m, a, b, result.entries);
  return result;
}

Matrix<Polynomial> quaternion_matrix() {
  return matrix_from_quaternion<Polynomial>(
      {Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2), Polynomial::variable(3)});
}

Matrix<cln::cl_RA> evaluate(const QuaternionRotation& rotation, const std::array<cln::cl_RA, 4>& q) {
  const int size = rotation.entries.rows();
  Matrix<cln::cl_RA> result(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) result(i, j) = rotation.entries(i, j).evaluate(q);
  }
  return result;
}

Matrix<Surd> surd_entries(int degree, const Matrix<cln::cl_RA>& rational) {
  Matrix<Surd> result(rational.rows(), rational.columns());
  for (int i = 0; i < rational.rows(); ++i) {
    for (int j = 0; j < rational.columns(); ++j) {
      result(i, j) = factor_ratio(degree, i - degree, j - degree) * Surd(rational(i, j));
    }
  }
  return result;
}

}  // namespace sh::symbolic
